#include "transpiler/dialects/technol/lowering/routine_writer.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering/conditions.h"
#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/instruction_set.h"
#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"
#include "transpiler/dialects/technol/lowering/schedule.h"
#include "transpiler/dialects/technol/lowering/segments.h"
#include "transpiler/dialects/technol/lowering/statement_writer.h"

namespace plcxx::technol {

using ir::Type;

std::string RoutineWriter::CommentOf(const Routine& routine) const {
  if (!routine.unit.valid()) return "Subprogram.";
  const Unit& unit = tree_.units[routine.unit];
  if (unit.kind == UnitKind::kMechanism) return "Mechanism " + unit.name + ": goes on where it waits.";
  switch (unit.module) {
    case ModuleKind::kInit:
      return "Once at power-on.";
    case ModuleKind::kMain:
      return "The continuous branch: in every slow pass.";
    case ModuleKind::kFast:
      return "In every fast period.";
    case ModuleKind::kClear:
      return "Once for every annulment.";
    case ModuleKind::kHalt:
      return "While REQ_PIS_HALT is 1.";
    case ModuleKind::kPripravne:
      return "Preparatory functions: from the start of a block to their end.";
    case ModuleKind::kZaverecne:
      return "Closing functions: from the end of a block's motion to their end.";
    case ModuleKind::kOther:
      break;
  }
  return "Unknown to the control's scheduler: for the host to call.";
}

void RoutineWriter::AddRoutines() {
  for (Routine& routine : routines_.all()) {
    if (routine.unit.valid()) {
      routine.id = AddUnit(routine);
    } else {
      AddSubprograms(routine);
    }
  }
}

/// Which of them is called is a parameter; whether everything is to be left after it is their result.
void RoutineWriter::AddSubprograms(Routine& routine) {
  const LabelId first = flow_.subprograms()[routine.subprograms.front()].label;
  routine.id = builder_.AddRoutine(tree_.labels[first].name, ir::RoutineKind::kSubroutine, CommentOf(routine));
  ir::Routine& added = program_.routines[routine.id];
  if (routine.subprograms.size() > 1) {
    const Type type = routine.subprograms.size() <= 0x100 ? Type::kI8 : Type::kI32;
    routine.entry = locals_.AddShared("entry", type);
    added.parameters.push_back({.name = "entry", .type = type, .enumerators = {}});
    added.parameter_places.push_back(routine.entry);
  }
  if (routine.leaves) {
    added.result = Type::kBit;
    added.result_place = locals_("left", Type::kBit);
  }
}

ir::RoutineId RoutineWriter::AddUnit(const Routine& routine) {
  using Kind = ir::RoutineKind;
  const Unit& unit = tree_.units[routine.unit];
  if (unit.kind == UnitKind::kMechanism) {
    mechanisms_.Activation(routine.unit);  // scenarios name it, whether the program does or not
    return builder_.AddRoutine("mech_" + unit.name, Kind::kSubroutine, CommentOf(routine));
  }
  if (unit.module == ModuleKind::kInit) return schedule_.init();
  if (unit.module == ModuleKind::kFast) return schedule_.fast();
  if (unit.module != ModuleKind::kOther) {
    return builder_.AddRoutine(unit.name, Kind::kSubroutine, CommentOf(routine));
  }
  std::string name = unit.name;
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return builder_.AddRoutine(std::move(name), Kind::kInterrupt, CommentOf(routine));
}

void RoutineWriter::Begin() {
  const Routine& routine = *frame_.routine;
  builder_.SetRegion(program_.routines[routine.id].body);
  builder_.SetRange({});
  // Its pass may set the bit again that the host has cleared since the pass before.
  if (routine.unit.valid() && tree_.units[routine.unit].module == ModuleKind::kFast) schedule_.BeginFast();
  registers_.Begin([this](std::string_view name, Type type) { return locals_(name, type); });
  if (routine.unit.valid()) {
    registers_.Zero();
    if (routine.loops) {
      builder_.Store(locals_("rounds_left", Type::kI32), builder_.Number(settings_.loop_limit));
    }
  } else if (routine.leaves) {
    builder_.Store(locals_("left", Type::kBit), builder_.Bit(0));
  }
  segments_.Begin();
}

void RoutineWriter::FindLabels() {
  const Routine& routine = *frame_.routine;
  const std::vector<InstructionId>& instructions = routine.instructions;
  label_at_.assign(instructions.size(), false);
  const auto mark = [&](InstructionId id) {
    const auto at = std::ranges::lower_bound(instructions, id);
    label_at_[static_cast<size_t>(at - instructions.begin())] = true;
  };
  for (const InstructionId id : instructions) {
    flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge == Edge::kJump) mark(to);
    });
  }
  for (const InstructionId entry : routine.entries) {
    if (!routine.segments_are_cases) mark(entry);
  }
  for (const uint32_t k : routine.subprograms) {
    if (routine.subprograms.size() > 1 || flow_.EntryOf(k) != instructions.front()) mark(flow_.EntryOf(k));
  }
}

