// What an answer of the solver is worth.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

/// By TermId, of the terms of `cone` (ascending, see terms::ConeOf), after Answer::kPossible: the solver's values for
/// the variables and for functions of which nothing is known, and what follows from them. The solver makes up values of
/// functions that can be evaluated, too, such as those of floating point; these do not count.
std::vector<uint64_t> ModelValues(const terms::Terms& terms, Solver& solver, std::span<const terms::TermId> cone);

}  // namespace plcxx::solver
