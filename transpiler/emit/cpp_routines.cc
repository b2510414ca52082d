// One .cpp file: what it includes and declares, chunks, routines.

#include <algorithm>

#include "transpiler/emit/part_printer.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::emit {

void PartPrinter::OpenFunction(const std::string& head, std::vector<std::string> parameters) {
  function_head_ = head;
  parameters_ = std::move(parameters);
  body_begin_ = out_.size();
  numbers_.clear();
  indent_ = 1;
  return_ = "return;";
}

void PartPrinter::CloseFunction() {
  const std::string_view body = std::string_view(out_).substr(body_begin_);
  // A parameter that the body does not name must not be a warning: it gets no name.
  const auto named = [body](std::string_view name) {
    for (size_t line = 0; line < body.size();) {
      const size_t end = std::min(body.find('\n', line), body.size());
      const std::string_view text = body.substr(line, end - line);
      line = end + 1;
      if (text.find_first_not_of(' ') != std::string_view::npos &&
          text.substr(text.find_first_not_of(' ')).starts_with("//"))
        continue;
      for (size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        const auto letter = [](char c) {
          return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        };
        const bool begins = at == 0 || !letter(text[at - 1]);
        const bool ends = at + name.size() == text.size() || !letter(text[at + name.size()]);
        if (begins && ends) return true;
      }
    }
    return false;
  };
  std::string head = function_head_ + "(";
  for (size_t i = 0; i < parameters_.size(); ++i) {
    const size_t blank = parameters_[i].rfind(' ');
    head += (i == 0 ? "" : ", ") +
            (named(parameters_[i].substr(blank + 1)) ? parameters_[i] : parameters_[i].substr(0, blank));
  }
  head += ") noexcept {\n";
  out_.insert(body_begin_, head);
  for (auto owner = owners_.rbegin(); owner != owners_.rend() && owner->offset >= body_begin_; ++owner) {
    owner->offset += head.size();
  }
  Own({});
  out_ += "}\n\n";
  indent_ = 0;
}

std::vector<std::string> PartPrinter::Parameters(const Locals& locals) const {
  std::vector<std::string> parameters = {"State& m"};
  for (const ir::PlaceId place : locals.values) {
    parameters.push_back(std::string(ir::CppName(program_.places[place].type)) + " " +
                         emittable_.place_names[place.index]);
  }
  for (const ir::PlaceId place : locals.shared) {
    parameters.push_back(std::string(ir::CppName(program_.places[place].type)) + "& " +
                         emittable_.place_names[place.index]);
  }
  parameters.emplace_back("Host& host");
  return parameters;
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
  for (const std::string& parameter : Parameters(locals)) text += (text.back() == '(' ? "" : ", ") + parameter;
  return text + ") noexcept;\n";
}

/// What stands before the type of a routine. A subroutine of a program in one file is nobody else's. One that a slice
/// calls stays a function, as the chunks of slices do.
std::string PartPrinter::Linkage(ir::RoutineId id, const std::vector<bool>& called) const {
  const std::string whole = emittable_.called_by_slice[id.index] ? "[[gnu::noinline]] " : "";
  if (emittable_.parts.size() > 1 || !SharesLocals(program_.routines[id].kind)) return whole;
  return whole + (called[id.index] ? "static " : "[[maybe_unused]] static ");
}

void PartPrinter::Routine(ir::RoutineId id, const std::vector<bool>& called) {
  const ir::Routine& routine = program_.routines[id];
  const Locals& locals = emittable_.routine_locals[id.index];
  if (!routine.comment.empty()) Comment(routine.comment);
  OpenFunction(
      Linkage(id, called) + std::string(ir::CppName(routine.result)) + " " + emittable_.routine_names[id.index],
      Parameters(locals));
  if (routine.result_place.valid()) return_ = "return " + emittable_.place_names[routine.result_place.index] + ";";
  for (const Locals::Declared& local : locals.declared) {
    const ir::Type type = program_.places[local.place].type;
    Line((local.read ? "" : "[[maybe_unused]] ") + std::string(ir::CppName(type)) + " " +
         emittable_.place_names[local.place.index] + " = " + ConstantText(type, 0) + ";");
  }
  if (routine.kind == ir::RoutineKind::kInit) InitStorage();
  // What the control does before and after the statements stands apart from them.
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid() || program_.regions[region].insts.empty()) continue;
    if (out_.size() > body_begin_) out_ += '\n';
    statement_ = {};
    RegionBody(region);
  }
  if (routine.result_place.valid()) Line(return_);
  CloseFunction();
}

/// Each behind what was cut out of it: where a routine grows beyond one function, its text stays where it is.
void PartPrinter::Routines(const std::vector<bool>& called) {
  size_t chunk = 0;
  for (uint32_t i = 0; i < program_.routines.size(); ++i) {
    const ir::RoutineId id(i);
    const bool printed = IsPrinted(id);
    for (; chunk < emittable_.chunks.size() && emittable_.chunks[chunk].routine == id; ++chunk)
      if (printed && emittable_.chunks[chunk].part == part_) PrintChunk(emittable_.chunks[chunk]);
    if (printed && emittable_.routine_parts[i] == part_) Routine(id, called);
  }
}

/// A chunk is its region's items; called from one place, it would be inlined into one huge function again.
void PartPrinter::PrintChunk(const Chunk& chunk) {
  OpenFunction("[[gnu::noinline]] static void " + chunk.name, Parameters(chunk.locals));
  Range(chunk.region, chunk.begin, chunk.end);
  CloseFunction();
}

