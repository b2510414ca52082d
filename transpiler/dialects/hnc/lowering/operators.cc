#include "transpiler/dialects/hnc/lowering/operators.h"

#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

/// The operation of 16 and of 32 bits.
struct Widths {
  OpKind of16, of32;
  OpKind For(const Type& type) const { return type.bits == 32 ? of32 : of16; }
};

constexpr Widths kAdd{OpKind::kAdd16, OpKind::kAdd32}, kSubtract{OpKind::kSub16, OpKind::kSub32},
    kMultiply{OpKind::kMul16, OpKind::kMul32}, kAnd{OpKind::kAnd16, OpKind::kAnd32}, kOr{OpKind::kOr16, OpKind::kOr32},
    kXor{OpKind::kXor16, OpKind::kXor32}, kEqual{OpKind::kEqual16, OpKind::kEqual32},
    kNotEqual{OpKind::kNotEqual16, OpKind::kNotEqual32}, kLess{OpKind::kLess16, OpKind::kLess32},
    kLessEqual{OpKind::kLessEqual16, OpKind::kLessEqual32}, kGreater{OpKind::kGreater16, OpKind::kGreater32},
    kGreaterEqual{OpKind::kGreaterEqual16, OpKind::kGreaterEqual32},
    kSignedLess{OpKind::kSignedLess16, OpKind::kSignedLess32},
    kSignedLessEqual{OpKind::kSignedLessEqual16, OpKind::kSignedLessEqual32},
    kSignedGreater{OpKind::kSignedGreater16, OpKind::kSignedGreater32},
    kSignedGreaterEqual{OpKind::kSignedGreaterEqual16, OpKind::kSignedGreaterEqual32},
    kSignedDivide{OpKind::kSignedDiv16, OpKind::kSignedDiv32},
    kUnsignedDivide{OpKind::kUnsignedDiv16, OpKind::kUnsignedDiv32},
    kSignedRemainder{OpKind::kSignedRem16, OpKind::kSignedRemOrZero32},
    kUnsignedRemainder{OpKind::kUnsignedRem16, OpKind::kUnsignedRemOrZero32};

OpKind ComparisonOf(BinaryOp op, const Type& type, bool with_sign) {
  switch (op) {
    case BinaryOp::kLess:
      return (with_sign ? kSignedLess : kLess).For(type);
    case BinaryOp::kGreater:
      return (with_sign ? kSignedGreater : kGreater).For(type);
    case BinaryOp::kLessEqual:
      return (with_sign ? kSignedLessEqual : kLessEqual).For(type);
    case BinaryOp::kGreaterEqual:
      return (with_sign ? kSignedGreaterEqual : kGreaterEqual).For(type);
    case BinaryOp::kEqual:
      return kEqual.For(type);
    case BinaryOp::kNotEqual:
      return kNotEqual.For(type);
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      break;
  }
  PLCXX_UNREACHABLE();
}

/// The outcome of a comparison that the bounds decide.
std::optional<bool> Outcome(BinaryOp op, const Bounds& a, const Bounds& b) {
  switch (op) {
    case BinaryOp::kLess:
      if (a.high < b.low) return true;
      if (a.low >= b.high) return false;
      break;
    case BinaryOp::kGreater:
      return Outcome(BinaryOp::kLess, b, a);
    case BinaryOp::kLessEqual:
      if (a.high <= b.low) return true;
      if (a.low > b.high) return false;
      break;
    case BinaryOp::kGreaterEqual:
      return Outcome(BinaryOp::kLessEqual, b, a);
    case BinaryOp::kEqual:
      if (a.IsOne() && a == b) return true;
      if (a.high < b.low || b.high < a.low) return false;
      break;
    case BinaryOp::kNotEqual:
      if (const std::optional<bool> equal = Outcome(BinaryOp::kEqual, a, b)) return !*equal;
      break;
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      break;
  }
  return std::nullopt;
}

}  // namespace

