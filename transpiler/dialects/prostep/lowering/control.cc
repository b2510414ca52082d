#include "transpiler/dialects/prostep/lowering/control.h"

#include "transpiler/dialects/prostep/lowering/faults.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/registers.h"
#include "transpiler/dialects/prostep/lowering/scalars.h"

namespace plcxx::prostep {

using ir::ValueId;

namespace {

constexpr uint32_t kEndLabel = 0;  // the others count from 1 by the instruction after them

}  // namespace

void Control::ToEnd(ValueId condition) {
  end_is_used_ = true;
  builder_.Jump(kEndLabel, condition);
}

void Control::BindEnd() {
  if (end_is_used_) builder_.Label(kEndLabel);
}

/// A jump back takes one of the iterations; when none is left, the module is.
void Control::JumpTo(InstructionId target, InstructionId from, ValueId condition) {
  if (target == module().end_of()) return ToEnd(condition);
  if (target > from) return builder_.Jump(LabelBefore(target), condition);
  const ir::RegionId refused = builder_.RegionOf([&] {
    faults_.Report(Fault::kLoopBudget);
    ToEnd({});
  });
  builder_.JumpBack(LabelBefore(target), condition, scalars_.Of(ScalarPlace::kRounds), refused);
}

void Control::Jump(InstructionId id) {
  logic_.Fold();
  registers_.Spill();
  JumpTo(tree_.labels[tree_.instructions[id].target].at, id, {});
}

void Control::JumpIf(InstructionId id) {
  logic_.Fold();
  const ValueId condition = logic_.Value();
  registers_.Spill();
  JumpTo(tree_.labels[tree_.instructions[id].target].at, id, condition);
  registers_.s().Know(0);  // a jump that is not taken tells its condition
}

void Control::Call(const Instruction& instruction) {
  registers_.Spill();
  builder_.CallRoutine(modules_.RoutineOf(instruction.module), {});
  registers_.Forget();
}

void Control::CallIf(const Instruction& instruction) {
  const ValueId condition = logic_.Value();
  registers_.Spill();
  builder_.When(condition, [&] { builder_.CallRoutine(modules_.RoutineOf(instruction.module), {}); });
  registers_.Forget();
}

void Control::EndModule(InstructionId id) {
  if (IsLast(id)) return;
  registers_.Spill();
  ToEnd({});
}

void Control::EndModuleIf(InstructionId id) {
  if (IsLast(id)) return;
  const ValueId condition = logic_.Value();
  registers_.Spill();
  ToEnd(condition);
  registers_.s().Know(0);
}

}  // namespace plcxx::prostep
