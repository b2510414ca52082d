// Which of many pairs of terms are equal for all values of their variables: found from the operands up.
//
// Two versions of a program differ in few places, so most of both sides is one and the same term. Of what is left,
// terms that agree on random values are asked about in the order of their making; what is proved equal is made one, so
// that the next question is as small as the statement it comes from (SAT sweeping with cut points).
// In: pairs and a solver with its assumptions. Out: a verdict for each pair. Not its job: what the terms stand for.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "transpiler/symbolic/solver/answered.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

enum class Verdict : uint8_t {
  kEqual,
  kDifferent,  // there are values of the variables that show it
  kUndecided   // not within the time
};

struct TermPair {
  terms::TermId a, b;
};

struct SweepLimits {
  uint32_t inner_ms = 100;     // for a question about two terms inside
  uint32_t pair_ms = 2000;     // for the question about a pair
  uint64_t total_ms = 60'000;  // for all; later pairs are undecided
  Clock clock = Clock::kWall;  // of it
  /// Nothing is assumed, so that two terms that differ for random values differ.
  bool any_values_count = false;
  /// What is known of forms of questions, and becomes known; none where something is assumed.
  AnsweredForms* answered = nullptr;
  std::function<void(size_t done, size_t all)> progress;  // of the pairs that are not one term; may be empty
};

/// A verdict for each pair, under what `solver` assumes.
std::vector<Verdict> Compare(terms::Terms& terms, Solver& solver, std::span<const TermPair> pairs,
                             const SweepLimits& limits);

}  // namespace plcxx::solver