void PartPrinter::Runs() {
  for (const ChunkRun& run : emittable_.runs) {
    if (run.part != part_) continue;
    out_ += Prototype("void " + run.name, run.locals);
    OpenFunction("void " + run.name, Parameters(run.locals));
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

bool PartPrinter::IsPrinted(ir::RoutineId id) const { return debug() || !program_.routines[id].simulation_only; }

/// The subroutines that this file calls, by RoutineId.
std::vector<bool> PartPrinter::CalledSubroutines() const {
  std::vector<bool> called(program_.routines.size());
  const auto note = [this, &called](ir::InstId id) {
    const ir::Inst& inst = program_[id];
    if (inst.op == ir::OpKind::kCall) called[program_.calls[ir::CallId(inst.payload)].routine.index] = true;
  };
  for (const Chunk& chunk : emittable_.chunks) {
    if (chunk.part == part_ && IsPrinted(chunk.routine)) ForEachHere(chunk.region, chunk.begin, chunk.end, note);
  }
  for (uint32_t i = 0; i < called.size(); ++i) {
    const ir::Routine& routine = program_.routines[ir::RoutineId(i)];
    if (emittable_.routine_parts[i] != part_ || !IsPrinted(ir::RoutineId(i))) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue})
      if (region.valid()) ForEachInPlace(region, note);
  }
  for (uint32_t i = 0; i < called.size(); ++i) {
    called[i] = called[i] && SharesLocals(program_.routines[ir::RoutineId(i)].kind);
  }
  return called;
}

/// The instructions of a stretch that stand in its function: not those that are functions of their own.
void PartPrinter::ForEachHere(ir::RegionId region, uint32_t begin, uint32_t end,
                              const std::function<void(ir::InstId)>& visit) const {
  for (uint32_t i = begin; i < end; ++i) {
    const ir::InstId id = program_.regions[region].insts[i];
    visit(id);
    if (!ir::OwnsRegions(program_[id])) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, program_[id])) ForEachInPlace(owned, visit);
  }
}

void PartPrinter::ForEachInPlace(ir::RegionId region, const std::function<void(ir::InstId)>& visit) const {
  uint32_t at = 0;
  for (const uint32_t index : emittable_.region_chunks[region.index]) {
    ForEachHere(region, at, emittable_.chunks[index].begin, visit);
    at = emittable_.chunks[index].end;
  }
  ForEachHere(region, at, static_cast<uint32_t>(program_.regions[region].insts.size()), visit);
}

/// Subroutines that are called here before they are defined, or elsewhere; and what the partitions call of other files.
void PartPrinter::Declarations(const std::vector<bool>& called) {
  const size_t before = out_.size();
  const bool one_file = emittable_.parts.size() == 1;
  for (uint32_t i = 0; i < called.size(); ++i) {
    const ir::RoutineId id(i);
    const bool defined = !one_file && part_ != 0 && emittable_.routine_parts[i] == part_;
    if (!called[i] && !defined) continue;
    const std::string type(ir::CppName(program_.routines[id].result));
    out_ +=
        Prototype((one_file ? "static " : "") + type + " " + emittable_.routine_names[i], emittable_.routine_locals[i]);
  }
  if (part_ == 0) {
    for (const ChunkRun& run : emittable_.runs) out_ += Prototype("void " + run.name, run.locals);
  }
  if (out_.size() > before) out_ += '\n';
}

std::string PartPrinter::Run() {
  Includes();
  out_ += "namespace " + emittable_.namespace_name + " {\n\n";
  Using();
  const std::vector<bool> called = CalledSubroutines();
  Declarations(called);
  if (part_ == 0) {
    for (const Member& member : emittable_.layout.members) {
      out_ += "static_assert(offsetof(State, " + member.name + ") == " + std::to_string(member.offset) +
              ", \"the symbol map holds for this layout\");\n";
    }
    if (!emittable_.layout.members.empty()) out_ += '\n';
  }
  Routines(called);
  Runs();
  out_ += "}  // namespace " + emittable_.namespace_name + "\n";
  return std::move(out_);
}

/// Heads of functions are written behind their bodies, so that lines are known only when all is there.
std::vector<PrintedLoop> PartPrinter::FindLoops(std::string_view text) const {
  std::vector<PrintedLoop> found;
  uint32_t line = 1;
  for (size_t at = 0; at < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view head = text.substr(std::min(text.find_first_not_of(' ', at), end));
    if (head.starts_with("for (") || head.starts_with("while (")) found.push_back({line, std::nullopt});
    at = end + 1;
  }
  if (found.size() != loops_.size()) return {};
  for (size_t i = 0; i < found.size(); ++i) {
    const ir::Loop& loop = program_.loops[loops_[i]];
    if (loop.kind == ir::LoopBound::kBudget) {
      found[i].budget = loop.budget;
    } else {
      found[i].rounds = loop.bound;
    }
  }
  return found;
}

std::vector<LineOwner> PartPrinter::FindOwners(std::string_view text) const {
  std::vector<LineOwner> found;
  uint32_t line = 1;
  size_t at = 0;
  for (const Owner& owner : owners_) {
    line += static_cast<uint32_t>(std::count(text.begin() + at, text.begin() + owner.offset, '\n'));
    at = owner.offset;
    found.push_back({line, owner.statement});
  }
  return found;
}

OutputFile PrintPart(const Emittable& emittable, const source::SourceManager& sources, uint32_t part) {
  PartPrinter printer(emittable, sources, part);
  OutputFile file{emittable.options.name + emittable.parts[part].suffix + ".cpp", printer.Run()};
  file.loops = printer.FindLoops(file.text);
  file.owners = printer.FindOwners(file.text);
  file.locals = printer.locals();
  return file;
}

}  // namespace plcxx::emit
