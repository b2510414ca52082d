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

/// A port is read only when its word is needed: reading is an event at the machine.
ValueId Lowering::PortWord(const Operand& operand, ValueId needed) {
  const ir::PlaceId word = PlaceOf(ScalarPlace::kPortWord);
  builder_.Store(word, Word(0));
  builder_.When(needed, [&] { builder_.Store(word, ReadData(operand)); });
  return builder_.Load(word);
}

/// Whether the start instruction takes its time word now: 7.1.
ValueId Lowering::StartsTimer(const Instruction& instruction, OpKind start, ValueId condition) {
  using dialects::Join;
  const auto both = [&](ValueId a, ValueId b) { return dialects::Joined(builder_, Join::kAnd, a, b); };
  const uint32_t number = instruction.operand.number;
  const ValueId edge = builder_.Load(FieldOf(TimerOf(number), "edge", "T" + std::to_string(number) + "_edge"));
  const ValueId rises = both(condition, dialects::Inverted(builder_, edge));
  if (start == OpKind::kStartLatchedDelay)
    return both(rises, dialects::Inverted(builder_, builder_.Load(OutputOf(number))));
  if (start != OpKind::kStartOffDelay) return rises;
  return both(both(dialects::Inverted(builder_, condition), edge), builder_.Load(OutputOf(number)));
}

ir::PlaceId Lowering::FieldOf(ir::StateId state, std::string_view field, std::string name) {
  const auto [found, is_new] = fields_.try_emplace(name);
  if (is_new) {
    ir::Place place{.name = std::move(name), .address = {}, .type = ir::Type::kBit};
    place.state = state;
    place.field = ir::FieldIndex(program_.states[state].kind, field);
    found->second = program_.places.Add(std::move(place));
  }
  return found->second;
}

ValueId Lowering::Parameter(const Instruction& instruction) {
  const Operand& operand = tree_.Argument(instruction, 0);
  // Its digits are BCD whatever the form: hexadecimal shows them.
  if (operand.shape() == Shape::kConstant) return builder_.Constant(ir::Type::kI16, operand.value, 16);
  return ReadData(operand);
}

void Lowering::StartTimer(const Instruction& instruction, OpKind start) {
  const ValueId condition = logic_->Value();
  const Operand& operand = tree_.Argument(instruction, 0);
  const ValueId time = operand.kind == OperandClass::kPW ? PortWord(operand, StartsTimer(instruction, start, condition))
                                                         : Parameter(instruction);
  logic_->Replace(builder_.Step(start, TimerOf(instruction.operand.number), {condition, time}));
}

void Lowering::Count(const Instruction& instruction, OpKind step) {
  const ValueId condition = logic_->Value();
  logic_->Replace(builder_.Step(step, CounterOf(instruction.operand.number), {condition}));
}

void Lowering::SetCounter(const Instruction& instruction) {
  const ValueId condition = logic_->Value();
  const ir::StateId counter = CounterOf(instruction.operand.number);
  const bool edge = settings_.counter_set == CounterSet::kEdge;
  ValueId preset;
  if (const Operand& operand = tree_.Argument(instruction, 0); operand.kind == OperandClass::kPW) {
    ValueId needed = condition;
    if (edge) {
      const std::string name = "C" + std::to_string(instruction.operand.number) + "_set_edge";
      const ValueId was = builder_.Load(FieldOf(counter, "set_edge", name));
      needed = dialects::Joined(builder_, dialects::Join::kAnd, condition, dialects::Inverted(builder_, was));
    }
    preset = PortWord(operand, needed);
  } else {
    preset = Parameter(instruction);
  }
  builder_.Step(edge ? OpKind::kSetCounterOnEdge : OpKind::kSetCounter, counter, {condition, preset});
}

}  // namespace plcxx::prostep
