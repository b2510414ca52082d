#include "transpiler/dialects/hnc/lowering/gotos.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/loop_bounds.h"
#include "transpiler/dialects/hnc/lowering/loops.h"
#include "transpiler/dialects/hnc/lowering/round_ways.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/dialects/hnc/lowering/statements.h"

namespace plcxx::hnc {

void Gotos::LowerLabel(const Statement& statement, Tail tail) {
  const Label& label = unit_.labels[statement.label];
  if (label.used) {
    uint32_t number = NumberOf(statement.label);
    // A way back leads here: what it changes is not known, and its rounds are counted from here on.
    std::vector<StatementId> back;
    for (const StatementId jump : jumps_.JumpsTo(label.statement)) {
      if (jumps_.IsLive(jump) && jumps_.IsBefore(label.statement, jump)) back.push_back(jump);
    }
    const bool from_above = path_.PlaceLabel(number);
    if (!back.empty()) {
      // Jumps from above arrive in front of where the rounds begin to be counted.
      if (from_above) number = goto_labels_[statement.label.index] = path_.NewLabel();
      // Nothing is known where only jumps back lead to.
      if (!flow_.reachable) flow_.ForgetAll();
      flow_.reachable = true;
      PrepareBackJump(statement, back);
      builder_.Label(number);
      back_labels_.push_back({.region = builder_.region(),
                              .label = program_.regions[builder_.region()].insts.back(),
                              .span = jumps_.Repeated(statement.label, back)});
      placed_labels_.insert(statement.label.index);
    }
  }
  statements_.Lower(statement.then, tail);
}

uint32_t Gotos::NumberOf(LabelId id) {
  const auto [found, added] = goto_labels_.emplace(id.index, 0);
  if (added) found->second = path_.NewLabel();
  return found->second;
}

/// Bounds the rounds of a label with jumps back to it; refused where neither a proof nor an annotation does.
void Gotos::PrepareBackJump(const Statement& label, const std::vector<StatementId>& jumps) {
  const Statement& jump = unit_.statements[jumps.front()];
  uint64_t rounds = label.loop_bound ? label.loop_bound->rounds : 0;
  const bool annotated = rounds != 0;
  const Span again = jumps_.Repeated(label.label, jumps);
  const StatementId self = unit_.labels[label.label].statement;
  const bool passed_by = jumps_.IsEnteredElsewhere(again) || std::ranges::any_of(jumps, [&](StatementId back) {
                           return jumps_.HasChoiceAround(self, back);
                         });
  // A jump back that is reached past the label comes here without what is known in front of the label.
  if (passed_by) flow_.ForgetAll();
  if (!annotated) {
    // A second way back would not ask for what the first one asks for.
    std::optional<uint64_t> proved;
    if (jumps.size() == 1) proved = loop_bounds_.IterationsOfGoto(self, jumps.front());
    // Where the label does not lead to a jump back again, it is reached from above and once from below.
    if (!proved && !RoundWays(unit_, {}).LeadTo(self, jumps, jumps_.statements().front())) proved = 2;
    if (!proved) {
      diagnostics_.Report(jump.keyword, diag::HncUnboundedLoop,
                          "nothing shows that the jump back to '" + unit_.labels[label.label].name + "' ends");
    }
    rounds = proved.value_or(0);
  }
  if (rounds != 0) loops_.CheckRounds(jump.keyword, rounds);
  for (size_t i = again.first; i <= again.last; ++i) {
    ForEachOwnExpr(unit_, unit_.statements[jumps_.statements()[i]], [&](ExprId expr) {
      ForEachExpr(unit_, expr, [&](ExprId part) { intervals_.ForgetWritesOf(part); });
    });
  }
  const ir::PlaceId budget = locals_.Add("rounds_left", ir::Type::kI32);
  goto_budgets_[label.label.index] = budget;
  annotated_labels_[label.label.index] = annotated;
  const auto left = static_cast<uint32_t>(rounds == 0 ? 0 : rounds - 1);
  if (passed_by) SetBudget(budget, left, self);
  builder_.Store(budget, Long(left));
}

/// A way that does not pass the label comes to the jump back, too: it finds the count as it is in front of the
/// function, and in each iteration of what goes round about the loop anew, not what an entry before has left of it.
void Gotos::SetBudget(ir::PlaceId budget, uint32_t left, StatementId label) {
  const ir::RegionId prologue = program_.routines[placement_.routines[frame_.id.index]].prologue;
  SetBudgetBefore(prologue, program_.regions[prologue].insts.size(), budget, left);
  if (!loops_.iterated().empty()) SetBudgetBefore(loops_.iterated().back(), 0, budget, left);
  for (const BackLabel& outer : back_labels_) {
    if (!outer.span.Holds(jumps_.OrderOf(label))) continue;
    const std::vector<ir::InstId>& insts = program_.regions[outer.region].insts;
    const auto at = std::ranges::find(insts, outer.label);
    SetBudgetBefore(outer.region, static_cast<size_t>(at - insts.begin()) + 1, budget, left);
  }
}

void Gotos::SetBudgetBefore(ir::RegionId region, size_t at, ir::PlaceId budget, uint32_t left) {
  const ir::RegionId here = builder_.region(), store = builder_.NewRegion();
  builder_.SetRegion(store);
  builder_.Store(budget, Long(left));
  builder_.SetRegion(here);
  const std::vector<ir::InstId> added = std::exchange(program_.regions[store].insts, {});
  std::vector<ir::InstId>& insts = program_.regions[region].insts;
  insts.insert(insts.begin() + static_cast<std::ptrdiff_t>(at), added.begin(), added.end());
}

void Gotos::Lower(const Statement& statement) {
  if (!statement.label.valid()) return;
  if (!placed_labels_.contains(statement.label.index)) {
    path_.JumpTo(NumberOf(statement.label));
    return;
  }
  const ir::RegionId outside = builder_.region(), refused = builder_.NewRegion();
  builder_.SetRegion(refused);
  const bool annotated = annotated_labels_[statement.label.index];
  if (annotated) {
    faults_.Record(Fault::kLoop);
  } else {
    stated_.Fail(ir::FactKind::kLoop);
  }
  builder_.SetRegion(outside);
  builder_.JumpBack(NumberOf(statement.label), {}, goto_budgets_[statement.label.index], refused);
  // Refused, it goes on after itself.
  if (!annotated) flow_.reachable = false;
}

void Gotos::BeginFunction() {
  // Anew, not cleared: to clear a map takes as long as the largest function did.
  back_labels_ = {};
  goto_labels_ = {};
  goto_budgets_ = {};
  placed_labels_ = {};
  annotated_labels_ = {};
}

}  // namespace plcxx::hnc
