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

  /// false: it may hold, or that is not known. Conditions of one `series` grow, as those of another round of a loop do:
  /// behind one that is too much for the solver the next ones are not asked about, 1, 3, 7 and so on up to kMostPassed.
  bool Has(terms::TermId condition, uint64_t series, uint64_t rest_ms);

  static constexpr uint32_t kMostPassed = 31;

 private:
  struct Series {
    uint32_t in_vain = 0;  // one after the other
    uint32_t passed = 0;   // since the last question
  };

  const terms::Terms& terms_;
  std::unique_ptr<BitSolver> bits_;           // none: nobody has asked yet, or there is no solver
  std::unordered_map<uint32_t, bool> known_;  // by TermId; looked up only
  std::unordered_map<uint64_t, Series> series_;
};

}  // namespace plcxx::solver
