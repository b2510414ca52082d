// Labels and gotos (specification 6.6): a jump back is a loop, whose iterations are counted.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::ValueId;

void Lowering::LabelStatement(const Statement& statement, bool last) {
  const Label& label = unit_.labels[statement.label];
  if (label.used) {
    const uint32_t number = GotoLabel(statement.label);
    // A way back leads here: what it changes is not known, and its rounds are counted from here on.
    std::vector<StatementId> back;
    for (const StatementId jump : JumpsTo(label.statement)) {
      if (live_gotos_.contains(jump.index) && IsBefore(label.statement, jump)) back.push_back(jump);
    }
    PlaceLabel(number);
    if (!back.empty()) {
      // Nothing is known where only jumps back lead to.
      if (!flow_.reachable) flow_.ForgetAll();
      flow_.reachable = true;
      PrepareBackJump(statement, back);
      builder_.Label(number);
      back_labels_.push_back({.region = builder_.region(),
                              .label = program_.regions[builder_.region()].insts.back(),
                              .span = Repeated(statement.label, back)});
      placed_labels_.insert(statement.label.index);
    }
  }
  Lower(statement.then, last);
}

uint32_t Lowering::GotoLabel(LabelId id) {
  const auto [found, added] = goto_labels_.emplace(id.index, 0);
  if (added) found->second = NewLabel();
  return found->second;
}

/// Bounds the rounds of a label with jumps back to it; refused where neither a proof nor an annotation does.
void Lowering::PrepareBackJump(const Statement& label, const std::vector<StatementId>& jumps) {
  const Statement& jump = unit_.statements[jumps.front()];
  uint64_t rounds = label.loop_bound ? label.loop_bound->rounds : 0;
  const bool annotated = rounds != 0;
  const Span again = Repeated(label.label, jumps);
  const StatementId self = unit_.labels[label.label].statement;
  if (!annotated) {
    // A second way back would not ask for what the first one asks for.
    std::optional<uint64_t> proved;
    const Flow known = flow_;
    // Who comes another way knows nothing of what is known at the label.
    if (IsEnteredElsewhere(again)) flow_.ForgetAll();
    if (jumps.size() == 1) proved = RoundsOfGoto(self, jumps.front());
    flow_ = known;
    if (!proved) {
      diagnostics_.Report(jump.keyword, diag::HncUnboundedLoop,
                          "nothing shows that the jump back to '" + unit_.labels[label.label].name + "' ends");
    }
    rounds = proved.value_or(0);
  }
  if (rounds != 0) CheckRounds(jump.keyword, rounds);
  for (size_t i = again.first; i <= again.last && i < statements_.size(); ++i) {
    ForEachOwnExpr(unit_, unit_.statements[statements_[i]],
                   [&](ExprId expr) { ForEachExpr(unit_, expr, [&](ExprId part) { ForgetWritesOf(part); }); });
  }
  const ir::PlaceId budget = AddLocal("rounds_left", ir::Type::kI32);
  goto_budgets_[label.label.index] = budget;
  annotated_labels_[label.label.index] = annotated;
  const auto left = static_cast<uint32_t>(rounds == 0 ? 0 : rounds - 1);
  if (IsEnteredElsewhere(again) || HasChoiceAround(self, jumps.back())) SetBudget(budget, left, self);
  builder_.Store(budget, Long(left));
}

/// A way that does not pass the label comes to the jump back, too: it finds the count as it is in front of the
/// function, and in each iteration of what goes round about the loop anew, not what an entry before has left of it.
void Lowering::SetBudget(ir::PlaceId budget, uint32_t left, StatementId label) {
  const ir::RegionId prologue = program_.routines[routines_[function_id_.index]].prologue;
  SetBudgetBefore(prologue, program_.regions[prologue].insts.size(), budget, left);
  if (!iterated_.empty()) SetBudgetBefore(iterated_.back(), 0, budget, left);
  for (const BackLabel& outer : back_labels_) {
    if (!outer.span.Holds(OrderOf(label))) continue;
    const std::vector<ir::InstId>& insts = program_.regions[outer.region].insts;
    const auto at = std::ranges::find(insts, outer.label);
    SetBudgetBefore(outer.region, static_cast<size_t>(at - insts.begin()) + 1, budget, left);
  }
}

