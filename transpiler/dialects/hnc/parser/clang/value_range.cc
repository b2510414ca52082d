#include "transpiler/dialects/hnc/parser/clang/value_range.h"

#include <limits>
#include <optional>

#include "transpiler/support/check.h"

namespace plcxx::hnc {
namespace {

// A chain of operators nests without limit, and each of them may ask.
constexpr int kDeepest = 8;

Bounds BoundsWithin(const Unit& unit, ExprId id, int depth);

/// As in mathematics; it may not fit into the type.
Bounds OfOperator(const Unit& unit, const Expr& expr, const Bounds& whole, int depth) {
  const Bounds a = BoundsWithin(unit, expr.a, depth), b = BoundsWithin(unit, expr.b, depth);
  if (const std::optional<Bounds> result = Apply(expr.binary, a, b, unit.types[expr.type])) return *result;
  // By whatever it is divided or shifted: it does not get a sign, and not greater.
  const bool becomes_less = expr.binary == BinaryOp::kRemainder || expr.binary == BinaryOp::kShiftRight ||
                            (expr.binary == BinaryOp::kDivide && b.low >= 0);
  return becomes_less && a.low >= 0 ? Bounds{0, a.high} : whole;
}

Bounds OfExpression(const Unit& unit, const Expr& expr, const Bounds& whole, int depth) {
  switch (expr.kind) {
    case ExprKind::kMember: {
      const Type& record = unit.types[unit.expressions[expr.a].type];
      const Member& member = unit.records[record.record].members[expr.member];
      return member.is_bit_field ? BoundsOf(member.bit_width, unit.types[member.type].is_signed) : whole;
    }
    case ExprKind::kLoad:
    case ExprKind::kConvert:
    case ExprKind::kIncrement:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
      return BoundsWithin(unit, expr.a, depth);
    case ExprKind::kComma:
      return BoundsWithin(unit, expr.b, depth);
    case ExprKind::kConditional:
      return Join(BoundsWithin(unit, expr.b, depth), BoundsWithin(unit, expr.c, depth));
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return {0, 1};
    case ExprKind::kUnary:
      if (expr.unary == UnaryOp::kNot) return {0, 1};
      return expr.unary == UnaryOp::kPlus ? BoundsWithin(unit, expr.a, depth) : whole;
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

Bounds BoundsWithin(const Unit& unit, ExprId id, int depth) {
  const Expr& expr = unit.expressions[id];
  const bool is_integer = expr.type.valid() && IsInteger(unit.types[expr.type]);
  if (!is_integer) return {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()};
  if (expr.constant) return {expr.constant->integer, expr.constant->integer};
  const Type& type = unit.types[expr.type];
  const Bounds whole = BoundsOf(type);
  if (depth == 0) return whole;
  const Bounds bounds = OfExpression(unit, expr, whole, depth - 1);
  return bounds.Within(whole) ? bounds : whole;
}

}  // namespace

Bounds ValueRangeOf(const Unit& unit, ExprId id) { return BoundsWithin(unit, id, kDeepest); }

}  // namespace plcxx::hnc