Value Operators::Compare(BinaryOp op, const Value& a, const Value& b) {
  const Type& type = TypeAt(a.type);
  if (type.kind == TypeKind::kReal) return BinaryReal(op, a, b);
  stated_.CheckBounds(ir::FactKind::kComparison, a);
  stated_.CheckBounds(ir::FactKind::kComparison, b);
  // Decided by the types alone: compilers would warn of the comparison.
  if (const std::optional<bool> known = Outcome(op, a.bounds, b.bounds)) {
    return conversions_.FromBit(builder_.Bit(*known ? 1 : 0));
  }
  const Value x = conversions_.ConvertInteger(a, a.type), y = conversions_.ConvertInteger(b, b.type);
  const bool with_sign = type.is_signed && (a.bounds.low < 0 || b.bounds.low < 0);
  return conversions_.FromBit(Pure(ComparisonOf(op, type, with_sign), {x.id, y.id}));
}

Value Operators::BinaryReal(BinaryOp op, const Value& left, const Value& right) {
  const Value a = conversions_.Convert(left, double_), b = conversions_.Convert(right, double_);
  const auto plain = [&](OpKind kind) { return conversions_.Make(Pure(kind, {a.id, b.id}), a.type); };
  const auto compare = [&](OpKind kind) { return conversions_.FromBit(Pure(kind, {a.id, b.id})); };
  switch (op) {
    case BinaryOp::kAdd:
      return plain(OpKind::kAddF64);
    case BinaryOp::kSubtract:
      return plain(OpKind::kSubF64);
    case BinaryOp::kMultiply:
      return plain(OpKind::kMulF64);
    case BinaryOp::kDivide:
      return plain(OpKind::kDivF64);
    case BinaryOp::kLess:
      return compare(OpKind::kLessF64);
    case BinaryOp::kGreater:
      return compare(OpKind::kGreaterF64);
    case BinaryOp::kLessEqual:
      return compare(OpKind::kLessEqualF64);
    case BinaryOp::kGreaterEqual:
      return compare(OpKind::kGreaterEqualF64);
    case BinaryOp::kEqual:
      return compare(OpKind::kEqualF64);
    case BinaryOp::kNotEqual:
      return compare(OpKind::kNotEqualF64);
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      return a;  // refused by the front end
  }
  PLCXX_UNREACHABLE();
}

/// Division by zero, and the lowest int by -1, which an 8086 traps (6.2).
Value Operators::Divide(BinaryOp op, const Value& a, const Value& b, const Expr& at) {
  const Type& type = TypeAt(a.type);
  if (KnownInteger(b) == 0) {
    diagnostics_.Report(at.range, diag::HncDivisionByZero);
    return conversions_.Zero(a.type);
  }
  const Bounds all = BoundsOf(type);
  stated_.CheckBounds(ir::FactKind::kDivision, a);
  stated_.CheckBounds(ir::FactKind::kDivision, b);
  ValueId traps;
  if (b.bounds.Holds(0)) {
    traps = Pure(kEqual.For(type), {b.id, builder_.Constant(IrType(b.type), 0)});
  }
  if (type.is_signed && type.bits == 16 && a.bounds.Holds(all.low) && b.bounds.Holds(-1)) {
    const ValueId lowest = Pure(OpKind::kEqual16, {a.id, builder_.Constant(ir::Type::kI16, 0x8000, 16)});
    const ValueId minus = Pure(OpKind::kEqual16, {b.id, builder_.Constant(ir::Type::kI16, 0xFFFF, 16)});
    const ValueId overflow = Pure(OpKind::kBitAnd, {lowest, minus});
    traps = traps.valid() ? Pure(OpKind::kBitOr, {traps, overflow}) : overflow;
  }
  if (traps.valid()) faults_.RecordWhen(traps, Fault::kDivision);
  const bool with_sign = type.is_signed && (a.bounds.low < 0 || b.bounds.low < 0);
  const Widths& widths = op == BinaryOp::kDivide ? (with_sign ? kSignedDivide : kUnsignedDivide)
                                                 : (with_sign ? kSignedRemainder : kUnsignedRemainder);
  Value result = conversions_.Make(Pure(widths.For(type), {a.id, b.id}), a.type);
  if (const std::optional<Bounds> bounds = Apply(op, a.bounds, b.bounds, type)) {
    if (bounds->Within(all)) result.bounds = *bounds;
  }
  return result;
}

