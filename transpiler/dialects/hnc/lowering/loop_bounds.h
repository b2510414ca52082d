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
struct Conjunct;
struct CounterRelation;

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
  /// Everything that is executed in one.
  struct Iteration {
    const LoopShape& loop;
    std::vector<ExprId> parts;
    ObjectSet declared;  // in it, with initialisers
  };

  ExprId Unwidened(ExprId id, uint32_t bits) const;
  std::optional<int64_t> StepOf(const Expr& expr, const Cell& counter) const;
  std::optional<std::vector<ExprId>> StoresInto(const Cell& cell, const std::vector<ExprId>& parts,
                                                Refusal& refusal) const;
  std::optional<Change> ChangeOf(const Cell& counter, ExprId in_comparison, const std::vector<ExprId>& before,
                                 const Iteration& iteration, Refusal& refusal) const;
  bool IsComputed(ExprId side) const;
  source::Range CounterInside(ExprId side, const std::vector<ExprId>& parts) const;
  bool IsUnchanged(ExprId limit, const std::vector<ExprId>& parts) const;
  Iteration IterationOf(const LoopShape& loop) const;
  bool IsIntegerComparison(const Expr& expr) const;
  std::vector<CounterRelation> RelationsOf(const Expr& expr, ExprId id, bool negated) const;
  void RefuseCountersInside(const Expr& comparison, const Iteration& iteration, Refusal& refusal) const;
  /// Whether nothing in the loop changes the limit; refuses it else.
  bool CheckLimit(const CounterRelation& relation, const Iteration& iteration, Refusal& refusal) const;
  Bounds StartOf(const CounterRelation& relation, const Change& change, const Bounds& entered,
                 const LoopShape& loop) const;
  std::optional<LoopProof> ProveBy(const Conjunct& conjunct, const Iteration& iteration, Refusal& refusal);
  /// With a limit that does not change, and a counter that does.
  std::optional<LoopProof> ProveWith(const CounterRelation& relation, const Cell& counter, const Change& change,
                                     const LoopShape& loop, Refusal& refusal);

  Jumps& jumps_;
  Intervals& intervals_;
  LoopPaths& paths_;
};

}  // namespace plcxx::hnc
