// Which terms stand at the same place in two terms that are meant to be equal.
//
// Of c ? x : y and d ? x : y only c and d can make a difference, so they are probably equal, too: worth a question
// before any other two terms that merely have equal values on samples. In: pairs of terms. Out: for each term the older
// ones that stand where it does. Not its job: whether they are equal.
#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/solver/sweep.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

using CounterpartsOfTerms = std::unordered_map<uint32_t, std::vector<terms::TermId>>;  // by TermId; looked up only

/// Oldest first; at most `most_pairs` altogether. Only pairs of one width of which `may_be_equal` says so.
CounterpartsOfTerms Counterparts(const terms::Terms& terms, std::span<const TermPair> pairs, size_t most_pairs,
                                 const std::function<bool(terms::TermId, terms::TermId)>& may_be_equal);

}  // namespace plcxx::solver
