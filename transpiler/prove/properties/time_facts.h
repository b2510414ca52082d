// What holds between times: how far a count of periods, a timer's register and the clock can be from each other.
//
// "A for 6000 ms implies B" is true because a timer counts while A stands: what the timer has counted is at least what
// has passed. Such relations are guessed from a few forms, with scales and limits of the program; what random runs do
// not contradict is proved by induction, together, and what fails is dropped until nothing does.
//
//   T counts 10 ms in each period in which A is 1, up to 5000, else it is 0; B = T >= 5000.
//   property   A for 6000 ms implies B          n: for how many periods A has been 1 so far (the property's own count)
//   induction  n = 600, T = 0 is a state that nothing excludes, though no run comes to it
//   candidate  10 * n <= T, or T >= 5000        (kGrows, scale 10, limit 5000): holds after power-on (0 <= 0); a period
//              with A = 1 adds 10 to both sides or T has its limit; one with A = 0 makes n = 0. Proved
//   so         n = 600 means 6000 <= T or T >= 5000: B is 1
//
// Of a timer that another one starts it is said from there on: 10 * n <= T2 + 5000.
//
// In: the state words and what must not happen. Out: facts over the variables, each of which holds in every reachable
// state, between parts of periods, too. Not its job: other facts (prove/invariants, reachable.h).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/prove/properties/reachable.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::properties {

struct TimeQuestion {
  const ReachQuestion& reach;
  solver::Solver& solver;
  std::vector<terms::TermId> counters;  // variables of state words: counts of periods
  /// Variables of state words that make a number, from the least significant one; the nearest ones first.
  std::vector<std::vector<terms::TermId>> registers;
  terms::TermId now;                // the variable of the time, a state word; none: nothing is known of it
  std::vector<terms::TermId> bits;  // variables, of width 1, with which a relation may begin or end
  uint32_t period_ms = 10;
};

std::vector<terms::TermId> FindTimeFacts(const TimeQuestion& question);

}  // namespace plcxx::prove::properties