/// The count is a byte, of which an 8086 takes five bits for words (6.2, D33).
Value Operators::Shift(BinaryOp op, const Value& a, const Value& b, const Expr& at) {
  const Type& type = TypeAt(a.type);
  const bool left = op == BinaryOp::kShiftLeft, wide = type.bits == 32;
  const std::optional<int64_t> known = KnownInteger(b);
  if (known && (*known < 0 || *known >= type.bits)) {
    diagnostics_.Report(at.range, diag::HncShiftCount, *known, type.bits - 1);
  }
  stated_.CheckBounds(ir::FactKind::kShift, a);
  stated_.CheckBounds(ir::FactKind::kShift, b);
  ValueId count;
  const int64_t most = wide ? 0xFF : 0x1F;
  const ir::Type count_type = wide ? ir::Type::kI32 : ir::Type::kI16;
  if (known) {
    count = builder_.Constant(count_type, static_cast<uint64_t>(*known & most));
  } else {
    count = conversions_.ConvertInteger(b, wide ? unsigned_long_ : unsigned_).id;  // of its sign nothing is left
    if (!Bounds{0, most}.Holds(b.bounds.low) || !Bounds{0, most}.Holds(b.bounds.high)) {
      const ValueId mask = builder_.Constant(count_type, static_cast<uint64_t>(most));
      count = Pure(wide ? OpKind::kAnd32 : OpKind::kAnd16, {count, mask});
    }
  }
  const bool copies_sign = !left && type.is_signed && a.bounds.low < 0;
  const OpKind kind = left          ? (wide ? OpKind::kShiftLeft32 : OpKind::kShiftLeft16)
                      : copies_sign ? (wide ? OpKind::kArithmeticShiftRight32 : OpKind::kArithmeticShiftRight16)
                                    : (wide ? OpKind::kShiftRight32 : OpKind::kShiftRight16);
  Value result = conversions_.Make(Pure(kind, {a.id, count}), a.type);
  if (const std::optional<Bounds> bounds = Apply(op, a.bounds, b.bounds, type)) {
    if (bounds->Within(BoundsOf(type))) result.bounds = *bounds;
  }
  return result;
}

/// A mask that constants made reads best in hexadecimal.
Value Operators::AsMask(const Value& value) {
  const std::optional<int64_t> known = KnownInteger(value);
  if (!known || (*known >= 0 && *known < 10)) return value;
  return conversions_.Number(*known, value.type, 16);
}

Value Operators::BinaryInteger(BinaryOp op, const Value& left, const Value& right, const Expr& at) {
  const bool masks = op == BinaryOp::kBitAnd || op == BinaryOp::kBitOr || op == BinaryOp::kBitXor;
  const Value a = masks ? AsMask(left) : left, b = masks ? AsMask(right) : right;
  const Type& type = TypeAt(a.type);
  const Widths* widths = nullptr;
  switch (op) {
    case BinaryOp::kAdd:
      widths = &kAdd;
      break;
    case BinaryOp::kSubtract:
      widths = &kSubtract;
      break;
    case BinaryOp::kMultiply:
      widths = &kMultiply;
      break;
    case BinaryOp::kBitAnd:
      widths = &kAnd;
      break;
    case BinaryOp::kBitOr:
      widths = &kOr;
      break;
    case BinaryOp::kBitXor:
      widths = &kXor;
      break;
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
      return Divide(op, a, b, at);
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
      return Shift(op, a, b, at);
    case BinaryOp::kLess:
    case BinaryOp::kGreater:
    case BinaryOp::kLessEqual:
    case BinaryOp::kGreaterEqual:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      return Compare(op, a, b);
  }
  Value result = conversions_.Make(Pure(widths->For(type), {a.id, b.id}), a.type);
  if (const std::optional<Bounds> bounds = Apply(op, a.bounds, b.bounds, type)) {
    if (bounds->Within(BoundsOf(type))) result.bounds = *bounds;
  }
  return result;
}

