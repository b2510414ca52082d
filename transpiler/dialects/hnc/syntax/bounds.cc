#include "transpiler/dialects/hnc/syntax/bounds.h"

#include <cstdlib>

#include "transpiler/support/low_bits.h"

namespace plcxx::hnc {

int64_t Wrapped(int64_t value, const Type& type) {
  const uint64_t raw = static_cast<uint64_t>(value) & support::LowBits(type.bits);
  const bool is_negative = type.is_signed && type.bits != 0 && (raw >> (type.bits - 1) & 1) != 0;
  return is_negative ? static_cast<int64_t>(raw) - (int64_t{1} << type.bits) : static_cast<int64_t>(raw);
}

Bounds BoundsOf(uint32_t bits, bool is_signed) {
  const int64_t count = int64_t{1} << bits;
  if (is_signed) return {-count / 2, count / 2 - 1};
  return {0, count - 1};
}

Bounds BoundsOf(const Type& type) { return BoundsOf(type.bits, type.is_signed); }

std::optional<Bounds> Meet(const Bounds& a, const Bounds& b) {
  const Bounds both{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (both.low > both.high) return std::nullopt;
  return both;
}

namespace {

Bounds Corners(const Bounds& a, const Bounds& b, int64_t (*apply)(int64_t, int64_t)) {
  const int64_t corners[] = {apply(a.low, b.low), apply(a.low, b.high), apply(a.high, b.low), apply(a.high, b.high)};
  return {*std::ranges::min_element(corners), *std::ranges::max_element(corners)};
}

/// The product of two factors up to this is one that an int64_t holds; that of two double words without sign is not.
constexpr int64_t kMaxFactor = int64_t{1} << 31;
int64_t Magnitude(const Bounds& bounds) { return std::max(std::abs(bounds.low), std::abs(bounds.high)); }

/// The least number of all ones that is not below `value`.
int64_t Ones(int64_t value) {
  int64_t ones = 0;
  while (ones < value) ones = ones * 2 + 1;
  return ones;
}

/// The bits that some value within these bounds has; `bounds` are not below 0.
int64_t MayBeSet(const Bounds& bounds) { return bounds.IsOne() ? bounds.high : Ones(bounds.high); }

std::optional<Bounds> Remainder(const Bounds& a, const Bounds& b) {
  if (b.Holds(0)) return std::nullopt;
  const int64_t most = std::max(std::abs(b.low), std::abs(b.high)) - 1;
  return Bounds{a.low < 0 ? std::max(-most, a.low) : 0, a.high > 0 ? std::min(most, a.high) : 0};
}

}  // namespace

Bounds AbsoluteOf(const Bounds& bounds, const Type& type) {
  const Bounds all = BoundsOf(type);
  if (bounds.low <= all.low || bounds.high > all.high) return all;
  const int64_t least = bounds.Holds(0) ? 0 : std::min(std::abs(bounds.low), std::abs(bounds.high));
  return {least, Magnitude(bounds)};
}

std::optional<Bounds> Apply(BinaryOp op, const Bounds& a, const Bounds& b, const Type& type) {
  const bool positive = a.low >= 0 && b.low >= 0;
  switch (op) {
    case BinaryOp::kAdd:
      return Bounds{a.low + b.low, a.high + b.high};
    case BinaryOp::kSubtract:
      return Bounds{a.low - b.high, a.high - b.low};
    case BinaryOp::kMultiply:
      if (Magnitude(a) > kMaxFactor || Magnitude(b) > kMaxFactor) return std::nullopt;
      return Corners(a, b, [](int64_t x, int64_t y) { return x * y; });
    case BinaryOp::kDivide:
      if (b.Holds(0)) return std::nullopt;
      return Corners(a, b, [](int64_t x, int64_t y) { return x / y; });
    case BinaryOp::kRemainder:
      return Remainder(a, b);
    case BinaryOp::kShiftLeft:
      if (b.low < 0 || b.high >= type.bits || a.low < 0) return std::nullopt;
      return Bounds{a.low << b.low, a.high << b.high};
    case BinaryOp::kShiftRight:
      if (b.low < 0 || b.high >= type.bits || a.low < 0) return std::nullopt;
      return Bounds{a.low >> b.high, a.high >> b.low};
    case BinaryOp::kBitAnd:
      if (positive) return Bounds{0, std::min({a.high, b.high, MayBeSet(a) & MayBeSet(b)})};
      if (a.low >= 0) return Bounds{0, a.high};
      if (b.low >= 0) return Bounds{0, b.high};
      return std::nullopt;
    case BinaryOp::kBitOr:
      if (!positive) return std::nullopt;
      return Bounds{std::max(a.low, b.low), Ones(std::max(a.high, b.high))};
    case BinaryOp::kBitXor:
      if (!positive) return std::nullopt;
      return Bounds{0, Ones(std::max(a.high, b.high))};
    case BinaryOp::kLess:
    case BinaryOp::kGreater:
    case BinaryOp::kLessEqual:
    case BinaryOp::kGreaterEqual:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
      return Bounds{0, 1};
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      break;
  }
  return std::nullopt;
}

}  // namespace plcxx::hnc
