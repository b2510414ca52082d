// What holds in every state that one version can reach: guessed from random runs, then proved by induction.
//
// In: a version and the cells of interest. Out: clauses over its cells, each proved for every run from power-on, with
// any inputs and answers of the host; the host writes inputs only. Guesses: a bit that never changes, two bits that
// never have certain values together, a byte or field that takes few values. What one guess needs another one may
// give: they are proved together, and what fails is dropped until nothing does.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "transpiler/prove/compare/match.h"
#include "transpiler/prove/solver/solver.h"

namespace plcxx::prove {

/// The values that never occur: all `cells` have one of the tuples of `values`, or (`never`) none of them.
struct Invariant {
  std::vector<CellId> cells;  // from the most significant down; together one number
  std::vector<uint64_t> values;
  bool never = false;  // the number is none of the values; else it is one of them
};

/// An invariant as a condition on the values that `value` gives.
TermId ConditionOf(Terms& terms, const Invariant& invariant, const std::function<TermId(CellId)>& value);

/// At most about `milliseconds`; when that is not enough, none. `is_input`: the host writes the cell.
std::vector<Invariant> FindInvariants(Terms& terms, Solver& solver, const Version& version,
                                      std::span<const CellId> cells, const std::function<bool(CellId)>& is_input,
                                      uint64_t milliseconds);

}  // namespace plcxx::prove
