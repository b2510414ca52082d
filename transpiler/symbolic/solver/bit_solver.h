// What answers very many small questions about the same terms, each under other conditions, and says which of these it
// needed: for searches that go on from the answers (properties/reachable.h).
//
// It knows bits only. Of a function without meaning (host calls, loops, floating point) it knows nothing: each
// application is any value. So what it says never holds never does; what it says is possible need not be.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

class BitSolver {
 public:
  BitSolver() = default;
  BitSolver(const BitSolver&) = delete;
  BitSolver& operator=(const BitSolver&) = delete;
  virtual ~BitSolver() = default;

  /// From now on `condition` (width 1) holds in every question.
  virtual void Assume(terms::TermId condition) = 0;
  /// Whether all of `conditions` can be 1 at once.
  virtual Answer Check(std::span<const terms::TermId> conditions, const Limit& limit) = 0;
  /// After kNever: by condition of the question, whether the answer needs it.
  virtual const std::vector<bool>& needed() const = 0;
  /// After kPossible: the value of a term there. What the question does not depend on is 0.
  virtual uint64_t ValueOf(terms::TermId term) = 0;
};

/// None: there is no solver. `terms` outlives it.
std::unique_ptr<BitSolver> LoadBitSolver(const terms::Terms& terms);

/// The function of the module that LoadSolver loads, too.
using MakeBitSolverFunction = BitSolver*(const terms::Terms& terms);
inline constexpr const char* kMakeBitSolver = "plcxx_make_bit_solver";

}  // namespace plcxx::solver
