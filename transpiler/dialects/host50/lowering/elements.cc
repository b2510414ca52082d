#include "transpiler/dialects/host50/lowering/elements.h"

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/faults.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/numbers.h"
#include "transpiler/dialects/host50/lowering/results.h"

namespace plcxx::host50 {
namespace {

using ir::OpKind;
using ir::ValueId;

struct TimerRow {
  Op op;
  TpOption tp;
  OpKind by_unit[3];  // by TimerUnit
};
constexpr TimerRow kTimers[] = {
    {Op::kTon, TpOption::kManual, {OpKind::kTonMs, OpKind::kTonS, OpKind::kTonM}},
    {Op::kTon, TpOption::kIec, {OpKind::kTonMs, OpKind::kTonS, OpKind::kTonM}},
    {Op::kTof, TpOption::kManual, {OpKind::kTofMs, OpKind::kTofS, OpKind::kTofM}},
    {Op::kTof, TpOption::kIec, {OpKind::kTofMs, OpKind::kTofS, OpKind::kTofM}},
    {Op::kTp, TpOption::kManual, {OpKind::kTpMs, OpKind::kTpS, OpKind::kTpM}},
    {Op::kTp, TpOption::kIec, {OpKind::kPulseMs, OpKind::kPulseS, OpKind::kPulseM}},
};

}  // namespace

ValueId Elements::Execute(const Instruction& instruction) {
  const ValueId input = results_.TakeInput(instruction.input);
  results_.KeepFrom(WritesOf(tree_, instruction));
  builder_.SetRange(instruction.range);
  if (instruction.op == Op::kCnud) return StepCounter(instruction, input);
  if (instruction.op == Op::kRot) return Rotate(instruction, input);
  return StepTimer(instruction, input);
}

ValueId Elements::StepTimer(const Instruction& instruction, ValueId input) {
  // The preset is the last operand; the unit may stand before it or in the mnemonic.
  const ValueId preset = numbers_.Of(OperandOf(instruction, instruction.operands.count - 1), Type::kInteger);
  const ValueId period = builder_.Constant(ir::Type::kI32, now_.period_ms);
  for (const TimerRow& row : kTimers) {
    if (row.op != instruction.op || row.tp != settings_.tp) continue;
    const ir::StateId timer = cells_.InstanceOf(OperandOf(instruction, 0).address);
    return builder_.Step(row.by_unit[static_cast<size_t>(instruction.unit)], timer, {input, preset, period});
  }
  PLCXX_UNREACHABLE();
}

ValueId Elements::PinValue(const Pin& pin) {
  if (pin.from_stack) {
    return results_.TakeOne(pin.result);
  }
  const Operand& operand = pin.operand;
  if (operand.kind == OperandKind::kConstant) return builder_.Bit(operand.bits);
  const ValueId value = cells_.Load(operand.address);
  return operand.inverted ? logic_.Not(value) : value;
}

ValueId Elements::StepCounter(const Instruction& instruction, ValueId input) {
  const ValueId preset = numbers_.Of(OperandOf(instruction, 1), Type::kInteger);
  PLCXX_CHECK(instruction.pins.count == 3);
  ValueId pins[3];
  for (uint32_t i = 0; i < 3; ++i) pins[i] = PinValue(tree_.pins[instruction.pins.first + i]);
  // Constant pins are written as pins, too: a number would not say which is which.
  const ValueId packed = builder_.Pure(OpKind::kCounterPins, {pins[0], pins[1], pins[2]});
  const OpKind step = settings_.cnud == CnudOption::kHold ? OpKind::kCountHold : OpKind::kCountRing;
  return builder_.Step(step, cells_.InstanceOf(OperandOf(instruction, 0).address), {input, preset, packed});
}

/// Positions are counted from 0 inside. The result may be one of the sources, so that everything is read first.
ValueId Elements::Rotate(const Instruction& instruction, ValueId input) {
  const uint32_t base = settings_.rotbase == RotBaseOption::kOne ? 1 : 0;
  const auto position = [&](uint32_t index) {
    const Operand& operand = OperandOf(instruction, index);
    if (operand.kind == OperandKind::kConstant) return builder_.Constant(ir::Type::kI32, operand.bits - base);
    const ValueId value = numbers_.Of(operand, Type::kInteger);
    return base == 0 ? value : builder_.Pure(OpKind::kSub32, {value, builder_.Constant(ir::Type::kI32, base)});
  };
  const ValueId places = numbers_.Of(OperandOf(instruction, 0), Type::kInteger);
  const ValueId from = position(1), to = position(2);
  const ValueId steps_only = PinValue(tree_.pins[instruction.pins.first]);
  const ValueId on_ring = builder_.Pure(OpKind::kOnRing, {places, from, to});
  ValueId forward = builder_.Pure(OpKind::kRingForward, {places, from, to});
  if (settings_.rotq == RotQOption::kReverse) forward = logic_.Not(forward);
  const ValueId q = logic_.And(logic_.And(input, on_ring), forward);

  const Address& result = OperandOf(instruction, 3).address;
  const auto store_steps = [&] { cells_.Store(result, builder_.Pure(OpKind::kRingSteps, {places, from, to})); };
  const auto store_position = [&] {
    ValueId before = builder_.Pure(OpKind::kRingBefore, {places, from, to});
    if (base != 0) before = builder_.Pure(OpKind::kAdd32, {before, builder_.Constant(ir::Type::kI32, base)});
    cells_.Store(result, before);
  };
  const auto write = [&] {
    if (logic_.IsConstant(steps_only, 1)) return store_steps();
    if (logic_.IsConstant(steps_only, 0)) return store_position();
    const ir::RegionId steps = builder_.RegionOf(store_steps);
    builder_.If(steps_only, steps, builder_.RegionOf(store_position));
  };
  const auto turn = [&] {
    const ir::RegionId inside = builder_.RegionOf(write);
    builder_.If(on_ring, inside, builder_.RegionOf([&] { faults_.Call(Fault::kRotRange); }));
  };
  if (logic_.IsConstant(input, 1)) {
    turn();
  } else {
    builder_.If(input, builder_.RegionOf(turn));
  }
  return q;
}

}  // namespace plcxx::host50
