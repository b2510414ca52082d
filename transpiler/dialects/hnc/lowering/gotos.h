// Labels and gotos (specification 6.6): a jump back is a loop, whose iterations are counted.
#pragma once

#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"

namespace plcxx::hnc {

class Faults;
class Intervals;
class Jumps;
class LivePath;
class Locals;
class LoopBounds;
class Loops;
class StatedFacts;
class Statements;

class Gotos : Context {
 public:
  Gotos(const Context& context, StatedFacts& stated, Faults& faults, Locals& locals, Jumps& jumps, LivePath& path,
        Intervals& intervals, LoopBounds& loop_bounds, Loops& loops, Statements& statements)
      : Context(context),
        stated_(stated),
        faults_(faults),
        locals_(locals),
        jumps_(jumps),
        path_(path),
        intervals_(intervals),
        loop_bounds_(loop_bounds),
        loops_(loops),
        statements_(statements) {}

  void LowerLabel(const Statement& statement, Tail tail);
  void Lower(const Statement& statement);
  void BeginFunction();

 private:
  uint32_t NumberOf(LabelId id);
  void PrepareBackJump(const Statement& label, const std::vector<StatementId>& jumps);
  void SetBudget(ir::PlaceId budget, uint32_t left, StatementId label);
  void SetBudgetBefore(ir::RegionId region, size_t at, ir::PlaceId budget, uint32_t left);

  StatedFacts& stated_;
  Faults& faults_;
  Locals& locals_;
  Jumps& jumps_;
  LivePath& path_;
  Intervals& intervals_;
  LoopBounds& loop_bounds_;
  Loops& loops_;
  Statements& statements_;
  struct BackLabel {
    ir::RegionId region;
    ir::InstId label;
    Span span;  // what is executed in its iterations
  };
  std::vector<BackLabel> back_labels_;                      // of the function so far
  std::unordered_map<uint32_t, uint32_t> goto_labels_;      // by LabelId
  std::unordered_map<uint32_t, ir::PlaceId> goto_budgets_;  // by LabelId
  std::unordered_set<uint32_t> placed_labels_;              // by LabelId: jumps to them go back
  std::unordered_map<uint32_t, bool> annotated_labels_;
};

}  // namespace plcxx::hnc
