// Which bits of terms are known while only some bits of the variables are.
//
// In: what is known of the operands of a term. Out: what follows for the term; all of it holds for every value of the
// unknown bits, and what the operands have in common is not seen. Not its job: whose bits are known, and why.
#pragma once

#include <cstdint>
#include <functional>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

struct KnownBits {
  uint64_t zeros = 0, ones = 0;  // bits that are surely 0, surely 1; none is both
  bool operator==(const KnownBits&) const = default;
};

inline KnownBits AllKnown(uint64_t value, uint8_t width) { return {.zeros = Masked(~value, width), .ones = value}; }
inline bool IsKnown(KnownBits bits, uint8_t width) { return (bits.zeros | bits.ones) == Masked(~uint64_t{0}, width); }

/// `of(TermId)` gives what is known of the operands, `of_variable(number)` of a variable.
KnownBits KnownBitsOf(const Terms& terms, const Term& term, const std::function<KnownBits(TermId)>& of,
                      const std::function<KnownBits(uint32_t)>& of_variable);

}  // namespace plcxx::terms