/// Is it the first unit in its file with an opening line of its own, where the comments at the head of the file are
/// shown?
bool RoutineWriter::BeginsFile(UnitId id) const {
  for (uint32_t i = 0; i < id.index; ++i) {
    const Unit& unit = tree_.units[UnitId(i)];
    if (ShowsOpening(unit) && unit.file == tree_.units[id].file) return false;
  }
  return true;
}

/// The opening line of a mechanism inside a module is one of the module's.
bool RoutineWriter::ShowsOpening(const Unit& unit) {
  return unit.kind == UnitKind::kModule || (unit.kind == UnitKind::kMechanism && !unit.parent.valid());
}

const SourceFile& RoutineWriter::FileOf(const Unit& unit) const {
  return *std::ranges::find(tree_.files, unit.file, &SourceFile::file);
}

void RoutineWriter::Lower(const Routine& routine) {
  frame_.routine = &routine;
  exits_.BeginRoutine();
  locals_.BeginRoutine();
  Begin();
  FindLabels();
  statements_.Cut(label_at_);
  if (routine.unit.valid() && ShowsOpening(tree_.units[routine.unit])) {
    const Unit& unit = tree_.units[routine.unit];
    if (BeginsFile(routine.unit)) statements_.AddComments(FileOf(unit).header);
    const bool is_module = unit.kind == UnitKind::kModule;
    statements_.AddComments(is_module ? unit.comments : tree_.instructions[unit.first].comments);
    statements_.AddLines(unit.open);
  }
  for (size_t i = 0; i < routine.instructions.size(); ++i) Execute(i);
  statements_.End();
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[routine.id].body);
  exits_.BindEnd();
}

void RoutineWriter::Execute(size_t index) {
  const InstructionId id = frame_.routine->instructions[index];
  const Instruction& instruction = tree_.instructions[id];
  frame_.now = id;
  frame_.width = flow_.WidthBefore(id) == 0 ? 16 : flow_.WidthBefore(id);
  frame_.wanted_flags = flow_.LiveBehind(id) & kFlags;
  const Effects effects = EffectsOf(tree_, instruction, frame_.width);
  segments_.Enter(id);
  if (label_at_[index]) {
    registers_.Spill();
    builder_.Label(id.index + 1);
    registers_.Forget();
  }
  const bool ends_module = instruction.op == Op::kModuleEnd && !Info(tree_.units[frame_.routine->unit].module).waits;
  if (ends_module) {
    statements_.AddComments(instruction.comments);
    return statements_.AddTrailingComments(instruction.comments);
  }
  if (statements_.BeginsAt(index)) {  // as each label does
    registers_.EndStatement();
    conditions_.Forget();
    statements_.Begin(index);
  }
  builder_.SetRange(instruction.range);
  if (((effects.writes | effects.undefines) & kFlags) != 0) conditions_.Forget();
  // What jumps takes undefined flags along; assembler instructions read some that they leave undefined.
  const bool assembler = Info(instruction.op).assembler;
  if (!assembler) flags_.Undefine(effects.undefines);
  instructions_.Lower(instruction);
  if (assembler) flags_.Undefine(effects.undefines);
}

}  // namespace plcxx::technol
