// Between which numbers a term lies, where a condition holds: what products and quotients of numbers that are known to
// be small need no solver for, which would have to try them bit by bit.
//
// In: terms. Out: bounds that hold for every value of the variables; wide ones where nothing better is known. Not its
// job: which bits are known (known_bits.h).
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Of a number without a sign, and of the same bits as two's complement.
struct Interval {
  uint64_t low = 0, high = 0;
  int64_t least = 0, greatest = 0;
  bool operator==(const Interval&) const = default;
};

class Intervals {
 public:
  explicit Intervals(Terms& terms) : terms_(terms) {}

  Interval Of(TermId id);
  /// From now on bounds hold where the condition has this value. False: they contradict each other, it never has.
  bool Assume(TermId condition, bool value);

 private:
  Interval Compute(TermId id);
  Interval OfChoice(const Term& term);
  Interval OfBranch(TermId condition, bool value, TermId branch);
  void Restrict(TermId id, const Interval& bounds);

  Terms& terms_;
  std::unordered_map<uint32_t, Interval> assumed_, known_;  // by TermId; looked up only
  std::vector<std::pair<uint32_t, Interval>> before_;       // what was assumed before, newest last
  uint32_t steps_ = 0, depth_ = 0;
  bool contradicts_ = false;
};

/// Whether bounds alone show that a condition never holds.
bool NeverHolds(Terms& terms, TermId condition);

}  // namespace plcxx::terms
