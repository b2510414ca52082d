// Memory of one version alone and memory of the other one alone that hold the same: an edge that became a flag with its
// last value, a latch that moved to another address, a counter in a cell of its own.
//
// In: a comparison with every pair equal. Out: guesses, from values that the parts give on samples:
//
//   old  M20 = START;  LAMP = START & !M20      M20: what START was   next on samples  0 1 1 0   ...
//   new  LAMP = edge of START                   edge.was: the same    next on samples  0 1 1 0   ... one class: a pair
//
// Cells that nothing tells apart are in one class; a class whose cells are computed from two classes falls apart, until
// none does. Not its job: whether they are equal, which is proved when they are compared.
#pragma once

#include <utility>
#include <vector>

#include "transpiler/prove/diff/comparison.h"

namespace plcxx::prove::diff {

/// Old and new cell; none where a part cannot be executed in time.
std::vector<std::pair<execute::CellId, execute::CellId>> GuessRenamed(Comparison& comparison);

}  // namespace plcxx::prove::diff
