// Ways from a label to a goto back to it: whether a place is passed exactly once in each round.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/loop_shape.h"

namespace plcxx::hnc {

class Jumps;

class LoopPaths : Context {
 public:
  LoopPaths(const Context& context, Jumps& jumps) : Context(context), jumps_(jumps) {}

  /// Whether the change is executed exactly once in each round that comes to the jump back.
  bool IsInEveryIteration(ExprId change, const LoopShape& loop) const;
  /// The statements that are executed from the label on in every round that comes to the jump, and the tests around it;
  /// false: the way is not straight.
  bool PathBack(StatementId label, StatementId jump, std::vector<StatementId>& body,
                std::vector<RoundTest>& tests) const;
  /// Whether a round may come to the jump back without passing the place exactly once: a goto within the region leads
  /// over it or back in front of it, or comes from beside the straight path, and so does one from further down.
  bool IsPassedBy(StatementId place, const LoopShape& loop) const;

 private:
  bool IsUnconditional(ExprId change, ExprId root) const;

  Jumps& jumps_;
};

}  // namespace plcxx::hnc
