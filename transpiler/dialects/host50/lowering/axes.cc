#include "transpiler/dialects/host50/lowering/axes.h"

#include <iterator>
#include <utility>
#include <vector>

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/faults.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/numbers.h"
#include "transpiler/dialects/host50/lowering/own_instances.h"
#include "transpiler/dialects/host50/lowering/results.h"

namespace plcxx::host50 {
namespace {

using ir::OpKind;
using ir::ValueId;

/// In the order of the enumerators of axis_command.
constexpr Op kKinds[] = {Op::kHome, Op::kPosa, Op::kPosm, Op::kVelp, Op::kVeln};

Address SignalAt(Area area, uint32_t number) { return {.area = area, .number = static_cast<uint16_t>(number)}; }

}  // namespace

Axes::Axes(const Context& context, HostCalls& host, Cells& cells, OwnInstances& instances, Faults& faults, Logic& logic,
           Numbers& numbers, Results& results)
    : Context(context),
      host_(host),
      cells_(cells),
      instances_(instances),
      faults_(faults),
      logic_(logic),
      numbers_(numbers),
      results_(results) {}

ir::PlaceId Axes::AxisField(const AxisRequest& request, std::string_view field) {
  const uint8_t index = ir::FieldIndex(ir::StateKind::kAxisRequest, field);
  // A block has few fields, and they are its newest places.
  for (uint32_t i = program_.places.size(); i-- > 0;) {
    const ir::Place& place = program_.places[ir::PlaceId(i)];
    if (place.state == request.state && place.field == index) return ir::PlaceId(i);
    if (place.is_field() && place.state < request.state) break;
  }
  ir::Place place{.name = program_.states[request.state].name + "." + std::string(field),
                  .type = ir::Info(ir::StateKind::kAxisRequest).fields[index].type,
                  .state = request.state};
  place.field = index;
  return program_.places.Add(std::move(place));
}

void Axes::SwitchOverAxes(ValueId axis, const std::function<void(uint32_t)>& arm) {
  ir::Switch cases;
  for (uint32_t i = 0; i < kAxes; ++i) {
    cases.cases.push_back({.values = {i}, .region = builder_.RegionOf([&] { arm(i); })});
  }
  builder_.SwitchOn(axis, std::move(cases));
}

/// What the block does not have counts as 0, and is not compared.
void Axes::ReadNumbers(AxisRequest& request) {
  uint32_t next = 1;  // after the axis number
  const auto read = [&](AxisValue value, Type type) {
    if (value == AxisValue::kNotWritten) {
      return builder_.Constant(type == Type::kFloat ? ir::Type::kF32 : ir::Type::kI32, 0);
    }
    const ValueId number = numbers_.Of(OperandOf(*request.instruction, next++), type);
    return value == AxisValue::kNegated ? builder_.Pure(OpKind::kNegateF32, {number}) : number;
  };
  request.method = read(request.block->method, Type::kInteger);
  request.position = read(request.block->position, Type::kFloat);
  request.speed = read(request.block->speed, Type::kFloat);
}

void Axes::WriteAxisSignals(const AxisRequest& request, uint32_t axis) {
  const AxisBlock& block = *request.block;
  cells_.Store(SignalAt(Area::kQ, kAxisMove + axis), builder_.Bit(1));
  cells_.Store(SignalAt(Area::kQ, kAxisPositionMode + axis), builder_.Bit(block.position_mode ? 1 : 0));
  cells_.Store(SignalAt(Area::kQ, kAxisAbsolute + axis), builder_.Bit(block.absolute ? 1 : 0));
  cells_.Store(SignalAt(Area::kQ, kAxisHoming + axis), builder_.Bit(block.homing ? 1 : 0));
  if (block.method != AxisValue::kNotWritten) cells_.Store(SignalAt(Area::kQw, kAxisMethod + axis), request.method);
  if (block.speed != AxisValue::kNotWritten) cells_.Store(SignalAt(Area::kQf, kAxisSpeed + axis), request.speed);
  if (block.position != AxisValue::kNotWritten)
    cells_.Store(SignalAt(Area::kQf, kAxisPosition + axis), request.position);
}

/// As bit patterns, except that two NaNs are the same: which NaN an operation yields is the processor's choice.
ValueId Axes::RealsDiffer(ValueId now, ValueId before) {
  const ValueId now_bits = builder_.Pure(OpKind::kBitsOfF32, {now});
  const ValueId bits_before = builder_.Pure(OpKind::kBitsOfF32, {before});
  const ValueId bits_differ = builder_.Pure(OpKind::kNotEqual32, {now_bits, bits_before});
  // A constant is a number, and so is what was an integer.
  const OpKind origin = program_[now].op;
  if (origin == OpKind::kConst) return bits_differ;
  if (origin == OpKind::kSignedToF32) {
    if (facts_.on()) facts_.Check(ir::FactKind::kResult, builder_.Pure(OpKind::kEqualF32, {now, now}), now_bits);
    return bits_differ;
  }
  const ValueId now_number = builder_.Pure(OpKind::kEqualF32, {now, now});
  const ValueId number_before = builder_.Pure(OpKind::kEqualF32, {before, before});
  const ValueId a_number = logic_.Or(now_number, number_before);
  return logic_.And(bits_differ, a_number);
}

/// What was sent last is kept in the block's own instance. A constant is not: while the block is active, it is what was
/// sent.
void Axes::SendRequest(const AxisRequest& request, ValueId axis) {
  const AxisBlock& block = *request.block;
  struct Kept {
    std::string_view field;
    ValueId now;
  };
  std::vector<Kept> kept;
  const auto keep = [&](AxisValue value, ValueId now, std::string_view field) {
    if (value != AxisValue::kNotWritten && program_[now].op != OpKind::kConst) kept.push_back({field, now});
  };
  keep(block.method, request.method, "method");
  keep(block.position, request.position, "position");
  keep(block.speed, request.speed, "speed");
  ValueId changed = logic_.Not(builder_.Load(AxisField(request, "active")));
  for (const Kept& number : kept) {
    const ValueId before = builder_.Load(AxisField(request, number.field));
    const bool real = program_[number.now].type == ir::Type::kF32;
    changed = logic_.Or(
        changed, real ? RealsDiffer(number.now, before) : builder_.Pure(OpKind::kNotEqual32, {number.now, before}));
  }
  builder_.If(changed, builder_.RegionOf([&] {
    const ValueId kind = builder_.Constant(ir::Type::kI8, request.kind), active = builder_.Bit(1);
    host_(HostCall::kAxisCommand, {axis, kind, active, request.method, request.position, request.speed});
    for (const Kept& number : kept) builder_.Store(AxisField(request, number.field), number.now);
    builder_.Store(AxisField(request, "active"), builder_.Bit(1));
  }));
}

void Axes::StopAxis(const AxisRequest& request, ValueId axis) {
  builder_.Store(AxisField(request, "active"), builder_.Bit(0));
  const ValueId kind = builder_.Constant(ir::Type::kI8, request.kind), active = builder_.Bit(0);
  const ValueId zero = builder_.Constant(ir::Type::kI32, 0), none = builder_.Constant(ir::Type::kF32, 0);
  host_(HostCall::kAxisCommand, {axis, kind, active, zero, none, none});
}

void Axes::CommandKnownAxis(AxisRequest request, uint32_t axis, ValueId input) {
  const auto number = [&] { return builder_.Constant(ir::Type::kI32, axis); };
  const auto run = [&] {
    ReadNumbers(request);
    WriteAxisSignals(request, axis);
    SendRequest(request, number());
  };
  if (logic_.IsConstant(input, 1)) return run();
  const ir::RegionId running = builder_.RegionOf(run);
  const ir::RegionId idle = builder_.RegionOf([&] {
    const ValueId active = builder_.Load(AxisField(request, "active"));
    builder_.If(active, builder_.RegionOf([&] {
      cells_.Store(SignalAt(Area::kQ, kAxisMove + axis), builder_.Bit(0));
      StopAxis(request, number());
    }));
  });
  builder_.If(input, running, idle);
}

void Axes::CommandComputedAxis(AxisRequest request, ValueId axis, ValueId input) {
  const ValueId exists = builder_.Pure(OpKind::kLess32, {axis, builder_.Constant(ir::Type::kI32, kAxes)});
  const ValueId valid = logic_.And(input, exists);
  const ValueId active = builder_.Load(AxisField(request, "active"));
  const ValueId other = builder_.Pure(OpKind::kNotEqual32, {axis, builder_.Load(AxisField(request, "axis"))});
  const ValueId withdrawn = logic_.And(active, logic_.Or(logic_.Not(valid), other));
  builder_.If(withdrawn, builder_.RegionOf([&] {
    const ValueId before = builder_.Load(AxisField(request, "axis"));
    SwitchOverAxes(before, [&](uint32_t i) { cells_.Store(SignalAt(Area::kQ, kAxisMove + i), builder_.Bit(0)); });
    StopAxis(request, before);
  }));
  const ValueId wrong = logic_.And(input, logic_.Not(exists));
  builder_.If(wrong, builder_.RegionOf([&] { faults_.Call(Fault::kAxisRange); }));
  builder_.If(valid, builder_.RegionOf([&] {
    ReadNumbers(request);
    builder_.Store(AxisField(request, "axis"), axis);
    SwitchOverAxes(axis, [&](uint32_t i) { WriteAxisSignals(request, i); });
    SendRequest(request, axis);
  }));
}

void Axes::Command(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const ValueId input = results_.TakeInput(instruction.input);
  results_.KeepFrom(WritesOf(tree_, instruction));
  builder_.SetRange(instruction.range);
  AxisRequest request{.instruction = &instruction, .block = AxisBlockOf(instruction.op), .state = instances_.Add(id)};
  for (uint32_t i = 0; i < std::size(kKinds); ++i) {
    if (kKinds[i] == instruction.op) request.kind = i;
  }
  const Operand& axis = OperandOf(instruction, 0);
  const uint32_t base = settings_.axisbase == AxisBaseOption::kOne ? 1 : 0;
  if (axis.kind == OperandKind::kConstant) return CommandKnownAxis(request, axis.bits - base, input);
  ValueId index = numbers_.Of(axis, Type::kInteger);
  if (base != 0) index = builder_.Pure(OpKind::kSub32, {index, builder_.Constant(ir::Type::kI32, base)});
  CommandComputedAxis(request, index, input);
}

}  // namespace plcxx::host50
