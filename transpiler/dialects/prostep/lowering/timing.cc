#include "transpiler/dialects/prostep/lowering/timing.h"

#include <string>

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/instances.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/scalars.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

ValueId Timing::PortWord(const Operand& operand, ValueId needed) {
  const ir::PlaceId word = scalars_.Of(ScalarPlace::kPortWord);
  builder_.Store(word, Word(0));
  builder_.When(needed, [&] { builder_.Store(word, operands_.Read(operand)); });
  return builder_.Load(word);
}

ValueId Timing::StartsTimer(const Instruction& instruction, OpKind start, ValueId condition) {
  using dialects::Join;
  const auto both = [&](ValueId a, ValueId b) { return dialects::Joined(builder_, Join::kAnd, a, b); };
  const uint32_t number = instruction.operand.number;
  const ValueId edge =
      builder_.Load(instances_.FieldOf(instances_.Timer(number), "edge", "T" + std::to_string(number) + "_edge"));
  const ValueId rises = both(condition, dialects::Inverted(builder_, edge));
  if (start == OpKind::kStartLatchedDelay)
    return both(rises, dialects::Inverted(builder_, builder_.Load(instances_.OutputOf(number))));
  if (start != OpKind::kStartOffDelay) return rises;
  const ValueId output = builder_.Load(instances_.OutputOf(number));
  const ValueId is_off = dialects::Inverted(builder_, condition);
  const ValueId falls = both(is_off, edge);
  return both(falls, output);
}

ValueId Timing::Parameter(const Instruction& instruction) {
  const Operand& operand = Argument(instruction, 0);
  // Its digits are BCD whatever the form: hexadecimal shows them.
  if (operand.shape() == Shape::kConstant) return builder_.Constant(ir::Type::kI16, operand.value, 16);
  return operands_.Read(operand);
}

void Timing::StartTimer(const Instruction& instruction, OpKind start) {
  const ValueId condition = logic_.Value();
  const Operand& operand = Argument(instruction, 0);
  const ValueId time = operand.kind == OperandClass::kPW ? PortWord(operand, StartsTimer(instruction, start, condition))
                                                         : Parameter(instruction);
  logic_.Replace(builder_.Step(start, instances_.Timer(instruction.operand.number), {condition, time}));
}

void Timing::Count(const Instruction& instruction, OpKind step) {
  const ValueId condition = logic_.Value();
  logic_.Replace(builder_.Step(step, instances_.Counter(instruction.operand.number), {condition}));
}

void Timing::SetCounter(const Instruction& instruction) {
  const ValueId condition = logic_.Value();
  const ir::StateId counter = instances_.Counter(instruction.operand.number);
  const bool edge = settings_.counter_set == CounterSet::kEdge;
  ValueId preset;
  if (const Operand& operand = Argument(instruction, 0); operand.kind == OperandClass::kPW) {
    ValueId needed = condition;
    if (edge) {
      const std::string name = "C" + std::to_string(instruction.operand.number) + "_set_edge";
      const ValueId was = builder_.Load(instances_.FieldOf(counter, "set_edge", name));
      needed = dialects::Joined(builder_, dialects::Join::kAnd, condition, dialects::Inverted(builder_, was));
    }
    preset = PortWord(operand, needed);
  } else {
    preset = Parameter(instruction);
  }
  builder_.Step(edge ? OpKind::kSetCounterOnEdge : OpKind::kSetCounter, counter, {condition, preset});
}

void Timing::ResetTimer(const Instruction& instruction) {
  const ValueId condition = logic_.Value();
  const ir::StateId timer = instances_.Timer(instruction.operand.number);
  builder_.Step(OpKind::kResetTimer, timer, {condition});
}

void Timing::ResetCounter(const Instruction& instruction) {
  const ValueId condition = logic_.Value();
  builder_.Step(OpKind::kZeroCounter, instances_.Counter(instruction.operand.number), {condition});
}

ValueId Timing::TimeLeft(const Instruction& instruction, OpKind step) {
  return builder_.Step(step, instances_.Timer(instruction.operand.number), {});
}

ValueId Timing::CounterValue(const Instruction& instruction) {
  return builder_.Load(instances_.ValueOf(instruction.operand.number));
}

}  // namespace plcxx::prostep
