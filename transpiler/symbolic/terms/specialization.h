// A term where some bits of variables are known: one way through a tree of elements, not all of them.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/terms/index_bits.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

class Specialization {
 public:
  /// `bits`: those that may be known, ascending, at most 32.
  Specialization(Terms& terms, TermId term, const std::vector<IndexBit>& bits);

  /// The term where these of the bits, by their places, are 1 and 0.
  TermId Where(uint32_t ones, uint32_t zeros);

 private:
  TermId Of(TermId id);

  Terms& terms_;
  TermId term_;
  const std::vector<IndexBit>& bits_;
  /// What the term is made of and depends on the bits: how many operands of operands down; looked up only.
  std::unordered_map<uint32_t, uint32_t> dependent_;
  std::unordered_map<uint32_t, TermId> known_;  // of one Where; looked up only
};

/// The term where these bits are what they are known to be.
TermId WhereKnown(Terms& terms, TermId term, const KnownIndexBits& known);

}  // namespace plcxx::terms
