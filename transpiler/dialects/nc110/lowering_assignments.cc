// Targets: memory, timers, counters, one-shots, MUX.

#include "transpiler/dialects/nc110/accesses.h"
#include "transpiler/dialects/nc110/lowering_internal.h"

namespace plcxx::nc110 {

using ir::OpKind;

void Lowering::AssignMemory(const Operand& target, ir::ValueId value) {
  builder_.Store(PlaceOf(target), value);
  // What the program writes is there at once for both parts: the copy gets what the image holds then, forces included.
  if (HasLatchedCopy(target)) builder_.Store(LatchedPlaceOf(target), builder_.Load(PlaceOf(target)));
}

/// The first selector that is 1 decides, later ones are not looked at; one arm at most is executed, and it reads its
/// word before it writes the target.
void Lowering::AssignMux(const Operand& target, const Mux& mux) {
  const ir::RegionId behind = builder_.region();
  for (uint32_t i = 0; i < mux.count; ++i) {
    const MuxInput& input = tree_.mux_inputs[mux.first + i];
    const ir::ValueId selected = Evaluate(input.selector, ir::Type::kBit);
    const ir::RegionId then = builder_.NewRegion();
    const ir::RegionId otherwise = i + 1 < mux.count ? builder_.NewRegion() : ir::RegionId();
    builder_.SetRange(mux.range);
    builder_.If(selected, then, otherwise);
    builder_.SetRegion(then);
    AssignMemory(target, Evaluate(input.word, ir::Type::kI8));
    if (otherwise.valid()) builder_.SetRegion(otherwise);
  }
  builder_.SetRegion(behind);
}

ir::ValueId Lowering::Pair(const Operand& low) {
  const Operand high = HighByteOf(low);  // the parser has refused a pair at the end of a package
  const ir::ValueId low_byte = builder_.Load(ReadPlaceOf(low)), high_byte = builder_.Load(ReadPlaceOf(high));
  return builder_.Pure(OpKind::kPair16, {low_byte, high_byte});
}

void Lowering::StepTimer(const Assignment& assignment, ir::ValueId input) {
  const Operand& target = assignment.target.operand;
  const TimerBase base = BaseOfTimer(target.number);
  ir::ValueId preset;
  const Expr* delay = assignment.parameter.valid() ? &tree_.exprs[assignment.parameter] : nullptr;
  if (delay != nullptr && delay->kind == ExprKind::kConstant) {
    preset = builder_.Constant(ir::Type::kI32, delay->value * base.constant_unit_ms);
  } else if (delay != nullptr && delay->kind == ExprKind::kOperand && delay->operand.kind == OperandKind::kWord) {
    preset = builder_.Pure(OpKind::kWiden16To32, {Pair(delay->operand)});
    const uint32_t unit = base.parametric_ticks * settings_.tim_ms;
    if (unit != 1) preset = builder_.Pure(OpKind::kMul32, {preset, builder_.Constant(ir::Type::kI32, unit)});
  } else {
    preset = builder_.Poison(ir::Type::kI32);
  }
  builder_.Step(OpKind::kOnDelay, InstanceOf(target), {input, preset, LoadSystem(SystemPlace::kNow)});
}

void Lowering::StepCounter(const Assignment& assignment, ir::ValueId input) {
  const Operand& target = assignment.target.operand;
  ir::ValueId modulus;
  const Expr* parameter = assignment.parameter.valid() ? &tree_.exprs[assignment.parameter] : nullptr;
  const bool parametric =
      parameter != nullptr && parameter->kind == ExprKind::kOperand && parameter->operand.kind == OperandKind::kWord;
  if (parametric) {
    modulus = Pair(parameter->operand);
  } else if (parameter != nullptr && parameter->kind == ExprKind::kConstant) {
    modulus = builder_.Constant(ir::Type::kI16, parameter->value);
  } else {
    modulus = builder_.Poison(ir::Type::kI16);
  }
  const ir::StateId counter = InstanceOf(target);
  ir::ValueId counted;
  switch (settings_.carry) {
    case CarryEnd::kScan: {
      const bool fast = part_ == Part::kFast;
      const ir::ValueId stamp = LoadSystem(fast ? SystemPlace::kFastCount : SystemPlace::kSlowCycle);
      counted = builder_.Step(fast ? OpKind::kCountFast : OpKind::kCountSlow, counter, {input, modulus, stamp});
      driven_[static_cast<size_t>(part_)].Add(counter);
      break;
    }
    case CarryEnd::kInput:
      counted = builder_.Step(OpKind::kCountCarryWhileInput, counter, {input, modulus});
      break;
    case CarryEnd::kNext:
      counted = builder_.Step(OpKind::kCountCarryUntilNext, counter, {input, modulus});
      break;
  }
  if (!parametric) {  // a constant modulus is in range
    if (parameter != nullptr && facts_.on()) facts_.Check(ir::FactKind::kResult, counted, modulus);
    return;
  }
  builder_.When(builder_.Pure(OpKind::kBitNot, {counted}),
                [&] { CallFault(Fault::kParamRange, builder_.Constant(ir::Type::kI32, target.number)); });
}

void Lowering::StepOneShot(const Operand& target, ir::ValueId input) {
  const ir::StateId shot = InstanceOf(target);
  driven_[static_cast<size_t>(part_)].Add(shot);
  if (part_ == Part::kSlow) {
    builder_.Step(OpKind::kPulseSlow, shot, {input, LoadSystem(SystemPlace::kSlowCycle)});
    return;
  }
  const ir::ValueId slow_done = LoadSystem(SystemPlace::kSlowDone);
  const ir::ValueId open = sliced() ? LoadSystem(SystemPlace::kSlowOpen) : builder_.Constant(ir::Type::kI8, 0);
  builder_.Step(OpKind::kPulseFast, shot, {input, slow_done, open});
}

void Lowering::CallFault(Fault kind, ir::ValueId index) {
  const ir::ValueId which = builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(kind));
  host_(HostCall::kFault, {which, index});
}

}  // namespace plcxx::nc110
