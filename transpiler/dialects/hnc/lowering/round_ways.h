// How often a round of a loop passes certain expressions, such as the stores into its counter: along each way through
// the round never, once or more often. And whether a jump back closes a loop at all.
//
// Example: in `while (i < 9) { if (a) { i++; continue; } i++; }` each of the two ways passes one of the increments.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/hnc/lowering/loop_shape.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// The ways that come to a point: how often they have passed one of the expressions.
struct Ways {
  bool never = false, once = false, more = false;

  bool exist() const { return never || once || more; }
  /// With those that come from elsewhere.
  Ways operator|(const Ways& other) const {
    return {.never = never || other.never, .once = once || other.once, .more = more || other.more};
  }
  bool operator==(const Ways&) const = default;
};

class RoundWays {
 public:
  RoundWays(const Unit& unit, const std::vector<ExprId>& passed);

  /// From the beginning of the body to the next time that the condition holds. The loop is a statement.
  Ways Of(const LoopShape& loop);
  /// Whether control comes from the label to one of the jumps without passing the label again.
  bool LeadTo(StatementId label, const std::vector<StatementId>& jumps, StatementId function_body);

 private:
  struct Around {
    bool is_loop = false, defaults = false;
    Ways entry;  // of a switch: where its labels are come to from
    Ways breaks, continues;
  };

  template <class Walk>
  Ways UntilStable(Walk&& walk);
  Ways Evaluate(ExprId id, Ways ways) const;
  Ways EvaluateTrue(ExprId id, Ways ways) const;
  Ways Execute(StatementId id, Ways ways);
  Ways ExecuteIf(const Statement& statement, Ways ways);
  Ways ExecuteLoop(StatementId id, Ways ways);
  Ways ExecuteSwitch(const Statement& statement, Ways ways);
  Ways EnterCase(const Statement& label);
  Ways ExecuteJump(StatementId id, const Ways& ways);

  const Unit& unit_;
  std::unordered_set<uint32_t> passed_;         // by ExprId
  StatementId start_;                           // here all begins anew
  std::unordered_set<uint32_t> looked_for_;     // by StatementId of a goto
  bool found_ = false;                          // one of them
  std::vector<Around> around_;                  // statements within the body
  Ways continues_;                              // of the loop itself
  std::unordered_map<uint32_t, Ways> heads_;    // by StatementId of a loop: what comes back to its head
  std::unordered_map<uint32_t, Ways> labels_;   // by LabelId
  std::unordered_set<uint32_t> labels_behind_;  // by LabelId: this walk has been there
  bool again_ = false;                          // something was added to what this walk has passed
};

}  // namespace plcxx::hnc
