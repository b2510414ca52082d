#include "transpiler/dialects/hnc/parser/clang/value_range.h"

#include <algorithm>
#include <limits>

#include "transpiler/support/check.h"

namespace plcxx::hnc {
namespace {

// A chain of operators nests without limit, and each of them may ask.
constexpr int kDeepest = 8;
constexpr int64_t kMostOfWord = 0xFFFF;

ValueRange OfInteger(unsigned bits, bool is_signed) {
  const int64_t values = int64_t{1} << bits;
  return is_signed ? ValueRange{-values / 2, values / 2 - 1} : ValueRange{0, values - 1};
}

bool FitsInto(ValueRange inner, ValueRange outer) { return inner.least >= outer.least && inner.most <= outer.most; }

ValueRange RangeWithin(const Unit& unit, ExprId id, int depth);

/// As in mathematics; it may not fit into the type.
ValueRange OfOperator(const Unit& unit, const Expr& expr, ValueRange whole, int depth) {
  if (IsComparison(expr.binary)) return {0, 1};
  const ValueRange a = RangeWithin(unit, expr.a, depth), b = RangeWithin(unit, expr.b, depth);
  switch (expr.binary) {
    case BinaryOp::kAdd:
      return {a.least + b.least, a.most + b.most};
    case BinaryOp::kSubtract:
      return {a.least - b.most, a.most - b.least};
    case BinaryOp::kBitAnd:
      if (a.least < 0 && b.least < 0) return whole;
      return {0, a.least < 0 ? b.most : b.least < 0 ? a.most : std::min(a.most, b.most)};
    case BinaryOp::kMultiply:
      if (a.least < 0 || b.least < 0 || a.most > kMostOfWord || b.most > kMostOfWord) return whole;
      return {0, a.most * b.most};
    case BinaryOp::kDivide:
      return a.least >= 0 && b.least >= 0 ? ValueRange{0, a.most} : whole;
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftRight:
      return a.least >= 0 ? ValueRange{0, a.most} : whole;
    case BinaryOp::kShiftLeft:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
    case BinaryOp::kLess:
    case BinaryOp::kGreater:
    case BinaryOp::kLessEqual:
    case BinaryOp::kGreaterEqual:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
      return whole;
  }
  PLCXX_UNREACHABLE();
}

ValueRange OfExpression(const Unit& unit, const Expr& expr, ValueRange whole, int depth) {
  switch (expr.kind) {
    case ExprKind::kMember: {
      const Type& record = unit.types[unit.expressions[expr.a].type];
      const Member& member = unit.records[record.record].members[expr.member];
      return member.is_bit_field ? OfInteger(member.bit_width, unit.types[member.type].is_signed) : whole;
    }
    case ExprKind::kLoad:
    case ExprKind::kConvert:
    case ExprKind::kIncrement:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
      return RangeWithin(unit, expr.a, depth);
    case ExprKind::kComma:
      return RangeWithin(unit, expr.b, depth);
    case ExprKind::kConditional: {
      const ValueRange b = RangeWithin(unit, expr.b, depth), c = RangeWithin(unit, expr.c, depth);
      return {std::min(b.least, c.least), std::max(b.most, c.most)};
    }
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return {0, 1};
    case ExprKind::kUnary:
      if (expr.unary == UnaryOp::kNot) return {0, 1};
      return expr.unary == UnaryOp::kPlus ? RangeWithin(unit, expr.a, depth) : whole;
    case ExprKind::kBinary:
      return OfOperator(unit, expr, whole, depth);
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kDecay:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kCall:
      return whole;
  }
  PLCXX_UNREACHABLE();
}

ValueRange RangeWithin(const Unit& unit, ExprId id, int depth) {
  const Expr& expr = unit.expressions[id];
  const bool is_integer = expr.type.valid() && IsInteger(unit.types[expr.type]);
  if (!is_integer) return {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()};
  if (expr.constant) return {expr.constant->integer, expr.constant->integer};
  const Type& type = unit.types[expr.type];
  const ValueRange whole = OfInteger(type.bits, type.is_signed);
  if (depth == 0) return whole;
  const ValueRange range = OfExpression(unit, expr, whole, depth - 1);
  return FitsInto(range, whole) ? range : whole;
}

}  // namespace

ValueRange ValueRangeOf(const Unit& unit, ExprId id) { return RangeWithin(unit, id, kDeepest); }

}  // namespace plcxx::hnc
