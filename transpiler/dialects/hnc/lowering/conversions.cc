#include "transpiler/dialects/hnc/lowering/conversions.h"

#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/dialects/hnc/syntax/bounds.h"
#include "transpiler/support/check.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

uint64_t Masked(int64_t value, uint32_t bits) { return static_cast<uint64_t>(value) & support::LowBits(bits); }

/// An operation of words whose low byte is that of an operation of bytes.
struct NarrowedOperation {
  OpKind word;
  OpKind byte;
  bool only_of_narrow;  // shorter only when both operands are bytes
};

constexpr NarrowedOperation kNarrowedOperations[] = {
    {OpKind::kAnd16, OpKind::kAnd8, false}, {OpKind::kOr16, OpKind::kOr8, false},
    {OpKind::kXor16, OpKind::kXor8, false}, {OpKind::kAdd16, OpKind::kAdd8, true},
    {OpKind::kSub16, OpKind::kSub8, true},
};

}  // namespace

Value Conversions::Make(ValueId id, TypeId type) {
  Value value{.id = id, .type = type, .is_bit = false, .bounds = {}};
  if (TypeAt(type).kind == TypeKind::kInteger) value.bounds = BoundsOf(TypeAt(type));
  return value;
}

Value Conversions::Number(int64_t number, TypeId type, uint32_t base) {
  const Type& of = TypeAt(type);
  const int64_t wrapped = Wrapped(number, of);
  Value value{.id = {}, .type = type, .is_bit = false, .bounds = {wrapped, wrapped}};
  // A negative int reads as such; its lowest value has no positive one.
  const bool minus =
      of.is_signed && base == 10 && of.bits > 8 && wrapped < 0 && wrapped > -(int64_t{1} << (of.bits - 1));
  const ValueId constant = builder_.Constant(IrType(type), Masked(minus ? -wrapped : wrapped, of.bits), base);
  value.id = !minus ? constant : Pure(of.bits == 16 ? OpKind::kMinus16 : OpKind::kMinus32, {constant});
  return value;
}

Value Conversions::Zero(TypeId type) {
  switch (TypeAt(type).kind) {
    case TypeKind::kInteger:
      return Number(0, type);
    case TypeKind::kReal:
      return Make(builder_.Constant(IrType(type), 0), type);
    case TypeKind::kVoid:
    case TypeKind::kPointer:
    case TypeKind::kArray:
    case TypeKind::kRecord:
    case TypeKind::kFunction:
      return Number(0, int_);
  }
  PLCXX_UNREACHABLE();
}

Value Conversions::FromBit(ValueId bit) { return {.id = bit, .type = int_, .is_bit = true, .bounds = {0, 1}}; }

ValueId Conversions::Narrow8(ValueId value) {
  const ir::Inst inst = program_[value];
  const auto is_narrow = [this](uint32_t word) {
    const OpKind op = program_[ValueId(word)].op;
    return op == OpKind::kWiden8To16 || op == OpKind::kSignExtend8To16 || op == OpKind::kConst;
  };
  for (const OpKind widening :
       {OpKind::kWiden8To16, OpKind::kSignExtend8To16, OpKind::kWiden8To32, OpKind::kSignExtend8To32}) {
    if (inst.op == widening) return ValueId(inst.a);
  }
  if (inst.op == OpKind::kConst && inst.type == ir::Type::kI16)
    return builder_.Constant(ir::Type::kI8, inst.a & 0xFF, inst.c);
  if (inst.op == OpKind::kMinus16 && program_[ValueId(inst.a)].op == OpKind::kConst)
    return builder_.Constant(ir::Type::kI8, (0x100 - (program_[ValueId(inst.a)].a & 0xFF)) & 0xFF);
  if (inst.op == OpKind::kSelect16 && is_narrow(inst.b) && is_narrow(inst.c))
    return Pure(OpKind::kSelect8, {ValueId(inst.a), Narrow8(ValueId(inst.b)), Narrow8(ValueId(inst.c))});
  if (inst.op == OpKind::kNot16) return Pure(OpKind::kNot8, {Narrow8(ValueId(inst.a))});
  for (const NarrowedOperation& row : kNarrowedOperations) {
    if (inst.op == row.word && (!row.only_of_narrow || (is_narrow(inst.a) && is_narrow(inst.b))))
      return Pure(row.byte, {Narrow8(ValueId(inst.a)), Narrow8(ValueId(inst.b))});
  }
  return Pure(inst.type == ir::Type::kI32 ? OpKind::kLowByte32 : OpKind::kLowByte16, {value});
}

