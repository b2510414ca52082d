// Facts that may hold at each head of a loop and are no equalities of words: suggested by the condition under which it
// goes round again.
//
// A counter is not above its bound because the loop went on below it; what is left to count becomes less; what the
// loop does not write held in the last round and holds still. In: the condition, as a term over the head. Out: facts
// over the same head, each by itself and as one of all heads but the first. Not its job: to show that they hold.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

struct FactCandidate {
  terms::TermId always, later;  // width 1; `later`: where a round was before
  std::string key;              // the same in each execution of the same program
};

/// `later`: whether a round was before, which `round` does not tell where it begins anew. `is_known`: whether a
/// variable has its value at the head already; `at_entry`: a term over the head, over the entry.
std::vector<FactCandidate> FactsFrom(terms::Terms& terms, terms::TermId again, terms::TermId round, terms::TermId later,
                                     const std::function<bool(terms::TermId variable)>& is_known,
                                     const std::function<terms::TermId(terms::TermId term)>& at_entry);

}  // namespace plcxx::prove::verify
