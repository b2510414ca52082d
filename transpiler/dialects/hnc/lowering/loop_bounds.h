// Proofs that loops end (specification 6.6): a conjunct of the condition compares a counter with a limit, the counter
// changes by a constant exactly once in each iteration, and cannot step over the end of its type before the relation
// fails.
#pragma once

#include <optional>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/loop_shape.h"

namespace plcxx::hnc {

class Intervals;
class Jumps;
class LoopPaths;

class LoopBounds : Context {
 public:
  LoopBounds(const Context& context, Jumps& jumps, Intervals& intervals, LoopPaths& paths)
      : Context(context), jumps_(jumps), intervals_(intervals), paths_(paths) {}

  std::optional<LoopProof> Prove(const LoopShape& loop, Refusal& refusal);
  /// At most so often the statement after the label is executed each time that the loop is entered; none: no proof.
  std::optional<uint64_t> IterationsOfGoto(StatementId label, StatementId jump);

 private:
  /// Of a counter in an iteration.
  struct Change {
    int64_t step = 0;
    bool in_condition = false;
    bool is_before = false;  // in the condition, in front of the comparison: `n++, n < 5`
  };

  ExprId Unwidened(ExprId id, uint32_t bits) const;
  std::optional<int64_t> StepOf(const Expr& expr, const Cell& counter) const;
  std::optional<std::vector<ExprId>> StoresInto(const Cell& cell, const std::vector<ExprId>& parts,
                                                Refusal& refusal) const;
  std::optional<Change> ChangeOf(const Cell& counter, ExprId in_comparison, const std::vector<ExprId>& before,
                                 const LoopShape& loop, const std::vector<ExprId>& parts, Refusal& refusal) const;
  bool IsComputed(ExprId side) const;
  source::Range CounterInside(ExprId side, const std::vector<ExprId>& parts) const;
  bool IsUnchanged(ExprId limit, const std::vector<ExprId>& parts) const;
  std::optional<LoopProof> ProveBy(ExprId conjunct, const std::vector<ExprId>& before, const LoopShape& loop,
                                   const std::vector<ExprId>& parts, const ObjectSet& declared, Refusal& refusal);

  Jumps& jumps_;
  Intervals& intervals_;
  LoopPaths& paths_;
};

}  // namespace plcxx::hnc
