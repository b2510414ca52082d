#include "transpiler/dialects/technol/lowering/value_builder.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

ValueId ValueBuilder::Constant(uint64_t value, uint32_t width, uint32_t base) {
  const uint64_t mask = width == 32 ? 0xFFFFFFFFU : width == 16 ? 0xFFFFU : 0xFFU;
  return Constant(TypeOf(width), value & mask, base);
}

uint32_t ValueBuilder::WidthOf(ValueId value) { return 8 * ir::Bytes(program()[value].type); }

std::optional<uint64_t> ValueBuilder::KnownValue(ValueId value) {
  const ir::Inst& inst = program()[value];
  if (inst.op != OpKind::kConst) return std::nullopt;
  return ir::ConstantValue(inst);
}

ValueId ValueBuilder::Low16(ValueId value) {
  const ir::Inst inst = program()[value];
  const auto is = [&inst](OpKind op) { return inst.op == op; };
  if (is(OpKind::kConst)) return Constant(Type::kI16, ir::ConstantValue(inst) & 0xFFFF, inst.c);
  if (is(OpKind::kWiden16To32) || is(OpKind::kSignExtend16To32) || is(OpKind::kPair32)) return ValueId(inst.a);
  if (is(OpKind::kWiden8To32)) return Pure(OpKind::kWiden8To16, {ValueId(inst.a)});
  if (is(OpKind::kSignExtend8To32)) return Pure(OpKind::kSignExtend8To16, {ValueId(inst.a)});
  return Pure(OpKind::kLowHalf32, {value});
}

ValueId ValueBuilder::High16(ValueId value) {
  const ir::Inst inst = program()[value];
  const auto is = [&inst](OpKind op) { return inst.op == op; };
  if (is(OpKind::kConst)) return Constant(Type::kI16, ir::ConstantValue(inst) >> 16 & 0xFFFF, inst.c);
  if (is(OpKind::kWiden16To32) || is(OpKind::kWiden8To32)) return Constant(0, 16);
  if (is(OpKind::kPair32)) return ValueId(inst.b);
  return Pure(OpKind::kHighHalf32, {value});
}

ValueId ValueBuilder::Low8(ValueId value) {
  const ir::Inst inst = program()[value];
  const auto is = [&inst](OpKind op) { return inst.op == op; };
  if (is(OpKind::kConst)) return Constant(Type::kI8, ir::ConstantValue(inst) & 0xFF, inst.c);
  if (is(OpKind::kWiden8To16) || is(OpKind::kSignExtend8To16) || is(OpKind::kPair16)) return ValueId(inst.a);
  if (is(OpKind::kWithLowByte16)) return ValueId(inst.b);
  return Pure(OpKind::kLowByte16, {value});
}

ValueId ValueBuilder::High8(ValueId value) {
  const ir::Inst inst = program()[value];
  const auto is = [&inst](OpKind op) { return inst.op == op; };
  if (is(OpKind::kConst)) return Constant(Type::kI8, ir::ConstantValue(inst) >> 8 & 0xFF, inst.c);
  if (is(OpKind::kWiden8To16)) return Byte(0);
  if (is(OpKind::kPair16)) return ValueId(inst.b);
  if (is(OpKind::kWithLowByte16)) return High8(ValueId(inst.a));
  return Pure(OpKind::kHighByte16, {value});
}

ValueId ValueBuilder::ToWidth(ValueId value, uint32_t width) {
  const uint32_t from = WidthOf(value);
  if (from == width) return value;
  if (const auto known = KnownValue(value)) return Constant(*known, width, program()[value].c);
  if (from == 32) return width == 16 ? Low16(value) : Low8(Low16(value));
  if (from == 16) return width == 8 ? Low8(value) : Pure(OpKind::kWiden16To32, {value});
  return Pure(width == 16 ? OpKind::kWiden8To16 : OpKind::kWiden8To32, {value});
}

ValueId ValueBuilder::SignedTo32(ValueId value) {
  const uint32_t from = WidthOf(value);
  if (from == 8) return Pure(OpKind::kSignExtend8To32, {value});
  return from == 16 ? Pure(OpKind::kSignExtend16To32, {value}) : value;
}

}  // namespace plcxx::technol
