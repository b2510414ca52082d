// Bits, flags, jumps, calls, errors (specification 6.2 to 6.4, 6.8).

#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::Type;
using ir::ValueId;

ValueId Lowering::ReadBit(const Operand& operand) {
  const ValueId value = builder_.Load(PlaceAt(operand));
  return operand.negated ? builder_.Not(value) : value;
}

/// With mech-clear=abort a cleared mechanism is as after MECH_INIT, and one that clears itself is left.
void Lowering::WriteBit(const Operand& operand, ValueId value) {
  builder_.Store(PlaceAt(operand), value);
  if (!operand.is_activation_bit() || settings_.mech_clear != MechClear::kAbort) return;
  const auto rewind = [&] {
    Rewind(operand.mechanism);
    LeaveStopped(operand.mechanism);
  };
  const std::optional<uint64_t> known = builder_.KnownValue(value);
  if (known) {
    if (*known == 0) builder_.When(builder_.Bit(1), rewind);
    return;
  }
  builder_.When(builder_.Not(value), rewind);
}

void Lowering::SetFlag(const Instruction& instruction) {
  const Operand& bit = tree_.OperandOf(instruction, 1);
  const auto set = [&] { WriteBit(bit, builder_.Bit(static_cast<uint64_t>(tree_.OperandOf(instruction, 0).value))); };
  if (instruction.op == Op::kFl) return set();
  const ValueId rlo = registers_.rlo().Get();
  builder_.When(instruction.op == Op::kFl1 ? rlo : builder_.Not(rlo), set);
}

InstructionId Lowering::TargetOf(const Instruction& instruction) const {
  const Operand& label = tree_.OperandOf(instruction, instruction.operands.count - 1);
  return tree_.labels[label.label].at;
}

/// A jump back takes one of the rounds; when none is left, everything is left (6.4).
void Lowering::Jump(InstructionId target, ValueId condition) {
  const size_t stretch = body_->StretchOf(target);
  const bool to_other_stretch = stretch != body_->StretchOf(now_);
  if (target > now_) {
    const bool to_end_of_own = to_other_stretch && body_->stretches_are_cases && body_->IsEntry(target);
    return builder_.Jump(to_end_of_own ? EndOfStretch(target) : target.index + 1, condition);
  }
  const ir::RegionId refused = builder_.RegionOf([&] {
    CallFault(Fault::kLoop);
    LeaveAll();
  });
  if (to_other_stretch) return JumpToEntry(stretch, condition, refused);
  builder_.JumpBack(target.index + 1, condition, Local("rounds_left", Type::kI32), refused);
}

void Lowering::JumpToEntry(size_t step, ValueId condition, ir::RegionId refused) {
  const auto go = [&] {
    builder_.Store(chosen_, builder_.Constant(step, 16));
    builder_.Repeat(loop_, {}, refused);
  };
  if (!condition.valid()) return go();
  const ir::RegionId taken = builder_.NewRegion();
  program_[builder_.If(condition, taken)].payload = static_cast<uint32_t>(ir::IfOrigin::kJumps);
  builder_.Into(taken, go);
}

void Lowering::LeaveAll() {
  if (!body_->unit.valid()) builder_.Store(Local("left", Type::kBit), builder_.Bit(1));
  end_is_used_ = true;
  builder_.Jump(kEndLabel);
}

void Lowering::JumpIfRlo(const Instruction& instruction, bool wanted) {
  const ValueId rlo = registers_.rlo().Get();
  registers_.Spill();
  Jump(TargetOf(instruction), wanted ? rlo : builder_.Not(rlo));
  registers_.rlo().Know(wanted ? 0 : 1);  // a jump that is not taken tells its condition
}

void Lowering::Call(const Instruction& instruction) {
  const uint32_t callee = *flow_.CalleeOf(instruction);
  const Body& body = bodies_[body_of_subprogram_[callee]];
  registers_.Spill();
  std::vector<ValueId> arguments;
  if (body.entry.valid()) {
    uint64_t entry = 0;
    while (body.subprograms[entry] != callee) ++entry;
    arguments.push_back(builder_.Byte(entry));
  }
  const bool may_be_stopped = body_->stopped_by_callee && MayStop(body, body_->unit);
  if (may_be_stopped) builder_.Store(StoppedPlace(body_->unit), builder_.Bit(0));
  const ValueId left = builder_.CallRoutine(body.routine, std::move(arguments));
  registers_.Forget();
  if (body.leaves && body_->unit.valid()) {
    end_is_used_ = true;
    builder_.Jump(kEndLabel, left);
  } else if (body.leaves) {
    builder_.When(left, [&] { LeaveAll(); });  // the caller's own caller asks, too
  }
  if (!may_be_stopped) return;
  end_is_used_ = true;
  builder_.Jump(kEndLabel, builder_.Load(StoppedPlace(body_->unit)));
}

void Lowering::Return() {
  registers_.Spill();
  if (index_in_body_[now_.index] + 1 == body_->instructions.size()) return;
  end_is_used_ = true;
  builder_.Jump(kEndLabel);
}

void Lowering::RaiseError(const Instruction& instruction) {
  const auto number = [&](uint32_t index) {
    if (index >= instruction.operands.count) return uint64_t{0};
    return static_cast<uint64_t>(tree_.OperandOf(instruction, index).value);
  };
  const auto stored = [&](uint64_t value) {
    if (settings_.eset == EsetForm::kBinary) return builder_.Byte(value);
    return builder_.Constant(Type::kI8, value / 10 * 16 + value % 10, 16);
  };
  builder_.Store(SystemPlace("BZH11"), stored(number(0)));
  builder_.Store(SystemPlace("BZH22"), stored(number(1)));
  host_(HostCall::kErrorRaised, {builder_.Byte(number(0)), builder_.Byte(number(1))});
}

}  // namespace plcxx::technol
