// Which values a term can have, roughly: an arithmetic progression. It says which bytes an index can reach.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify::llvm_ir {

/// low, low + step, ..., high, as unsigned numbers; step 0: one value.
struct ValueRange {
  uint64_t low = 0, high = 0, step = 0;
};

class ValueRanges {
 public:
  explicit ValueRanges(const terms::Terms& terms) : terms_(terms) {}
  ValueRange Of(terms::TermId term);

 private:
  ValueRange Compute(const terms::Term& term);
  ValueRange OfProduct(const terms::Term& term, ValueRange a, ValueRange b) const;
  ValueRange OfMask(const terms::Term& term, ValueRange a, ValueRange b) const;

  const terms::Terms& terms_;
  std::unordered_map<uint32_t, ValueRange> known_;  // looked up only
};

}  // namespace plcxx::prove::verify::llvm_ir
