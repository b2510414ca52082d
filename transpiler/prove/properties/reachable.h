// Shows that no reachable state is bad: what holds in every reachable state is learned from what has to be shown.
//
// Property directed reachability (IC3): a bad state is made impossible by facts about the state before it, and so on
// back to power-on; the facts are clauses over single bits, in layers for states that so many parts of periods reach.
// When two layers are equal, their facts hold in every reachable state. State counts when it is needed: the rest has
// any value at first.
//
//   a ring of steps: A = 1, B = C = 0 after power-on; each period moves the 1: A' = C, B' = A, C' = B. Bad: A & B.
//     A & B is not itself excluded by induction: its predecessor C & A is a state without A & B
//     C & A has the predecessor B & C, and that one A & B; power-on is none of them, so each is blocked by a clause
//     !(A & B), !(C & A), !(B & C): power-on satisfies all three, and a period keeps the three together: proved
//
// In: the state as far as it is asked for, what is bad. Out: the clauses, proved once more by a solver that knows
// nothing of the search, or nothing. Not its job: runs that show that a bad state is reached.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::properties {

/// Something that lives from part to part of a period.
struct StateWord {
  terms::TermId now;                // a variable
  std::vector<terms::TermId> next;  // by part
  terms::TermId start;              // after power-on
};

/// One bit of a state word, and the value that it has.
struct StateBit {
  uint32_t word = 0;  // index of FoundFacts::words
  uint8_t bit = 0;
  bool value = false;
};

struct FoundFacts {
  std::vector<StateWord> words;
  std::vector<std::vector<StateBit>> forbidden;  // no reachable state has all bits of one of these
};

struct ReachQuestion {
  terms::Terms& terms;
  /// What a variable is; none: it is something new in every part.
  std::function<std::optional<StateWord>(terms::TermId variable)> state_of;
  size_t parts = 1;                                       // that take turns in any order
  terms::TermId bad;                                      // of a state, over the variables
  std::vector<terms::TermId> known;                       // holds in every reachable state, over the same
  std::function<uint32_t()> rest_ms;                      // 0: the time is over
  std::function<void(const std::string& what)> progress;  // may be empty
};

/// The facts from which it follows that no reachable state is bad; none: it is not known.
std::optional<FoundFacts> ShowUnreachable(const ReachQuestion& question);

}  // namespace plcxx::prove::properties
