#include "transpiler/ir/printer.h"

#include <algorithm>

#include "transpiler/ir/printer_state.h"
#include "transpiler/ir/text_format.h"

namespace plcxx::ir {
namespace {

constexpr uint32_t kNone = support::Id<void>::kNone;

struct RoutinePrinter {
  Printer& printer;
  const Program& program;
  std::string& out;
  /// A value is named by the statement whose marker stood last before it, and a number that starts there.
  std::vector<uint32_t>& number_of;     // by InstId
  std::vector<uint32_t>& statement_of;  // by InstId; statements.size() is "before the first marker"
  std::vector<uint32_t>& next_number;   // by statement
  uint32_t statement;
  uint32_t indent = 1;
  std::vector<InstId> enclosing;  // blocks and loops

  std::string Value(uint32_t word) const;
  std::string Label(uint32_t inst) const;
  std::string Access(uint32_t place, uint32_t index) const;
  std::string Operands(const Inst& inst) const;
  std::string Arguments(const Call& call) const;
  void Begin() { out.append(2 * indent, ' '); }
  void Open(std::string_view head);
  void Nested(RegionId region);
  void PrintIf(const Inst& inst);
  void PrintSwitch(const Inst& inst);
  void PrintLoop(InstId id, const Inst& inst);
  void PrintBlock(InstId id, const Inst& inst);
  void PrintInst(InstId id);
  void PrintRegion(RegionId region);
  void PrintSection(std::string_view name, RegionId region);
  void PrintPart(std::string_view name, RegionId region);
};

std::string RoutinePrinter::Value(uint32_t word) const {
  if (word >= number_of.size() || number_of[word] == kNone) return "%?";
  std::string name = "%";
  if (statement_of[word] != statement) {
    name += statement_of[word] < printer.statements.size() ? printer.statements[statement_of[word]] : "entry";
    name += '.';
  }
  return name + std::to_string(number_of[word]);
}

std::string RoutinePrinter::Label(uint32_t inst) const {
  for (size_t depth = enclosing.size(); depth > 0; --depth) {
    if (enclosing[depth - 1].index == inst) return '@' + std::to_string(depth);
  }
  return "@?";
}

std::string RoutinePrinter::Access(uint32_t place, uint32_t index) const {
  std::string name = printer.PlaceName(PlaceId(place));
  return index == kNone ? name : name + '[' + Value(index) + ']';
}

std::string RoutinePrinter::Operands(const Inst& inst) const {
  std::string list;
  for (const uint32_t word : {inst.a, inst.b, inst.c}) {
    if (word != kNone) list += ' ' + Value(word);
  }
  return list;
}

std::string RoutinePrinter::Arguments(const Call& call) const {
  std::string list = " (";
  for (size_t i = 0; i < call.arguments.size(); ++i) list += (i == 0 ? "" : ", ") + Value(call.arguments[i].index);
  list += ')';
  if (call.out.valid()) list += " out " + printer.PlaceName(call.out);
  if (call.exchange) list += " exchange";
  return list + '\n';
}

void RoutinePrinter::Open(std::string_view head) {
  Begin();
  out += head;
  out += " {\n";
}

/// The lines of a region and the closing brace, without its line end.
void RoutinePrinter::Nested(RegionId region) {
  ++indent;
  PrintRegion(region);
  --indent;
  Begin();
  out += '}';
}

void RoutinePrinter::PrintSection(std::string_view name, RegionId region) {
  if (!region.valid()) return;
  Open(name);
  Nested(region);
  out += '\n';
}

/// A part of a routine: no statement's value reaches from one part into another.
void RoutinePrinter::PrintPart(std::string_view name, RegionId region) {
  statement = static_cast<uint32_t>(next_number.size() - 1);
  next_number.back() = 0;
  PrintSection(name, region);
}

void RoutinePrinter::PrintIf(const Inst& inst) {
  out += "if " + Value(inst.a);
  switch (static_cast<IfOrigin>(inst.payload)) {
    case IfOrigin::kSource:
      break;
    case IfOrigin::kJumps:
      out += " jumps";
      break;
    case IfOrigin::kStays:
      out += " stays";
      break;
  }
  out += " {\n";
  Nested(RegionId(inst.b));
  if (RegionId(inst.c).valid()) {
    out += " else {\n";
    Nested(RegionId(inst.c));
  }
  out += '\n';
}

void RoutinePrinter::PrintSwitch(const Inst& inst) {
  out += "switch " + Value(inst.a) + " {\n";
  ++indent;
  for (const SwitchCase& arm : program.switches[SwitchId(inst.payload)].cases) {
    std::string head = arm.values.empty() ? "default" : "case";
    for (size_t i = 0; i < arm.values.size(); ++i) head += ' ' + text::Spelled(arm.values[i], arm.Base(i));
    PrintSection(arm.falls_through ? head + " falls_through" : head, arm.region);
  }
  --indent;
  Begin();
  out += "}\n";
}

void RoutinePrinter::PrintLoop(InstId id, const Inst& inst) {
  const Loop& loop = program.loops[LoopId(inst.payload)];
  enclosing.push_back(id);
  out += "loop " + Label(id.index) + ' ' + std::string(text::kBounds[static_cast<size_t>(loop.kind)]) + ' ' +
         std::to_string(loop.bound);
  if (loop.budget.valid()) out += ' ' + printer.PlaceName(loop.budget);
  out += " {\n";
  ++indent;
  PrintSection("condition", loop.condition);
  PrintSection("body", loop.body);
  PrintSection("step", loop.step);
  PrintSection("exhausted", loop.exhausted);
  --indent;
  enclosing.pop_back();
  Begin();
  out += "}\n";
}

void RoutinePrinter::PrintBlock(InstId id, const Inst& inst) {
  enclosing.push_back(id);
  out += "block " + Label(id.index) + " {\n";
  Nested(RegionId(inst.a));
  out += '\n';
  enclosing.pop_back();
}

void RoutinePrinter::PrintInst(InstId id) {
  const Inst& inst = program[id];
  const OpInfo& info = Info(inst.op);
  if (info.shape == Shape::kStatement) {
    statement = std::min(inst.payload, static_cast<uint32_t>(next_number.size() - 1));
  }
  Begin();
  if (inst.type != Type::kNone) {
    statement_of[id.index] = statement;
    number_of[id.index] = next_number[statement]++;
    out += Value(id.index) + " = ";
  }
  const std::string op(info.text);
  switch (info.shape) {
    case Shape::kPure:
      out += op + Operands(inst) + '\n';
      break;
    case Shape::kStep:
      out += op + ' ' + printer.states[inst.payload] + Operands(inst) + '\n';
      break;
    case Shape::kConst: {
      out += op + ' ' + std::string(Name(inst.type));
      const uint64_t value = ConstantValue(inst);
      if (inst.op == OpKind::kConst) out += ' ' + text::Spelled(value, inst.c);
      out += '\n';
      break;
    }
    case Shape::kLoad:
      out += op + ' ' + Access(inst.payload, inst.a) + '\n';
      break;
    case Shape::kStore:
      out += op + ' ' + Access(inst.payload, inst.b) + ' ' + Value(inst.a) + '\n';
      break;
    case Shape::kText:
      out += op + ' ' + printer.states[inst.payload] + ' ' + printer.states[inst.a] + ' ' +
             text::Quoted(program.texts[TextId(inst.b)]) + '\n';
      break;
    case Shape::kStatement: {
      const bool known = inst.payload < printer.statements.size();
      out += op + ' ' + (known ? printer.statements[inst.payload] : "s?");
      // The subject is a comment: names of machines may hold anything, so that line ends must not get through.
      if (known && !program.statements[StatementId(inst.payload)].subject.empty()) {
        out += " ; " + text::Word(program.statements[StatementId(inst.payload)].subject);
      }
      out += '\n';
      break;
    }
    case Shape::kExit:
    case Shape::kRepeat:
    case Shape::kJump:
      out += op + ' ' + (info.shape == Shape::kJump ? 'L' + std::to_string(inst.payload) : Label(inst.payload));
      if (inst.a != kNone) out += " if " + Value(inst.a);
      if (info.shape == Shape::kJump && inst.c != kNone) out += " budget " + printer.PlaceName(PlaceId(inst.c));
      if (info.shape != Shape::kExit && RegionId(inst.b).valid()) {
        out += " refused {\n";
        Nested(RegionId(inst.b));
      }
      out += '\n';
      break;
    case Shape::kLabel:
      out += op + " L" + std::to_string(inst.payload) + '\n';
      break;
    case Shape::kCall: {
      const Call& call = program.calls[CallId(inst.payload)];
      out += op + ' ' + printer.routines[call.routine.index] + Arguments(call);
      break;
    }
    case Shape::kHostCall: {
      const Call& call = program.calls[CallId(inst.payload)];
      out += op + ' ' + printer.host_functions[call.host.index] + Arguments(call);
      break;
    }
    case Shape::kIf:
      PrintIf(inst);
      break;
    case Shape::kSwitch:
      PrintSwitch(inst);
      break;
    case Shape::kLoop:
      PrintLoop(id, inst);
      break;
    case Shape::kBlock:
      PrintBlock(id, inst);
      break;
  }
}

void RoutinePrinter::PrintRegion(RegionId region) {
  if (!region.valid()) return;
  for (const InstId id : program.regions[region].insts) PrintInst(id);
}

std::string HeadOf(const Printer& printer, uint32_t index) {
  const Routine& routine = printer.program.routines[RoutineId(index)];
  std::string head = "routine " + printer.routines[index] + ' ';
  head += text::kRoutineKinds[static_cast<size_t>(routine.kind)];
  if (!routine.parameters.empty()) head += " (";
  for (size_t i = 0; i < routine.parameters.size(); ++i) {
    const Parameter& parameter = routine.parameters[i];
    head += (i == 0 ? "" : ", ") + text::Word(parameter.name) + " : " + std::string(Name(parameter.type));
    if (i < routine.parameter_places.size()) head += " = " + printer.PlaceName(routine.parameter_places[i]);
  }
  if (!routine.parameters.empty()) head += ')';
  if (routine.result != Type::kNone) {
    head += " -> " + std::string(Name(routine.result)) + ' ' + printer.PlaceName(routine.result_place);
  }
  if (routine.sliced) head += " sliced";
  if (routine.slices != 1) head += " slices " + std::to_string(routine.slices);
  if (routine.simulation_only) head += " simulation_only";
  if (printer.routines[index] != text::Word(routine.name)) head += " named " + text::Word(routine.name);
  if (!routine.file_comment.empty()) head += " file " + text::Quoted(routine.file_comment);
  if (!routine.comment.empty()) head += ' ' + text::Quoted(routine.comment);
  return head + " {\n";
}

}  // namespace

void Printer::PrintRoutines() {
  std::vector<uint32_t> number_of(program.insts.size(), kNone), statement_of(program.insts.size(), kNone);
  std::vector<uint32_t> next_number(statements.size() + 1);
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const Routine& routine = program.routines[RoutineId(i)];
    out += HeadOf(*this, i);
    RoutinePrinter body{.printer = *this,
                        .program = program,
                        .out = out,
                        .number_of = number_of,
                        .statement_of = statement_of,
                        .next_number = next_number,
                        .statement = static_cast<uint32_t>(statements.size())};
    if (routine.prologue.valid() || routine.epilogue.valid()) {
      body.PrintPart("prologue", routine.prologue);
      body.PrintPart("body", routine.body);
      body.PrintPart("epilogue", routine.epilogue);
    } else {
      next_number.back() = 0;
      body.PrintRegion(routine.body);
    }
    out += "}\n";
  }
}

std::string Print(const Program& program) {
  Printer printer(program);
  printer.PrintDeclarations();
  printer.PrintRoutines();
  printer.PrintSchedule();
  return std::move(printer.out);
}

}  // namespace plcxx::ir
