// Loops (specification 6.6): proved to end, or counted where the program says how often they may iterate.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/loop_shape.h"

namespace plcxx::hnc {

class Expressions;
class Faults;
class Intervals;
class Jumps;
class LivePath;
class LoopBounds;
class StatementWriter;
class Statements;

class Loops : Context {
 public:
  Loops(const Context& context, Faults& faults, Jumps& jumps, LivePath& path, Intervals& intervals,
        LoopBounds& loop_bounds, StatementWriter& writer, Expressions& expressions, Statements& statements)
      : Context(context),
        faults_(faults),
        jumps_(jumps),
        path_(path),
        intervals_(intervals),
        loop_bounds_(loop_bounds),
        writer_(writer),
        expressions_(expressions),
        statements_(statements) {}

  /// `proved`: the loop whose rounds were found; of one that has an error nothing is said.
  void CheckRounds(source::Range keyword, uint64_t rounds, const Statement* proved = nullptr);
  void Lower(const Statement& statement);
  /// Where what is executed in each iteration of the loops around begins.
  const std::vector<ir::RegionId>& iterated() const { return iterated_; }

 private:
  bool HasError(const Statement& statement) const;
  void ConditionRegion(ExprId id, ir::RegionId region);

  /// How often it iterates: as the program says, or as is proved.
  struct Bound {
    std::optional<LoopProof> proof;
    uint64_t rounds = 1;
    bool is_counted = false;  // by a guard, when it is executed

    bool knows_values() const { return proof && proof->knows_values; }
    Origin origin() const { return is_counted ? Origin::kStored : Origin::kTested; }
  };
  /// `leaves`: every path of its body leaves it, so that there is one iteration at most.
  Bound BoundOf(const Statement& statement, bool leaves);
  std::optional<LoopProof> Prove(const Statement& statement, bool leaves);
  /// What the bound says about its counter where the condition is tested, and where the body begins.
  void LearnAtTest(const Bound& bound);
  void LearnInBody(const Bound& bound);
  void ForgetWrites(const Statement& statement);
  ir::RegionId LowerStep(ExprId id, ir::RegionId body);
  void Iterate(const Statement& statement, uint32_t on_continue, bool leaves);

  Faults& faults_;
  Jumps& jumps_;
  LivePath& path_;
  Intervals& intervals_;
  LoopBounds& loop_bounds_;
  StatementWriter& writer_;
  Expressions& expressions_;
  Statements& statements_;
  std::vector<ir::RegionId> iterated_;  // the bodies of the loops around, those that are executed once left out
  uint64_t rounds_around_ = 1;
};

}  // namespace plcxx::hnc
