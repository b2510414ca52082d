// Which relations (relation.h) there may be between memory of the old version and memory of the new one.
//
// Both versions are executed beside each other with the same random inputs, on the terms of their parts; of the numbers
// of each side that are in no equal pair it is seen what they have to do with each other, in all states or while a bit
// is set or not. In: a comparison whose undecided pairs are separated. Out: guesses, none of which any state of these
// runs breaks. Not its job: whether they hold.
#pragma once

#include <vector>

#include "transpiler/prove/diff/comparison.h"

namespace plcxx::prove::diff {

/// Sets to be tried one after the other: the first one without numbers that were the same in both versions all the
/// time, for these may become equal pairs by what is said of the others. None where a part cannot be executed in time.
std::vector<std::vector<Relation>> GuessRelations(Comparison& comparison);

}  // namespace plcxx::prove::diff