void Lowering::SetBudgetBefore(ir::RegionId region, size_t at, ir::PlaceId budget, uint32_t left) {
  const ir::RegionId here = builder_.region(), store = builder_.NewRegion();
  builder_.SetRegion(store);
  builder_.Store(budget, Long(left));
  builder_.SetRegion(here);
  const std::vector<ir::InstId> added = std::exchange(program_.regions[store].insts, {});
  std::vector<ir::InstId>& insts = program_.regions[region].insts;
  insts.insert(insts.begin() + static_cast<std::ptrdiff_t>(at), added.begin(), added.end());
}

/// In the order of the source.
const std::vector<StatementId>& Lowering::JumpsTo(StatementId label) const {
  static const auto* const none = new std::vector<StatementId>();
  const auto found = jumps_to_.find(label.index);
  return found == jumps_to_.end() ? *none : found->second;
}

/// The statements that can be executed between a label and a jump back to it: those between them in the source, the
/// loops that begin there, and what leads back into them from further down.
Lowering::Span Lowering::Repeated(LabelId label, const std::vector<StatementId>& jumps) const {
  Span span{OrderOf(unit_.labels[label].statement), 0};
  const auto grow = [&](StatementId to) { span.last = std::max(span.last, OrderOf(to)); };
  for (const StatementId jump : jumps) grow(jump);
  for (size_t i = span.first; i <= span.last && i < statements_.size(); ++i) {
    const StatementId id = statements_[i];
    const Statement& statement = unit_.statements[id];
    if (IsLoop(statement.kind)) ForEachStatement(unit_, id, grow);
    if (statement.kind != StatementKind::kLabel) continue;
    for (const StatementId jump : JumpsTo(id)) {
      if (IsBefore(id, jump)) grow(jump);
    }
  }
  return span;
}

/// Whether a goto or a switch leads into the statements from outside, past the first of them.
bool Lowering::IsEnteredElsewhere(const Span& span) const {
  for (size_t i = span.first + size_t{1}; i <= span.last && i < statements_.size(); ++i) {
    const StatementId id = statements_[i];
    const StatementKind kind = unit_.statements[id].kind;
    if (IsCase(kind)) {
      StatementId head = id;
      while (head.valid() && unit_.statements[head].kind != StatementKind::kSwitch) head = ParentOf(head);
      if (head.valid() && !span.Holds(OrderOf(head))) return true;
    }
    if (kind != StatementKind::kLabel) continue;
    const auto outside = [&](StatementId jump) { return !span.Holds(OrderOf(jump)); };
    if (std::ranges::any_of(JumpsTo(id), outside)) return true;
  }
  return false;
}

/// Whether an if or a switch around the label, but not around the jump back, decides if it is passed.
bool Lowering::HasChoiceAround(StatementId label, StatementId jump) const {
  std::unordered_set<uint32_t> around;
  for (StatementId at = jump; at.valid(); at = ParentOf(at)) around.insert(at.index);
  for (StatementId at = ParentOf(label); !around.contains(at.index); at = ParentOf(at)) {
    const StatementKind kind = unit_.statements[at].kind;
    if (kind == StatementKind::kIf || kind == StatementKind::kSwitch) return true;
  }
  return false;
}

void Lowering::Goto(const Statement& statement) {
  if (!statement.label.valid()) return;
  if (!placed_labels_.contains(statement.label.index)) {
    JumpTo(GotoLabel(statement.label));
    return;
  }
  const ir::RegionId outside = builder_.region(), refused = builder_.NewRegion();
  builder_.SetRegion(refused);
  const bool annotated = annotated_labels_[statement.label.index];
  if (annotated) {
    RecordFault(Fault::kLoop);
  } else if (facts_stated_.on()) {
    facts_stated_.Fail(ir::FactKind::kLoop, Long(0));
  }
  builder_.SetRegion(outside);
  builder_.JumpBack(GotoLabel(statement.label), {}, goto_budgets_[statement.label.index], refused);
  // Refused, it goes on behind itself.
  if (!annotated) flow_.reachable = false;
}

}  // namespace plcxx::hnc
