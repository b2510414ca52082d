// Pairs of terms made alike where looking near them is enough: what compilers rewrite is small and many.
//
// From the operands up, a term of one side that agrees with one of the other on sample values is compared with it as if
// everything that both sides share were unknown; where that is too little, some more is looked at. Terms that are equal
// become one. Each question is as small as what was rewritten, however long the program is.
// In: pairs. Out: the same pairs, each equal to the one it comes from. Not its job: to tell that two differ (sweep.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/solver/answered.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/solver/sweep.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

/// `a` of all pairs is one side, `b` the other. Ends after about so many milliseconds. `solver` assumes nothing: what
/// it says of one term is taken for every term of the same form.
std::vector<solver::TermPair> MakeAlike(terms::Terms& terms, solver::Solver& solver,
                                        std::span<const solver::TermPair> pairs, uint64_t milliseconds,
                                        solver::AnsweredForms& answered);

}  // namespace plcxx::prove::verify
