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
    ForEachStatement(unit_, function_->body, [&](StatementId id) {
      const Statement& jump = unit_.statements[id];
      if (live_gotos_.contains(id.index) && jump.label == statement.label && IsBefore(label.statement, id)) {
        back.push_back(id);
      }
    });
    PlaceLabel(number);
    if (!back.empty()) {
      // Nothing is known where only jumps back lead to.
      if (!flow_.reachable) flow_.ForgetAll();
      flow_.reachable = true;
      PrepareBackJump(statement, back);
      builder_.Label(number);
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
  const StatementId back = jumps.back();
  const Statement& jump = unit_.statements[jumps.front()];
  uint64_t rounds = label.loop_bound ? label.loop_bound->rounds : 0;
  const bool annotated = rounds != 0;
  const Span again = Repeated(label.label, jumps);
  // Everything between the label and the jump may have been executed.
  std::vector<StatementId> body;
  const StatementId self = unit_.labels[label.label].statement;
  const StatementId list = ParentOf(self);
  bool inside = false;
  StatementId guard = back;
  while (guard.valid() && ParentOf(guard) != list) guard = ParentOf(guard);
  if (list.valid()) {
    for (const StatementId id : unit_.statements[list].body) {
      inside = inside || id == self;
      if (inside) body.push_back(id == self ? label.then : id);
      if (id == guard) break;
    }
  }
  if (!annotated) {
    std::optional<LoopProof> proof;
    // `label: A; if (c) { B; goto label; }` goes round as long as c holds; a second way back would not ask for c.
    const StatementId test = guard == self ? label.then : guard;
    const bool is_if = test.valid() && test != back && unit_.statements[test].kind == StatementKind::kIf &&
                       !unit_.statements[test].otherwise.valid();
    if (is_if && jumps.size() == 1) {
      std::vector<StatementId> round = body;
      round.pop_back();
      const size_t in_front = round.size();
      const Statement& then = unit_.statements[unit_.statements[test].then];
      if (then.kind == StatementKind::kCompound && !then.body.empty() && then.body.back() == back) {
        round.insert(round.end(), then.body.begin(), then.body.end() - 1);
      } else if (unit_.statements[test].then != back) {
        round.push_back(unit_.statements[test].then);
      }
      proof = Prove({.condition = unit_.statements[test].expression,
                     .step = {},
                     .body = round,
                     .tests_first = in_front == 0,
                     .is_statement = false,
                     .enters_elsewhere = IsEnteredElsewhere(again)});
      // The test may come before the first change: one round more at most.
      if (proof && (in_front == 0 || round.size() > in_front)) ++proof->count.iterations;
    }
    if (!proof) {
      diagnostics_.Report(jump.keyword, diag::HncUnboundedLoop,
                          "nothing shows that the jump back to '" + unit_.labels[label.label].name + "' ends");
    } else {
      rounds = proof->count.iterations;
      CheckRounds(jump.keyword, rounds);
    }
  } else {
    CheckRounds(jump.keyword, rounds);
  }
  ForEachStatement(unit_, function_->body, [&](StatementId id) {
    if (!again.Holds(order_.at(id.index))) return;
    ForEachOwnExpr(unit_, unit_.statements[id],
                   [&](ExprId expr) { ForEachExpr(unit_, expr, [&](ExprId part) { ForgetWritesOf(part); }); });
  });
  const ir::PlaceId budget = AddLocal("rounds_left", ir::Type::kI32);
  goto_budgets_[label.label.index] = budget;
  annotated_labels_[label.label.index] = annotated;
  const auto left = static_cast<uint32_t>(rounds == 0 ? 0 : rounds - 1);
  if (IsEnteredElsewhere(again) || HasChoiceAround(self)) {
    // A way that does not pass the label comes to the jump back, too.
    const ir::RegionId behind = builder_.region();
    builder_.SetRegion(program_.routines[routines_[function_id_.index]].prologue);
    builder_.Store(budget, Long(left));
    builder_.SetRegion(behind);
  }
  builder_.Store(budget, Long(left));
}

/// The statements that can be executed between a label and a jump back to it: those between them in the source, the
/// loops that begin there, and what leads back into them from further down.
Lowering::Span Lowering::Repeated(LabelId label, const std::vector<StatementId>& jumps) const {
  Span span{order_.at(unit_.labels[label].statement.index), 0};
  for (const StatementId jump : jumps) span.last = std::max(span.last, order_.at(jump.index));
  for (bool grown = true; grown;) {
    grown = false;
    const auto grow = [&](StatementId to) {
      if (order_.at(to.index) <= span.last) return;
      span.last = order_.at(to.index);
      grown = true;
    };
    ForEachStatement(unit_, function_->body, [&](StatementId id) {
      const Statement& statement = unit_.statements[id];
      const bool inside = span.Holds(order_.at(id.index));
      if (inside && IsLoop(statement.kind)) ForEachStatement(unit_, id, grow);
      if (inside || statement.kind != StatementKind::kGoto || !statement.label.valid()) return;
      const StatementId target = unit_.labels[statement.label].statement;
      if (IsBefore(target, id) && span.Holds(order_.at(target.index))) grow(id);
    });
  }
  return span;
}

/// Whether a goto leads into the statements from outside, past the first of them.
bool Lowering::IsEnteredElsewhere(const Span& span) const {
  bool elsewhere = false;
  ForEachStatement(unit_, function_->body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind != StatementKind::kGoto || !statement.label.valid()) return;
    const uint32_t to = order_.at(unit_.labels[statement.label].statement.index);
    elsewhere = elsewhere || (to > span.first && to <= span.last && !span.Holds(order_.at(id.index)));
  });
  return elsewhere;
}

/// Whether an if or a switch around the label decides if it is passed.
bool Lowering::HasChoiceAround(StatementId label) const {
  for (StatementId at = ParentOf(label); at.valid(); at = ParentOf(at)) {
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
  } else if (false_fact_.valid()) {
    NoteFalseFact();
  }
  builder_.SetRegion(outside);
  builder_.JumpBack(GotoLabel(statement.label), {}, goto_budgets_[statement.label.index], refused);
  // Refused, it goes on behind itself.
  if (!annotated) flow_.reachable = false;
}

}  // namespace plcxx::hnc
