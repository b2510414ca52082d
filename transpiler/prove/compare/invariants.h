// What holds in every state that one version can reach: guessed from random runs, then proved by induction.
//
// In: a version and the cells of interest. Out: clauses over its cells, each proved for every run from power-on, with
// any inputs and answers of the host; the host writes inputs only. Guesses: a bit that never changes, two bits that
// never have certain values together, a byte or field that takes few values, or none above a constant of the program.
// What one guess needs another one may give: they are proved together, and what fails is dropped until nothing does.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "transpiler/prove/compare/match.h"
#include "transpiler/prove/solver/solver.h"

namespace plcxx::prove::compare {

/// What the number that `cells` make may be.
struct Invariant {
  enum class Kind : uint8_t { kOneOf, kNoneOf, kAtMost };
  std::vector<execute::CellId> cells;  // from the most significant down; together one number
  std::vector<uint64_t> values;        // of kAtMost one
  Kind kind = Kind::kOneOf;
};

/// An invariant as a condition on the values that `value` gives.
terms::TermId ConditionOf(terms::Terms& terms, const Invariant& invariant,
                          const std::function<terms::TermId(execute::CellId)>& value);

/// At most about `milliseconds`; when that is not enough, none. `is_input`: the host writes the cell.
std::vector<Invariant> FindInvariants(terms::Terms& terms, solver::Solver& solver, const Version& version,
                                      std::span<const execute::CellId> cells,
                                      const std::function<bool(execute::CellId)>& is_input, uint64_t milliseconds);

}  // namespace plcxx::prove::compare
