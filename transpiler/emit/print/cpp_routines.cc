// One .cpp file: what it includes and declares, chunks, routines.

#include <algorithm>

#include "transpiler/emit/print/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::print {

void PartPrinter::OpenFunction(const std::string& head, const Locals& locals, std::vector<Piece> pieces) {
  // A parameter that the body does not use must not be a warning: it gets no name.
  out_ += head + "(";
  for (const Parameter& parameter : locals.parameters) {
    out_ += (&parameter == locals.parameters.data() ? "" : ", ") + parameter.type;
    if (parameter.used) out_ += " " + parameter.name;
  }
  out_ += ") noexcept {\n";
  uses_state_ = locals.parameters.front().used;
  function_ = std::move(pieces);
  spelled_ = {};
  body_begin_ = out_.size();
  last_ = Last::kText;
  indent_ = 1;
  return_ = "return;";
}

void PartPrinter::CloseFunction() {
  spelled_.CheckOnce(emittable_, function_);
  Own({});
  out_ += "}\n\n";
  indent_ = 0;
}

std::string PartPrinter::Arguments(const Locals& locals) const {
  std::string arguments = "m";
  for (const ir::PlaceId place : locals.values) arguments += ", " + emittable_.place_names[place.index];
  for (const ir::PlaceId place : locals.shared) arguments += ", " + emittable_.place_names[place.index];
  return arguments + ", host";
}

/// "void PM17(State& m, bool& s, Host& host) noexcept": declared where it is called, defined in part 0.
std::string PartPrinter::Prototype(const std::string& head, const Locals& locals) const {
  std::string text = head + "(";
  for (const Parameter& parameter : locals.parameters)
    text += (text.back() == '(' ? "" : ", ") + parameter.type + " " + parameter.name;
  return text + ") noexcept;\n";
}

/// What stands before the type of a routine. A subroutine of a program in one file is nobody else's. One that a slice
/// calls stays a function, as the chunks of slices do.
std::string PartPrinter::Linkage(ir::RoutineId id) const {
  const std::string whole = emittable_.called_by_slice[id.index] ? "[[gnu::noinline]] " : "";
  if (emittable_.parts.size() > 1 || !SharesLocals(program_.routines[id].kind)) return whole;
  return whole + (Calls(id) ? "static " : "[[maybe_unused]] static ");
}

void PartPrinter::Routine(ir::RoutineId id) {
  const ir::Routine& routine = program_.routines[id];
  const Locals& locals = emittable_.routine_locals[id.index];
  if (!routine.file_comment.empty()) {  // a paragraph of its own
    CommentLines(routine.file_comment);
    BlankLine();
  }
  CommentLines(routine.comment);
  OpenFunction(Linkage(id) + std::string(ir::CppName(routine.result)) + " " + emittable_.routine_names[id.index],
               locals, PiecesOf(emittable_, id));
  if (routine.result_place.valid()) return_ = "return " + emittable_.place_names[routine.result_place.index] + ";";
  for (const Locals::Declared& local : locals.declared) {
    const ir::Type type = program_.places[local.place].type;
    const Text value =
        local.first.valid() ? Spelled(Value(program_[local.first].a), local.first) : Text(ConstantText(type, 0));
    Line((local.read ? "" : "[[maybe_unused]] ") + std::string(ir::CppName(type)) + " " +
         emittable_.place_names[local.place.index] + " = " + value + ";");
  }
  if (routine.kind == ir::RoutineKind::kInit) InitStorage();
  // What the control does before and after the statements stands apart from them.
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid() || program_.regions[region].insts.empty()) continue;
    if (out_.size() > body_begin_ && last_ != Last::kBlank) BlankLine();
    statement_ = {};
    RegionBody(region);
  }
  if (emittable_.returns_at_end[id.index]) Line(return_);
  CloseFunction();
}