Value Operators::Binary(BinaryOp op, const Value& a, const Value& b, const Expr& at) {
  // Two truth values combined bit by bit stay one.
  if (a.is_bit && b.is_bit) {
    if (op == BinaryOp::kBitAnd) return conversions_.FromBit(Pure(OpKind::kBitAnd, {a.id, b.id}));
    if (op == BinaryOp::kBitOr) return conversions_.FromBit(Pure(OpKind::kBitOr, {a.id, b.id}));
    if (op == BinaryOp::kBitXor || op == BinaryOp::kNotEqual)
      return conversions_.FromBit(Pure(OpKind::kBitXor, {a.id, b.id}));
  }
  if (a.is_bit && (op == BinaryOp::kEqual || op == BinaryOp::kNotEqual)) {
    // (x > 3) == 0: the truth value itself, or its opposite.
    const std::optional<int64_t> known = b.is_bit ? std::nullopt : KnownInteger(b);
    if (known == 0 || known == 1) {
      const bool same = (*known == 1) == (op == BinaryOp::kEqual);
      return conversions_.FromBit(same ? a.id : Pure(OpKind::kBitNot, {a.id}));
    }
  }
  if (TypeAt(a.type).kind == TypeKind::kReal) return BinaryReal(op, a, b);
  const Value x = a.is_bit ? conversions_.ConvertInteger(a, a.type) : a,
              y = b.is_bit ? conversions_.ConvertInteger(b, b.type) : b;
  return BinaryInteger(op, x, y, at);
}

Value Operators::Unary(UnaryOp op, const Value& a) {
  if (op == UnaryOp::kNot) return conversions_.FromBit(Pure(OpKind::kBitNot, {conversions_.AsBit(a)}));
  if (op == UnaryOp::kPlus) return a;
  const Type& type = TypeAt(a.type);
  if (type.kind == TypeKind::kReal) {
    const Value wide = conversions_.Convert(a, double_);
    return conversions_.Convert(conversions_.Make(Pure(OpKind::kNegateF64, {wide.id}), double_), a.type);
  }
  const Value number = conversions_.ConvertInteger(a, a.type);
  const bool wide = type.bits == 32, minus = op == UnaryOp::kMinus;
  const OpKind kind = minus ? (wide ? OpKind::kMinus32 : OpKind::kMinus16) : (wide ? OpKind::kNot32 : OpKind::kNot16);
  Value result = conversions_.Make(Pure(kind, {number.id}), a.type);
  const Bounds bounds = minus ? Bounds{-a.bounds.high, -a.bounds.low} : Bounds{~a.bounds.high, ~a.bounds.low};
  if (bounds.Within(result.bounds)) result.bounds = bounds;
  return result;
}

Value Operators::SelectValue(ValueId condition, const Value& a, const Value& b, TypeId type) {
  if (a.is_bit && b.is_bit) return conversions_.FromBit(Pure(OpKind::kSelect1, {condition, a.id, b.id}));
  const Value x = conversions_.Convert(a, type), y = conversions_.Convert(b, type);
  OpKind op = OpKind::kSelect16;
  switch (IrType(type)) {
    case ir::Type::kI8:
      op = OpKind::kSelect8;
      break;
    case ir::Type::kI32:
      op = OpKind::kSelect32;
      break;
    case ir::Type::kF64:
      op = OpKind::kSelectF64;
      break;
    case ir::Type::kF32: {
      const Value wide_y = conversions_.Convert(y, double_);
      const Value wide_x = conversions_.Convert(x, double_);
      const Value wide = SelectValue(condition, wide_x, wide_y, double_);
      return conversions_.Convert(wide, type);
    }
    case ir::Type::kNone:
    case ir::Type::kBit:
    case ir::Type::kI16:
    case ir::Type::kI64:
      break;
  }
  Value result = conversions_.Make(Pure(op, {condition, x.id, y.id}), type);
  if (TypeAt(type).kind == TypeKind::kInteger) result.bounds = Join(x.bounds, y.bounds);
  return result;
}

}  // namespace plcxx::hnc
