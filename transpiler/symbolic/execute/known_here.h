// Which bits are known where a condition holds, by the parts of the condition alone: what an earlier round of a loop
// wrote there is no choice any more.
//
//   condition  !a & !b     value  a ? 0 : b ? 2 : 4     known: 4, bit by bit
//
// In: a condition, then bits. Out: 0, 1, or nothing. Not its job: what only a solver finds (solver/).
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::execute {

class KnownHere {
 public:
  KnownHere(terms::Terms& terms, terms::TermId condition);

  std::optional<bool> ValueOf(terms::TermId bit);

 private:
  std::optional<bool> Compute(terms::TermId bit);
  std::optional<bool> OfChoice(terms::TermId condition, terms::TermId then, terms::TermId otherwise);

  terms::Terms& terms_;
  std::unordered_map<uint32_t, std::optional<bool>> known_;  // by TermId; looked up only
  uint32_t depth_ = 0;
};

}  // namespace plcxx::execute
