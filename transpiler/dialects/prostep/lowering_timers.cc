// Timers and counters (specification section 7).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

ir::StateId Lowering::TimerOf(uint32_t number) {
  ir::StateId& timer = timers_[number];
  if (!timer.valid()) {
    timer = program_.states.Add({.kind = ir::StateKind::kTimeWordTimer, .name = "T" + std::to_string(number)});
  }
  return timer;
}

ir::StateId Lowering::CounterOf(uint32_t number) {
  ir::StateId& counter = counters_[number];
  if (!counter.valid()) {
    counter = program_.states.Add({.kind = ir::StateKind::kDecadeCounter, .name = "C" + std::to_string(number)});
  }
  return counter;
}

ir::PlaceId Lowering::OutputOf(uint32_t timer) {
  ir::PlaceId& output = outputs_[timer];
  if (!output.valid()) {
    const std::string number = std::to_string(timer);
    ir::Place place{.name = "T" + number + "_out", .address = "T " + number, .type = ir::Type::kBit};
    place.state = TimerOf(timer);
    place.field = ir::FieldIndex(ir::StateKind::kTimeWordTimer, "output");
    output = program_.places.Add(std::move(place));
  }
  return output;
}

ir::PlaceId Lowering::ValueOf(uint32_t counter) {
  ir::PlaceId& value = values_[counter];
  if (!value.valid()) {
    const std::string number = std::to_string(counter);
    ir::Place place{.name = "C" + number + "_count", .address = "C " + number, .type = ir::Type::kI16};
    place.state = CounterOf(counter);
    place.field = ir::FieldIndex(ir::StateKind::kDecadeCounter, "value");
    value = program_.places.Add(std::move(place));
  }
  return value;
}

ValueId Lowering::Parameter(const Instruction& instruction) {
  const Operand& operand = tree_.Argument(instruction, 0);
  // Its digits are BCD whatever the form: hexadecimal shows them.
  if (operand.shape() == Shape::kConstant) return builder_.Constant(ir::Type::kI16, operand.value, 16);
  return ReadData(operand);
}

void Lowering::StartTimer(const Instruction& instruction) {
  const ValueId condition = logic_->Value();
  const ValueId time = Parameter(instruction);
  const auto start = [&](OpKind op) {
    logic_->Replace(builder_.Step(op, TimerOf(instruction.operand.number), {condition, time}));
  };
  switch (instruction.op) {
    case Op::kPulse:
      return start(OpKind::kStartPulse);
    case Op::kExtendedPulse:
      return start(OpKind::kStartExtended);
    case Op::kOnDelay:
      return start(OpKind::kStartOnDelay);
    case Op::kLatchedOnDelay:
      return start(OpKind::kStartLatchedDelay);
    case Op::kOffDelay:
      return start(OpKind::kStartOffDelay);
    default:
      PLCXX_UNREACHABLE();
  }
}

void Lowering::StepCounter(const Instruction& instruction) {
  const ValueId condition = logic_->Value();
  const ir::StateId counter = CounterOf(instruction.operand.number);
  switch (instruction.op) {
    case Op::kCountUp:
      return logic_->Replace(builder_.Step(OpKind::kCountUp, counter, {condition}));
    case Op::kCountDown:
      return logic_->Replace(builder_.Step(OpKind::kCountDown, counter, {condition}));
    case Op::kSetCounter: {
      const bool edge = settings_.counter_set == CounterSet::kEdge;
      builder_.Step(edge ? OpKind::kSetCounterOnEdge : OpKind::kSetCounter, counter,
                    {condition, Parameter(instruction)});
      return;
    }
    case Op::kResetCounter:
      builder_.Step(OpKind::kZeroCounter, counter, {condition});
      return;
    default:
      PLCXX_UNREACHABLE();
  }
}

}  // namespace plcxx::prostep
