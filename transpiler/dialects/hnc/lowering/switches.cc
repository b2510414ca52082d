#include "transpiler/dialects/hnc/lowering/switches.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/statements.h"

namespace plcxx::hnc {

namespace {

uint64_t RawValue(int64_t value, const Type& type) {
  return type.bits >= 32 ? static_cast<uint64_t>(value) & 0xFFFFFFFF : static_cast<uint64_t>(value) & 0xFFFF;
}

/// An empty statement, or a block of nothing else.
bool DoesNothing(const Unit& unit, StatementId id) {
  const Statement& statement = unit.statements[id];
  if (statement.kind == StatementKind::kEmpty) return true;
  return statement.kind == StatementKind::kCompound &&
         std::ranges::all_of(statement.body, [&unit](StatementId inner) { return DoesNothing(unit, inner); });
}

}  // namespace

void Switches::Lower(const Statement& statement) {
  const Value selector = ConvertSelector(statement.expression);
  const Statement& body = unit_.statements[statement.then];
  StatementId self = jumps_.ParentOf(statement.then);
  if (jumps_.IsFlat(self)) {
    LowerFlat(statement, selector);
    return;
  }
  const Type& type = TypeAt(selector.type);
  const uint32_t end = path_.NewLabel();
  path_.Enter({.on_break = end, .on_continue = 0, .is_loop = false, .at_ends = {}});
  const std::vector<StatementId> list =
      body.kind == StatementKind::kCompound ? body.body : std::vector<StatementId>{statement.then};
  const Flow before = flow_;
  const std::optional<Cell> cell = intervals_.CellOfRead(statement.expression);
  ir::Switch arms;
  const ir::RegionId behind = builder_.region();
  bool has_default = false;
  size_t at = 0;
  // In front of the first label: declarations, and what never runs.
  flow_.reachable = false;
  while (at < list.size() && !IsCase(unit_.statements[list[at]].kind)) statements_.Lower(list[at++], Tail::kNone);
  while (at < list.size()) {
    // The labels of one group, then what they label.
    ir::SwitchCase arm{.values = {}, .region = builder_.NewRegion(), .falls_through = false};
    builder_.SetRegion(arm.region);
    StatementId labelled = list[at];
    std::optional<Bounds> chosen;
    bool is_default = false;
    source::Range heads = unit_.statements[labelled].head;
    while (IsCase(unit_.statements[labelled].kind)) {
      const Statement& label = unit_.statements[labelled];
      heads.end = label.head.end;
      if (label.kind == StatementKind::kDefault) {
        is_default = has_default = true;
      } else {
        arm.values.push_back(RawValue(label.value, type));
        arm.bases.push_back(expressions_.BaseOf(ExprAt(label.case_expression)));
        chosen = chosen ? Join(*chosen, {label.value, label.value}) : Bounds{label.value, label.value};
      }
      labelled = label.then;
    }
    if (is_default) {
      arm.values.clear();
      arm.bases.clear();
    }
    Flow entered = before;
    if (cell && chosen && !is_default) entered.Narrow(*cell, *chosen);
    const bool fallen = flow_.reachable;
    if (fallen) {
      flow_.JoinWith(entered);
    } else {
      flow_ = entered;
    }
    writer_.MarkText(heads, writer_.SubjectOf(statement), false);
    size_t next = at + 1;
    while (next < list.size() && !IsCase(unit_.statements[list[next]].kind)) ++next;
    statements_.Lower(labelled, next == at + 1 ? Tail::kCase : Tail::kNone);
    for (size_t i = at + 1; i < next; ++i) statements_.Lower(list[i], i + 1 == next ? Tail::kCase : Tail::kNone);
    if (next == list.size() && body.kind == StatementKind::kCompound) writer_.CommentsAtEnd(body.close);
    if (flow_.reachable && next < list.size()) {
      arm.falls_through = true;
      CheckFallThrough(labelled, std::span(list).subspan(at + 1, next - at - 1), list[next]);
    } else {
      path_.EndCase();
    }
    arms.cases.push_back(std::move(arm));
    at = next;
  }
  builder_.SetRegion(behind);
  if (!arms.cases.empty()) builder_.SwitchOn(selector.id, std::move(arms));
  std::vector<Flow> ends = path_.Leave();
  if (!has_default) ends.push_back(before);
  for (const Flow& way : ends) flow_.JoinWith(way);
  path_.PlaceLabel(end);
}

Value Switches::ConvertSelector(ExprId id) {
  const Value selector = expressions_.Evaluate(id);
  if (!IsInteger(TypeAt(selector.type))) return conversions_.Zero(int_);
  return conversions_.ConvertInteger(selector, selector.type);
}

/// W8: a group that does something runs on into the next one, and no comment says that it is meant.
void Switches::CheckFallThrough(StatementId first, std::span<const StatementId> others, StatementId to) {
  const auto does_nothing = [this](StatementId id) { return DoesNothing(unit_, id); };
  if (does_nothing(first) && std::ranges::all_of(others, does_nothing)) return;
  const source::Range label = unit_.statements[to].head;
  for (const Comment* comment : CommentsIn(unit_, {unit_.statements[first].range.begin, label.begin})) {
    std::string text = comment->text;
    for (char& c : text) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    for (const std::string_view word : {"fall", "\xE7\xBB\xA7\xE7\xBB\xAD", "\xE8\xB4\xAF\xE7\xA9\xBF"}) {
      if (text.find(word) != std::string::npos) return;
    }
  }
  diagnostics_.Report(label, diag::HncFallsThrough);
}

/// switch (v) { if (a) { case 1: ... } }: a choice among jumps, then the body as a list.
void Switches::LowerFlat(const Statement& statement, const Value& selector) {
  const Type& type = TypeAt(selector.type);
  const uint32_t end = path_.NewLabel();
  path_.Enter({.on_break = end, .on_continue = 0, .is_loop = false, .at_ends = {}});
  ir::Switch arms;
  const ir::RegionId behind = builder_.region();
  const Flow before = flow_;
  bool has_default = false;
  const StatementId self = jumps_.ParentOf(statement.then);
  ForEachStatement(unit_, statement.then, [&](StatementId id) {
    const Statement& label = unit_.statements[id];
    if (!IsCase(label.kind)) return;
    for (StatementId at = jumps_.ParentOf(id); at.valid(); at = jumps_.ParentOf(at)) {
      if (unit_.statements[at].kind != StatementKind::kSwitch) continue;
      if (at != self) return;  // of a switch inside
      break;
    }
    const uint32_t to = case_labels_[id.index] = path_.NewLabel();
    const ir::RegionId arm = builder_.NewRegion();
    builder_.SetRegion(arm);
    flow_ = before;
    path_.JumpTo(to);
    ir::SwitchCase chosen{.values = {}, .region = arm, .falls_through = false};
    if (label.kind == StatementKind::kDefault) {
      has_default = true;
    } else {
      chosen.values.push_back(RawValue(label.value, type));
      chosen.bases.push_back(expressions_.BaseOf(ExprAt(label.case_expression)));
    }
    arms.cases.push_back(std::move(chosen));
  });
  if (!has_default) {
    const ir::RegionId arm = builder_.NewRegion();
    builder_.SetRegion(arm);
    flow_ = before;
    path_.JumpTo(end);
    arms.cases.push_back({.values = {}, .region = arm, .falls_through = false});
  }
  builder_.SetRegion(behind);
  builder_.SwitchOn(selector.id, std::move(arms));
  const std::vector<StatementId>& list = unit_.statements[statement.then].body;
  std::optional<size_t> group;  // where the last one begins
  for (size_t i = 0; i < list.size(); ++i) {
    if (!IsCase(unit_.statements[list[i]].kind)) continue;
    if (group)
      groups_in_front_[list[i].index] = {list.begin() + static_cast<ptrdiff_t>(*group),
                                         list.begin() + static_cast<ptrdiff_t>(i)};
    group = i;
  }
  flow_.reachable = false;
  statements_.Lower(statement.then, Tail::kNone);
  path_.Leave();
  path_.PlaceLabel(end);
}

void Switches::PlaceCase(StatementId id) {
  const auto label = case_labels_.find(id.index);
  if (label == case_labels_.end()) return;
  const auto group = groups_in_front_.find(id.index);
  if (group != groups_in_front_.end() && flow_.reachable) {
    StatementId labelled = group->second.front();
    while (IsCase(unit_.statements[labelled].kind)) labelled = unit_.statements[labelled].then;
    CheckFallThrough(labelled, std::span(group->second).subspan(1), id);
  }
  path_.PlaceLabel(label->second);
}

}  // namespace plcxx::hnc
