// Conditions that never hold, whatever the variables and functions are: each is asked once.
//
// In: conditions, one by one. Out: whether it is known in little time that one never holds. Not its job: what they are
// conditions of.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

class Refuted {
 public:
  /// `terms` outlives it.
  explicit Refuted(const terms::Terms& terms) : terms_(terms) {}

  /// false: it may hold, or that is not known.
  bool Has(terms::TermId condition, uint64_t rest_ms);

 private:
  const terms::Terms& terms_;
  std::unique_ptr<BitSolver> bits_;           // none: nobody has asked yet, or there is no solver
  std::unordered_map<uint32_t, bool> known_;  // by TermId; looked up only
};

}  // namespace plcxx::solver
