// The least and the greatest value that an integer can have: of its type, and of operations whose operands have such
// bounds.
//
// Not its job: what is known at a place of a program (analysis/ranges.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

struct Bounds {
  int64_t low = 0, high = 0;  // both included
  bool operator==(const Bounds&) const = default;
  bool IsOne() const { return low == high; }
  bool Holds(int64_t value) const { return low <= value && value <= high; }
  bool Within(const Bounds& other) const { return other.low <= low && high <= other.high; }
};

/// The value that the low bits of a number are, as an integer type reads them.
int64_t Wrapped(int64_t value, const Type& type);

/// All values of an integer type.
Bounds BoundsOf(const Type& type);
/// All values that so many bits of a number have.
Bounds BoundsOf(uint32_t bits, bool is_signed);
constexpr Bounds Join(const Bounds& a, const Bounds& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
/// The values in both; none: there is none.
std::optional<Bounds> Meet(const Bounds& a, const Bounds& b);
/// Of an operation whose operands have these bounds, before it wraps; none: any value.
std::optional<Bounds> Apply(BinaryOp op, const Bounds& a, const Bounds& b, const Type& type);
/// Of the absolute value as the signed `type` keeps it; all its values where the least one, which has none, may be
/// among them, or what is not one of its values.
Bounds AbsoluteOf(const Bounds& bounds, const Type& type);

}  // namespace plcxx::hnc
