// Jumps, calls, the module's end (specification 6.5 to 6.7).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::ValueId;

void Lowering::SpillAll() {
  s_->Spill();
  ax_->Spill();
  if (first_ != nullptr) first_->Spill();
}

void Lowering::ForgetAll() {
  s_->Forget();
  ax_->Forget();
  if (first_ != nullptr) first_->Forget();
}

void Lowering::CallFault(Fault fault) {
  host_(HostCall::kFault, {builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault)), Number(module_->number)});
}

void Lowering::Jump(InstructionId id, const Instruction& instruction, bool conditional) {
  Fold();
  const ValueId condition = conditional ? logic_->Value() : ValueId();
  SpillAll();
  const InstructionId at = tree_.labels[instruction.target].at;
  if (at.index > id.index) {
    const bool to_end = at == module_->end_of();
    end_is_used_ |= to_end;
    builder_.Jump(to_end ? kEndLabel : LabelBefore(at), condition);
  } else {
    const ir::RegionId refused = builder_.RegionOf([&] {
      CallFault(Fault::kLoopBudget);
      builder_.Jump(kEndLabel);
    });
    end_is_used_ = true;
    builder_.JumpBack(LabelBefore(at), condition, PlaceOf(ScalarPlace::kRounds), refused);
  }
  // A jump that is not taken tells its condition.
  if (conditional) s_->Know(0);
}

void Lowering::Call(const Instruction& instruction, bool conditional) {
  const ValueId condition = conditional ? logic_->Value() : ValueId();
  SpillAll();
  const ir::RoutineId routine = routines_[instruction.module.index];
  if (conditional) {
    builder_.When(condition, [&] { builder_.CallRoutine(routine, {}); });
  } else {
    builder_.CallRoutine(routine, {});
  }
  ForgetAll();
}

void Lowering::EndModule(InstructionId id, bool conditional) {
  // At the end of the text the module ends anyway.
  if (id.index + 1 == module_->end_of().index) return;
  const ValueId condition = conditional ? logic_->Value() : ValueId();
  SpillAll();
  end_is_used_ = true;
  builder_.Jump(kEndLabel, condition);
  if (conditional) s_->Know(0);
}

}  // namespace plcxx::prostep