/// Each after what was cut out of it: where a routine grows beyond one function, its text stays where it is.
void PartPrinter::Routines() {
  size_t chunk = 0;
  for (uint32_t i = 0; i < program_.routines.size(); ++i) {
    const ir::RoutineId id(i);
    const bool printed = IsPrinted(id);
    for (; chunk < emittable_.chunks.size() && emittable_.chunks[chunk].routine == id; ++chunk)
      if (printed && emittable_.chunks[chunk].part == part_) PrintChunk(emittable_.chunks[chunk]);
    if (printed && emittable_.routine_parts[i] == part_) Routine(id);
  }
}

/// A chunk is its region's items; called from one place, it would be inlined into one huge function again.
void PartPrinter::PrintChunk(const Chunk& chunk) {
  OpenFunction("[[gnu::noinline]] static void " + chunk.name, chunk.locals, {PieceOf(chunk)});
  Range(chunk.region, chunk.begin, chunk.end);
  CloseFunction();
}

void PartPrinter::Runs() {
  for (const ChunkRun& run : emittable_.runs) {
    if (run.part != part_) continue;
    out_ += Prototype("void " + run.name, run.locals);
    OpenFunction("void " + run.name, run.locals, {});
    for (const uint32_t index : run.chunks) {
      const Chunk& chunk = emittable_.chunks[index];
      Line(chunk.name + "(" + Arguments(chunk.locals) + ");");
    }
    CloseFunction();
  }
}

void PartPrinter::Includes() {
  const std::string& suffix = emittable_.parts[part_].suffix;
  out_ += "// " + emittable_.options.name + suffix +
          ".cpp: generated by plcxx. Do not edit: change the PLC program and run plcxx again.\n";
  out_ += "#include \"" + emittable_.options.name + ".hpp\"\n\n";
  if (part_ == 0) {
    out_ += "#include <stddef.h>\n\n";
  }
}

void PartPrinter::Using() {
  std::vector<std::string> names = emittable_.functions;
  if (part_ == 0) names.insert(std::upper_bound(names.begin(), names.end(), "Clear"), "Clear");
  for (const std::string& name : names) out_ += "using plcxx::" + name + ";\n";
  if (!names.empty()) out_ += '\n';
}

bool PartPrinter::IsPrinted(ir::RoutineId id) const {
  return emit::IsPrinted(program_.routines[id], emittable_.options);
}

/// Subroutines that are called here before they are defined, or elsewhere; and what the partitions call of other files.
void PartPrinter::Declarations() {
  const size_t before = out_.size();
  const bool one_file = emittable_.parts.size() == 1;
  for (uint32_t i = 0; i < program_.routines.size(); ++i) {
    const ir::RoutineId id(i);
    const bool defined = !one_file && part_ != 0 && emittable_.routine_parts[i] == part_;
    if (!Calls(id) && !defined) continue;
    const std::string type(ir::CppName(program_.routines[id].result));
    out_ +=
        Prototype((one_file ? "static " : "") + type + " " + emittable_.routine_names[i], emittable_.routine_locals[i]);
  }
  if (part_ == 0) {
    for (const ChunkRun& run : emittable_.runs) out_ += Prototype("void " + run.name, run.locals);
  }
  if (out_.size() > before) out_ += '\n';
}

OutputFile PartPrinter::Run() {
  Includes();
  out_ += "namespace " + emittable_.namespace_name + " {\n\n";
  Using();
  Declarations();
  if (part_ == 0) {
    for (const layout::Member& member : emittable_.layout.members) {
      out_ += "static_assert(offsetof(State, " + member.name + ") == " + std::to_string(member.offset) +
              ", \"the symbol map holds for this layout\");\n";
    }
    if (!emittable_.layout.members.empty()) out_ += '\n';
  }
  Routines();
  Runs();
  out_ += "}  // namespace " + emittable_.namespace_name + "\n";
  return {.name = emittable_.options.name + emittable_.parts[part_].suffix + ".cpp",
          .text = out_.Take(),
          .loops = std::move(loops_),
          .owners = std::move(owners_),
          .locals = std::move(local_names_)};
}

OutputFile PrintPart(const Emittable& emittable, const source::SourceManager& sources, uint32_t part) {
  return PartPrinter(emittable, sources, part).Run();
}

}  // namespace plcxx::emit::print
