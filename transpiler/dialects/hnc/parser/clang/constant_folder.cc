#include "transpiler/dialects/hnc/parser/clang/constant_folder.h"

#include <cmath>
#include <type_traits>

#include "transpiler/dialects/hnc/syntax/bounds.h"

namespace plcxx::hnc {
namespace {

Constant OfInteger(int64_t value) { return {.integer = value, .real = 0}; }
Constant OfReal(double value) { return {.integer = 0, .real = value}; }

bool IsTrue(const Constant& value, const Type& type) {
  return type.kind == TypeKind::kReal ? value.real != 0 : value.integer != 0;
}

int64_t Shifted(int64_t value, int64_t count, const Type& type, bool left) {
  // An 8086 counts modulo 32 in 16-bit operations; the helpers for long do not.
  int64_t distance = count & 0xFF;
  if (type.bits == 16) distance %= 32;
  if (distance >= type.bits) return !left && type.is_signed && value < 0 ? -1 : 0;
  return left ? Wrapped(static_cast<int64_t>(static_cast<uint64_t>(value) << distance), type) : value >> distance;
}

template <class Number>
std::optional<bool> Compared(BinaryOp op, Number a, Number b) {
  switch (op) {
    case BinaryOp::kLess:
      return a < b;
    case BinaryOp::kGreater:
      return a > b;
    case BinaryOp::kLessEqual:
      return a <= b;
    case BinaryOp::kGreaterEqual:
      return a >= b;
    case BinaryOp::kEqual:
      return a == b;
    case BinaryOp::kNotEqual:
      return a != b;
#define HNC_COMPARISON(...)
#define HNC_BINARY(Key, ...) case BinaryOp::k##Key:
#include "transpiler/dialects/hnc/syntax/binary_operators.def"
      break;
  }
  return std::nullopt;
}

/// Integers are not wrapped: they fit into 33 bits, so nothing overflows but products, which wrap in 64 bits to the
/// same low bits.
template <class Number>
std::optional<Number> Computed(BinaryOp op, Number a, Number b) {
  constexpr bool kIsReal = std::is_floating_point_v<Number>;
  switch (op) {
    case BinaryOp::kAdd:
      return a + b;
    case BinaryOp::kSubtract:
      return a - b;
    case BinaryOp::kMultiply:
      if constexpr (kIsReal) {
        return a * b;
      } else {
        return static_cast<Number>(static_cast<uint64_t>(a) * static_cast<uint64_t>(b));
      }
    case BinaryOp::kDivide:
      return kIsReal || b != 0 ? std::optional(a / b) : std::nullopt;
    case BinaryOp::kRemainder:
      if constexpr (!kIsReal) return b == 0 ? std::nullopt : std::optional(a % b);
      break;
    case BinaryOp::kBitAnd:
      if constexpr (!kIsReal) return a & b;
      break;
    case BinaryOp::kBitXor:
      if constexpr (!kIsReal) return a ^ b;
      break;
    case BinaryOp::kBitOr:
      if constexpr (!kIsReal) return a | b;
      break;
#define HNC_BINARY(...)
#define HNC_COMPARISON(Key, ...) case BinaryOp::k##Key:
#include "transpiler/dialects/hnc/syntax/binary_operators.def"
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Constant> Converted(const Constant& value, const Type& from, const Type& to) {
  if (to.kind == TypeKind::kReal) {
    const double real = from.kind == TypeKind::kReal ? value.real : static_cast<double>(value.integer);
    return OfReal(to.bits == 32 ? static_cast<double>(static_cast<float>(real)) : real);
  }
  if (to.kind != TypeKind::kInteger) return std::nullopt;
  if (from.kind != TypeKind::kReal) return OfInteger(Wrapped(value.integer, to));
  constexpr double kLimit = 9223372036854775808.0;  // 2^63
  if (!(std::fabs(value.real) < kLimit)) return OfInteger(0);
  return OfInteger(Wrapped(static_cast<int64_t>(value.real), to));
}

std::optional<Constant> ConstantFolder::FoldUnary(const Expr& expr) const {
  const Expr& a = unit_.expressions[expr.a];
  if (!a.constant) return std::nullopt;
  const Type& type = unit_.types[expr.type];
  if (expr.unary == UnaryOp::kNot) return OfInteger(IsTrue(*a.constant, unit_.types[a.type]) ? 0 : 1);
  if (type.kind == TypeKind::kReal) {
    return OfReal(expr.unary == UnaryOp::kMinus ? -a.constant->real : a.constant->real);
  }
  const int64_t value = a.constant->integer;
  if (expr.unary == UnaryOp::kMinus) return OfInteger(Wrapped(-value, type));
  return OfInteger(expr.unary == UnaryOp::kComplement ? Wrapped(~value, type) : value);
}

std::optional<Constant> ConstantFolder::FoldBinary(const Expr& expr) {
  const Expr& left = unit_.expressions[expr.a];
  const Expr& right = unit_.expressions[expr.b];
  if (!left.constant || !right.constant) return std::nullopt;
  const Type& operands = unit_.types[left.type];
  const Type& type = unit_.types[expr.type];
  if (operands.kind == TypeKind::kReal) {
    if (const auto truth = Compared(expr.binary, left.constant->real, right.constant->real)) return OfInteger(*truth);
    const auto real = Computed(expr.binary, left.constant->real, right.constant->real);
    return real ? std::optional(OfReal(*real)) : std::nullopt;
  }
  if (operands.kind != TypeKind::kInteger) return std::nullopt;
  const int64_t a = left.constant->integer, b = right.constant->integer;
  if (const auto truth = Compared(expr.binary, a, b)) return OfInteger(*truth);
  if (expr.binary == BinaryOp::kShiftLeft || expr.binary == BinaryOp::kShiftRight) {
    return OfInteger(Shifted(a, b, type, expr.binary == BinaryOp::kShiftLeft));
  }
  const std::optional<int64_t> exact = Computed(expr.binary, a, b);
  if (!exact) return std::nullopt;
  const int64_t wrapped = Wrapped(*exact, type);
  if (wrapped != *exact && type.is_signed && expr.range.begin != 0) {
    findings().Report(expr.range, diag::HncConstantOverflow, std::to_string(wrapped));
  }
  return OfInteger(wrapped);
}

void ConstantFolder::Fold(Expr& expr) {
  const auto constant = [&](ExprId id) { return unit_.expressions[id].constant; };
  const auto type = [&](ExprId id) -> const Type& { return unit_.types[unit_.expressions[id].type]; };
  switch (expr.kind) {
    case ExprKind::kConvert:
      if (const auto value = constant(expr.a)) expr.constant = Converted(*value, type(expr.a), unit_.types[expr.type]);
      return;
    case ExprKind::kUnary:
      expr.constant = FoldUnary(expr);
      return;
    case ExprKind::kBinary:
      expr.constant = FoldBinary(expr);
      return;
    case ExprKind::kAnd:
    case ExprKind::kOr: {
      const auto left = constant(expr.a);
      if (!left) return;
      const bool decides = IsTrue(*left, type(expr.a)) == (expr.kind == ExprKind::kOr);
      if (decides) expr.constant = OfInteger(expr.kind == ExprKind::kOr ? 1 : 0);
      const auto right = constant(expr.b);
      if (!decides && right) expr.constant = OfInteger(IsTrue(*right, type(expr.b)) ? 1 : 0);
      return;
    }
    case ExprKind::kConditional:
      if (const auto condition = constant(expr.a)) {
        if (IsArithmetic(unit_.types[expr.type]))
          expr.constant = constant(IsTrue(*condition, type(expr.a)) ? expr.b : expr.c);
      }
      return;
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kLoad:
    case ExprKind::kDecay:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kComma:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
    case ExprKind::kCall:
      return;
  }
}

bool ConstantFolder::HasWildShift(ExprId id) const {
  if (!id.valid()) return false;
  const Expr& expr = unit_.expressions[id];
  const bool shifts =
      expr.kind == ExprKind::kBinary && (expr.binary == BinaryOp::kShiftLeft || expr.binary == BinaryOp::kShiftRight);
  if (shifts && unit_.expressions[expr.b].constant) {
    const int64_t count = unit_.expressions[expr.b].constant->integer;
    if (count < 0 || count >= unit_.types[expr.type].bits) return true;
  }
  return HasWildShift(expr.a) || HasWildShift(expr.b) || HasWildShift(expr.c);
}

}  // namespace plcxx::hnc