ValueId Conversions::Narrow16(ValueId value) {
  const ir::Inst inst = program_[value];
  if (inst.op == OpKind::kSignExtend16To32 || inst.op == OpKind::kWiden16To32) return ValueId(inst.a);
  return Pure(OpKind::kLowHalf32, {value});
}

Value Conversions::ConvertInteger(const Value& value, TypeId to) {
  const Type& from_type = TypeAt(value.type);
  const Type& to_type = TypeAt(to);
  Value result{.id = value.id, .type = to, .is_bit = false, .bounds = value.bounds};
  if (!value.bounds.Within(BoundsOf(to_type))) result.bounds = BoundsOf(to_type);
  if (value.is_bit) {
    if (to_type.bits == 8) {
      result.id =
          Pure(OpKind::kSelect8, {value.id, builder_.Constant(ir::Type::kI8, 1), builder_.Constant(ir::Type::kI8, 0)});
    } else {
      result.id = Pure(to_type.bits == 32 ? OpKind::kWiden1To32 : OpKind::kWiden1To16, {value.id});
    }
    return result;
  }
  if (const std::optional<int64_t> known = KnownInteger(value)) {
    const uint32_t base = program_[value.id].op == OpKind::kConst ? program_[value.id].c : 10;
    return Number(*known, to, base);
  }
  // A number that is known not to be negative is the same word without its sign.
  const bool sign = from_type.is_signed && value.bounds.low < 0;
  if (from_type.is_signed && !sign && to_type.bits > from_type.bits) stated_.CheckBounds(ir::FactKind::kSign, value);
  if (to_type.bits < from_type.bits) {
    result.id = to_type.bits == 8 ? Narrow8(value.id) : Narrow16(value.id);
  } else if (from_type.bits == 8 && to_type.bits == 16) {
    result.id = Pure(sign ? OpKind::kSignExtend8To16 : OpKind::kWiden8To16, {value.id});
  } else if (from_type.bits == 8 && to_type.bits == 32) {
    result.id = Pure(sign ? OpKind::kSignExtend8To32 : OpKind::kWiden8To32, {value.id});
  } else if (from_type.bits == 16 && to_type.bits == 32) {
    result.id = Pure(sign ? OpKind::kSignExtend16To32 : OpKind::kWiden16To32, {value.id});
  }
  return result;
}

Value Conversions::Convert(const Value& value, TypeId to) {
  const Type& from_type = TypeAt(value.type);
  const Type& to_type = TypeAt(to);
  if (to_type.kind != TypeKind::kInteger && to_type.kind != TypeKind::kReal) return value;
  const bool from_real = from_type.kind == TypeKind::kReal, to_real = to_type.kind == TypeKind::kReal;
  if (!from_real && !to_real) return ConvertInteger(value, to);
  if (from_real && to_real) {
    if (from_type.bits == to_type.bits) return Make(value.id, to);
    return Make(Pure(from_type.bits == 32 ? OpKind::kWidenF32 : OpKind::kNarrowF64, {value.id}), to);
  }
  if (to_real) {
    const bool sign = from_type.is_signed;
    const Value wide = ConvertInteger(value, sign ? long_ : unsigned_long_);
    const ValueId real = Pure(sign ? OpKind::kSignedToF64 : OpKind::kUnsignedToF64, {wide.id});
    return Make(to_type.bits == 32 ? Pure(OpKind::kNarrowF64, {real}) : real, to);
  }
  const ValueId wide = from_type.bits == 32 ? Pure(OpKind::kWidenF32, {value.id}) : value.id;
  return ConvertInteger(Make(Pure(OpKind::kTruncateF64, {wide}), long_), to);
}

ValueId Conversions::AsBit(const Value& value) {
  if (value.is_bit) return value.id;
  const Type& type = TypeAt(value.type);
  if (type.kind == TypeKind::kReal) {
    const Value wide = Convert(value, double_);
    return Pure(OpKind::kNotEqualF64, {wide.id, builder_.Constant(ir::Type::kF64, 0)});
  }
  if (const std::optional<int64_t> known = KnownInteger(value)) return builder_.Bit(*known != 0 ? 1 : 0);
  const ir::Type ir_type = IrType(value.type);
  const ValueId zero = builder_.Constant(ir_type, 0);
  const OpKind op = ir_type == ir::Type::kI8    ? OpKind::kNotEqual8
                    : ir_type == ir::Type::kI16 ? OpKind::kNotEqual16
                                                : OpKind::kNotEqual32;
  return Pure(op, {value.id, zero});
}

ValueId Conversions::AsIndex(const Value& value) {
  if (value.is_bit) return Pure(OpKind::kWiden1To32, {value.id});
  return ConvertInteger(value, long_).id;
}

}  // namespace plcxx::hnc
