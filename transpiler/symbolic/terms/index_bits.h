// What an index is made of, looked at bit by bit: the same for every way to compute it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// A bit of a variable, or of a function's result.
struct IndexBit {
  TermId of;
  uint8_t number = 0;
  auto operator<=>(const IndexBit&) const = default;
};

struct IndexBits {
  std::vector<IndexBit> bits;    // ascending
  std::vector<uint64_t> values;  // of the index, for every value of the bits; the first bit is the least significant
};

/// None: there are too many.
std::optional<IndexBits> IndexBitsOf(const Terms& terms, TermId index);
/// Bits of which a condition says what they are.
struct KnownIndexBits {
  std::vector<IndexBit> bits;    // ascending
  uint32_t ones = 0, zeros = 0;  // by their places
};
/// At most 32 of them: those that parts of the condition are about, each by itself.
KnownIndexBits KnownWhere(const Terms& terms, TermId condition);
/// Which values of the bits a condition leaves possible: the parts of it that are about these bits alone are looked at.
std::vector<bool> PossibleWhere(const Terms& terms, TermId condition, const std::vector<IndexBit>& bits);

}  // namespace plcxx::terms
