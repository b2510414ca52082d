// How often a loop iterates whose condition compares a counter that a constant step changes (specification 6.6), and
// which values the counter has while it does: pure arithmetic, without the tree.
//
// Example: `for (i = 0; i < 10; i += 7)` tests 0, 7 and 14, and enters its body with 0 and 7: two iterations, 0..20
// where the condition is evaluated (what is below 10, and a step further), 0..9 in the body.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/dialects/hnc/analysis/ranges.h"

namespace plcxx::hnc {

/// More iterations than these are refused, so nobody counts further.
inline constexpr uint64_t kMaxIterations = 10'000'000;

/// A loop that goes on as long as `op` holds between the counter, as `conversions` make it, and the limit.
struct CountedLoop {
  BinaryOp op = BinaryOp::kNotEqual;
  Bounds start;                     // the counter's values when it is tested first; within `type`
  Bounds limit;                     // in the type of the comparison
  int64_t step = 0;                 // counted modulo the width of the counter's type
  Bounds type;                      // of the counter
  bool wraps = true;                // past the end of its type; a proof never lets a counter with a sign do so
  std::vector<Bounds> conversions;  // types that the counter takes before it is compared, none narrower than the last
};

/// What is shown of it.
struct LoopCount {
  uint64_t iterations = 0;        // at most
  Bounds at_test;                 // of the counter, whenever the condition is evaluated: the last time included
  std::optional<Bounds> in_body;  // where it has held; none: it never holds
};

/// None: not shown to end.
std::optional<LoopCount> Count(const CountedLoop& loop);
/// Whether the relation certainly holds when the counter is compared first.
bool IsEntered(const CountedLoop& loop);

/// One value as a type of its own width keeps it.
Bounds Wrapped(const Bounds& one, const Bounds& type);

/// The relation with its sides exchanged: `a < b` is `b > a`.
BinaryOp Turned(BinaryOp op);
/// The relation that holds where this one does not.
BinaryOp Negated(BinaryOp op);

}  // namespace plcxx::hnc
