#include "transpiler/dialects/nc110/lowering/targets.h"

#include "transpiler/dialects/nc110/analysis/accesses.h"
#include "transpiler/dialects/nc110/lowering/cells.h"
#include "transpiler/dialects/nc110/lowering/expirations.h"
#include "transpiler/dialects/nc110/lowering/expressions.h"
#include "transpiler/dialects/nc110/lowering/faults.h"
#include "transpiler/dialects/nc110/lowering/latched_inputs.h"
#include "transpiler/dialects/nc110/lowering/system_places.h"

namespace plcxx::nc110 {

using ir::OpKind;

Targets::Targets(const Context& context, Cells& cells, LatchedInputs& inputs, SystemPlaces& system, Faults& faults,
                 Expressions& expressions, Expirations& expirations)
    : Context(context),
      cells_(cells),
      inputs_(inputs),
      system_(system),
      faults_(faults),
      expressions_(expressions),
      expirations_(expirations) {}

void Targets::AssignMemory(const Operand& target, ir::ValueId value) {
  builder_.Store(cells_.PlaceOf(target), value);
  // What the program writes is there at once for both parts: the copy gets what the image holds then, forces included.
  if (inputs_.HasCopy(target)) builder_.Store(inputs_.CopyOf(target), builder_.Load(cells_.PlaceOf(target)));
}

/// The first selector that is 1 decides, later ones are not looked at; one arm at most is executed, and it reads its
/// word before it writes the target.
void Targets::AssignMux(const Operand& target, const Mux& mux) {
  const ir::RegionId behind = builder_.region();
  for (uint32_t i = 0; i < mux.count; ++i) {
    const MuxInput& input = tree_.mux_inputs[mux.first + i];
    const ir::ValueId selected = expressions_.Evaluate(input.selector, ir::Type::kBit);
    const ir::RegionId then = builder_.NewRegion();
    const ir::RegionId otherwise = i + 1 < mux.count ? builder_.NewRegion() : ir::RegionId();
    builder_.SetRange(mux.range);
    builder_.If(selected, then, otherwise);
    builder_.SetRegion(then);
    AssignMemory(target, expressions_.Evaluate(input.word, ir::Type::kI8));
    if (otherwise.valid()) builder_.SetRegion(otherwise);
  }
  builder_.SetRegion(behind);
}

ir::ValueId Targets::Pair(const Operand& low) {
  const Operand high = HighByteOf(low);  // the parser has refused a pair at the end of a package
  const ir::ValueId low_byte = builder_.Load(inputs_.ReadPlaceOf(low)),
                    high_byte = builder_.Load(inputs_.ReadPlaceOf(high));
  return builder_.Pure(OpKind::kPair16, {low_byte, high_byte});
}

void Targets::StepTimer(const Assignment& assignment, ir::ValueId input) {
  const Operand& target = assignment.target.operand;
  const TimerBase base = BaseOfTimer(target.number);
  ir::ValueId preset;
  const Expr& delay = tree_.exprs[assignment.parameter];  // a constant or a word: the parser takes nothing else
  if (delay.kind == ExprKind::kOperand) {
    preset = builder_.Pure(OpKind::kWiden16To32, {Pair(delay.operand)});
    const uint32_t unit = base.parametric_ticks * settings_.tim_ms;
    if (unit != 1) preset = builder_.Pure(OpKind::kMul32, {preset, builder_.Constant(ir::Type::kI32, unit)});
  } else {
    preset = builder_.Constant(ir::Type::kI32, delay.value * base.constant_unit_ms);
  }
  const ir::ValueId now = system_.Load(SystemPlace::kNow);
  builder_.Step(OpKind::kOnDelay, cells_.InstanceOf(target), {input, preset, now});
}

void Targets::StepCounter(const Assignment& assignment, ir::ValueId input) {
  const Operand& target = assignment.target.operand;
  const Expr& parameter = tree_.exprs[assignment.parameter];  // as of a timer
  const bool parametric = parameter.kind == ExprKind::kOperand;
  const ir::ValueId modulus = parametric ? Pair(parameter.operand) : builder_.Constant(ir::Type::kI16, parameter.value);
  const ir::StateId counter = cells_.InstanceOf(target);
  ir::ValueId counted;
  switch (settings_.carry) {
    case CarryEnd::kScan: {
      const bool fast = part_ == Part::kFast;
      const ir::ValueId stamp = system_.Load(fast ? SystemPlace::kFastCount : SystemPlace::kSlowCycle);
      counted = builder_.Step(fast ? OpKind::kCountFast : OpKind::kCountSlow, counter, {input, modulus, stamp});
      expirations_.Add(counter);
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
    if (facts_.on()) facts_.Check(ir::FactKind::kResult, counted, modulus);
    return;
  }
  builder_.When(builder_.Pure(OpKind::kBitNot, {counted}), [&] { faults_.Call(Fault::kParamRange, target.number); });
}

void Targets::StepOneShot(const Operand& target, ir::ValueId input) {
  const ir::StateId shot = cells_.InstanceOf(target);
  expirations_.Add(shot);
  if (part_ == Part::kSlow) {
    builder_.Step(OpKind::kPulseSlow, shot, {input, system_.Load(SystemPlace::kSlowCycle)});
    return;
  }
  const ir::ValueId slow_done = system_.Load(SystemPlace::kSlowDone);
  const ir::ValueId open = sliced() ? system_.Load(SystemPlace::kSlowOpen) : builder_.Constant(ir::Type::kI8, 0);
  builder_.Step(OpKind::kPulseFast, shot, {input, slow_done, open});
}

void Targets::Assign(const Item& item) {
  const Assignment& assignment = tree_.assignments[item.assignment()];
  const Operand& target = assignment.target.operand;
  if (item.faulty) return;
  const bool word = TypeOf(target.kind) == Type::kWord;
  if (assignment.mux.valid()) {
    if (word) AssignMux(target, tree_.muxes[assignment.mux]);
    return;
  }
  ir::ValueId value = expressions_.Evaluate(assignment.value, word ? ir::Type::kI8 : ir::Type::kBit);
  builder_.SetRange(item.range);
  if (assignment.inverted && !word) value = builder_.Pure(ir::OpKind::kBitNot, {value});
  switch (target.kind) {
    case OperandKind::kOutput:
    case OperandKind::kWord:
    case OperandKind::kTimerHold:
    case OperandKind::kCounterDown:
    case OperandKind::kCounterValue:
      return AssignMemory(target, value);
    case OperandKind::kTimerInput:
      return StepTimer(assignment, value);
    case OperandKind::kCounterInput:
      return StepCounter(assignment, value);
    case OperandKind::kCounterReset:
      builder_.Step(ir::OpKind::kResetCounter, cells_.InstanceOf(target), {value});
      return;
    case OperandKind::kOneShot:
      return StepOneShot(target, value);
    case OperandKind::kNone:
    case OperandKind::kInput:
    case OperandKind::kTimerElapsed:
    case OperandKind::kTimerRunning:
    case OperandKind::kCounterCarry:
      return;  // no targets: reported by the parser
  }
}

}  // namespace plcxx::nc110
