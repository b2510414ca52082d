// Divisions by constants as compilers write them, recognized: one spelling for both sides.
//
// Not its job: to recognize signed divisions, and divisors that are powers of two (terms.cc).
#pragma once

#include <cstdint>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Quotients and remainders, of signed numbers as well.
constexpr bool IsDivision(TermKind kind) {
  return kind == TermKind::kUdiv || kind == TermKind::kUrem || kind == TermKind::kSdiv || kind == TermKind::kSrem;
}

/// What a solver does bit by bit.
constexpr bool IsLaborious(TermKind kind) { return kind == TermKind::kMul || IsDivision(kind); }

/// x * m >> shift where that is x / d for every x; else none. `product` is the product.
TermId QuotientOfProduct(Terms& terms, TermId product, uint8_t shift);

/// x - d * (x / d), or the low bits of all of it, as those of x % d; else none.
TermId RemainderOfSum(Terms& terms, TermId a, TermId b);

/// The width in which compilers divide a number that is never above `greatest`: a byte, or a power of two of bits.
uint8_t WidthOfDivision(uint64_t greatest);

/// No value of the term is above it: what zeros above, clamps and divisions say of it.
uint64_t GreatestOf(const Terms& terms, TermId id);

}  // namespace plcxx::terms
