#include "transpiler/dialects/prostep/lowering/module_writer.h"

#include <string>

#include "transpiler/dialects/prostep/lowering/control.h"
#include "transpiler/dialects/prostep/lowering/instruction_set.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/registers.h"
#include "transpiler/dialects/prostep/lowering/statement_writer.h"

namespace plcxx::prostep {

namespace {

constexpr ir::RoutineKind KindOf(uint32_t module) {
  if (module == 0 || module >= kFirstSubroutine) return ir::RoutineKind::kSubroutine;
  return module < kFirstLoopModule ? ir::RoutineKind::kFast : ir::RoutineKind::kSlow;
}

std::string CommentOf(uint32_t module) {
  const std::string name = "PM " + std::to_string(module);
  if (module == 0) return name + ": initialisation, once after power-on.";
  if (module < kFirstLoopModule)
    return name + ": interrupt module, in every tick while F 250." + std::to_string(module - 1) + " is 1.";
  if (module < kFirstSubroutine) {
    return name + ": loop module, while F 251." + std::to_string(module - kFirstLoopModule) + " is 1.";
  }
  return name + ": subroutine.";
}

}  // namespace

void ModuleWriter::AddRoutines(ir::RoutineId init) {
  for (uint32_t i = 0; i < tree_.modules.size(); ++i) {
    const ModuleId id(i);
    const uint32_t number = tree_.modules[id].number;
    if (number == 0 && !modules_.IsCalled(id)) {
      modules_.RoutineOf(id) = init;  // its instructions are what power-on ends with
      continue;
    }
    const ir::RoutineKind kind = modules_.IsCalled(id) ? ir::RoutineKind::kSubroutine : KindOf(number);
    modules_.RoutineOf(id) = builder_.AddRoutine("PM" + std::to_string(number), kind, CommentOf(number));
  }
}

void ModuleWriter::Begin(ModuleId id) {
  registers_.BeginModule();
  logic_.BeginModule();
  control_.BeginModule();
  builder_.SetRegion(program_.routines[modules_.RoutineOf(id)].body);
  builder_.SetRange({});
  if (!modules_.IsCalled(id)) {  // from the scheduler only: 4.2
    registers_.s().Set(builder_.Bit(0));
    registers_.ax().Set(Word(0));
    registers_.s().EndStatement();
    registers_.ax().EndStatement();
  }
  if (dialects::Register* first = registers_.first()) {
    logic_.Decided(1);
    first->EndStatement();
  }
}

void ModuleWriter::FindLabels() {
  label_at_.assign(module().instructions.count + 1, false);
  for (uint32_t i = 0; i < module().labels.count; ++i) {
    const Label& label = tree_.labels[LabelId(module().labels.first + i)];
    if (label.uses > 0) label_at_[label.at.index - module().begin_of().index] = true;
  }
}

void ModuleWriter::Lower(ModuleId id) {
  module_ = &tree_.modules[id];
  Begin(id);
  FindLabels();
  statements_.BeginModule(label_at_);
  for (uint32_t i = module().begin_of().index; i < module().end_of().index; ++i) Execute(InstructionId(i));
  logic_.Fold();  // END ends a sequence, too: its S is the caller's
  statements_.EndModule();
  builder_.SetRange({});
  registers_.Spill();
  control_.BindEnd();
}

void ModuleWriter::Execute(InstructionId id) {
  const uint32_t index = id.index - module().begin_of().index;
  const Instruction& instruction = tree_.instructions[id];
  if (label_at_[index]) {
    registers_.Spill();
    control_.BindLabel(id);
    registers_.Forget();
  }
  if (statements_.BeginsAt(index)) {
    registers_.EndStatement();
    statements_.Begin(index);
  }
  builder_.SetRange(instruction.range);
  const bool ends = Info(instruction.op).role == Role::kEnds;
  if (ends) logic_.Fold();
  instructions_.Lower(id);
  if (ends) logic_.EndSequence();
}

}  // namespace plcxx::prostep
