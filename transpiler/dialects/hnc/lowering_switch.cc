// Switches (specification 6.7). A switch whose labels stand in its body is one of the IR; one with
// labels deeper inside, and an if that a goto leads into, become jumps in the list around them.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::ValueId;

namespace {

std::string_view WordOf(StatementKind kind) {
  switch (kind) {
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
      return "loop";
    case StatementKind::kSwitch:
      return "switch";
    default:
      return "nested statement";
  }
}

uint64_t RawValue(int64_t value, const Type& type) {
  return type.bits >= 32 ? static_cast<uint64_t>(value) & 0xFFFFFFFF : static_cast<uint64_t>(value) & 0xFFFF;
}

}  // namespace

/// Which statement holds which, and what jumps lead into.
void Lowering::FindLabels(const Function& function) {
  // Anew, not cleared: to clear a map takes as long as the largest function did.
  parents_ = {};
  order_ = {};
  statements_ = {};
  jumps_to_ = {};
  flat_ = {};
  goto_labels_ = {};
  case_labels_ = {};
  goto_budgets_ = {};
  back_labels_ = {};
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    order_.emplace(id.index, static_cast<uint32_t>(order_.size()));
    statements_.push_back(id);
    if (statement.kind == StatementKind::kGoto && statement.label.valid()) {
      jumps_to_[unit_.labels[statement.label].statement.index].push_back(id);
    }
    for (const StatementId child : statement.body) parents_[child.index] = id;
    if (statement.then.valid()) parents_[statement.then.index] = id;
    if (statement.otherwise.valid()) parents_[statement.otherwise.index] = id;
  });
  live_gotos_ = FindLiveGotos(unit_, function.body);
  FindEntries(function);
  CheckJumps(function);
}

/// What is lowered although control does not come to its beginning: a live goto or a switch outside of it leads to a
/// label in it. A switch with a goto to what is not in the same arm becomes flat.
void Lowering::FindEntries(const Function& function) {
  entered_.clear();
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kGoto && live_gotos_.contains(id.index)) {
      std::unordered_map<uint32_t, StatementId> part_of;  // by StatementId around the goto: its part with the goto
      for (StatementId at = id, part; at.valid(); part = at, at = ParentOf(at)) part_of.emplace(at.index, part);
      StatementId at = unit_.labels[statement.label].statement, part;
      for (; at.valid() && !part_of.contains(at.index); part = at, at = ParentOf(at)) entered_.insert(at.index);
      if (part.valid() && !AreInOneArm(at, part, part_of.at(at.index))) flat_.insert(ParentOf(at).index);
    }
    if (!IsCase(statement.kind)) return;
    for (StatementId at = id; at.valid() && unit_.statements[at].kind != StatementKind::kSwitch; at = ParentOf(at)) {
      entered_.insert(at.index);
    }
  });
}

/// Whether parts of a list are executed in one arm where that is the body of a switch: no label of it between them.
bool Lowering::AreInOneArm(StatementId list, StatementId a, StatementId b) const {
  const StatementId parent = ParentOf(list);
  if (!parent.valid() || unit_.statements[parent].kind != StatementKind::kSwitch) return true;
  bool between = false;
  for (const StatementId part : unit_.statements[list].body) {
    if (between && IsCase(unit_.statements[part].kind)) return false;
    if (part == a || part == b) between = !between;
  }
  return true;
}

StatementId Lowering::ParentOf(StatementId id) const {
  const auto parent = parents_.find(id.index);
  return parent == parents_.end() ? StatementId() : parent->second;
}

/// Gotos into loops and switches, cases inside loops; what a jump leads into becomes flat.
void Lowering::CheckJumps(const Function& function) {
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kGoto && statement.label.valid()) {
      std::unordered_set<uint32_t> around;
      for (StatementId at = id; at.valid(); at = ParentOf(at)) around.insert(at.index);
      const Label& label = unit_.labels[statement.label];
      for (StatementId at = ParentOf(label.statement); at.valid() && !around.contains(at.index); at = ParentOf(at)) {
        const StatementKind kind = unit_.statements[at].kind;
        if (IsLoop(kind) || kind == StatementKind::kSwitch) {
          diagnostics_.Report(statement.range, diag::HncJumpInto, label.name, WordOf(kind));
          break;
        }
        if (kind == StatementKind::kIf) flat_.insert(at.index);
      }
      return;
    }
    if (!IsCase(statement.kind)) return;
    bool direct = true;  // stands in the body of its switch
    for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
      const StatementKind kind = unit_.statements[at].kind;
      if (kind == StatementKind::kSwitch) {
        if (!direct) flat_.insert(at.index);
        return;
      }
      if (IsLoop(kind)) {
        diagnostics_.Report(statement.head, diag::HncCaseInside, WordOf(kind));
        return;
      }
      if (kind == StatementKind::kIf) flat_.insert(at.index);
      const bool body = kind == StatementKind::kCompound && ParentOf(at).valid() &&
                        unit_.statements[ParentOf(at)].kind == StatementKind::kSwitch;
      if (!IsCase(kind) && !body) direct = false;
    }
  });
}

void Lowering::SwitchStatement(const Statement& statement) {
  const Value selector = ConvertSelector(statement.expression);
  const Statement& body = unit_.statements[statement.then];
  StatementId self = ParentOf(statement.then);
  if (flat_.contains(self.index)) {
    FlatSwitch(statement, selector);
    return;
  }
  const Type& type = TypeAt(selector.type);
  const uint32_t end = NewLabel();
  around_.push_back({.on_break = end, .on_continue = 0, .is_loop = false});
  const StatementId outer_elided = std::exchange(elided_break_, {});
  const std::vector<Flow> outer_ends = std::exchange(end_of_switch_, {});
  const std::vector<StatementId> list =
      body.kind == StatementKind::kCompound ? body.body : std::vector<StatementId>{statement.then};
  const Flow before = flow_;
  const std::optional<Cell> cell = CellOfRead(statement.expression);
  ir::Switch arms;
  const ir::RegionId behind = builder_.region();
  bool has_default = false;
  size_t at = 0;
  // In front of the first label: declarations, and what never runs.
  flow_.reachable = false;
  while (at < list.size() && !IsCase(unit_.statements[list[at]].kind)) Lower(list[at++], false);
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
        chosen = chosen ? Join(*chosen, {label.value, label.value}) : Bounds{label.value, label.value};
      }
      labelled = label.then;
    }
    if (is_default) arm.values.clear();
    Flow entered = before;
    if (cell && chosen && !is_default) entered.Narrow(*cell, *chosen);
    const bool fallen = flow_.reachable;
    if (fallen) {
      flow_.JoinWith(entered);
    } else {
      flow_ = entered;
    }
    MarkText(heads, SubjectOf(statement), false);
    size_t next = at + 1;
    while (next < list.size() && !IsCase(unit_.statements[list[next]].kind)) ++next;
    elided_break_ = LastBreak(next == at + 1 ? labelled : list[next - 1]);
    Lower(labelled, false);
    for (size_t i = at + 1; i < next; ++i) Lower(list[i], false);
    if (next == list.size() && body.kind == StatementKind::kCompound) CommentsAtEnd(body.close);
    elided_break_ = {};
    if (flow_.reachable && next < list.size()) {
      arm.falls_through = true;
      CheckFallThrough(labelled, list[next]);
    } else if (flow_.reachable) {
      end_of_switch_.push_back(flow_);
    }
    arms.cases.push_back(std::move(arm));
    at = next;
  }
  builder_.SetRegion(behind);
  if (!has_default) end_of_switch_.push_back(before);
  if (!arms.cases.empty()) builder_.SwitchOn(selector.id, std::move(arms));
  flow_.reachable = false;
  for (const Flow& way : end_of_switch_) flow_.JoinWith(way);
  around_.pop_back();
  PlaceLabel(end);
  elided_break_ = outer_elided;
  end_of_switch_ = outer_ends;
}

Value Lowering::ConvertSelector(ExprId id) {
  const Value selector = Evaluate(id);
  if (!IsInteger(TypeAt(selector.type))) return Zero(int_);
  return ConvertInteger(selector, selector.type);
}

/// The break that ends a group of statements, through blocks and labels; none: it ends otherwise.
StatementId Lowering::LastBreak(StatementId id) const {
  while (id.valid()) {
    const Statement& statement = unit_.statements[id];
    switch (statement.kind) {
      case StatementKind::kBreak:
        return id;
      case StatementKind::kCompound:
        if (statement.body.empty()) return {};
        id = statement.body.back();
        break;
      case StatementKind::kLabel:
        id = statement.then;
        break;
      default:
        return {};
    }
  }
  return {};
}

/// W8: a group that does something runs on into the next one, and no comment says that it is meant.
void Lowering::CheckFallThrough(StatementId from, StatementId to) {
  const Statement& first = unit_.statements[from];
  const bool empty =
      first.kind == StatementKind::kEmpty || (first.kind == StatementKind::kCompound && first.body.empty());
  if (empty) return;
  const source::Range label = unit_.statements[to].head;
  for (const Comment* comment : CommentsIn(unit_, {first.range.begin, label.begin})) {
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
void Lowering::FlatSwitch(const Statement& statement, const Value& selector) {
  const Type& type = TypeAt(selector.type);
  const uint32_t end = NewLabel();
  around_.push_back({.on_break = end, .on_continue = 0, .is_loop = false});
  ir::Switch arms;
  const ir::RegionId behind = builder_.region();
  const Flow before = flow_;
  bool has_default = false;
  const StatementId self = ParentOf(statement.then);
  ForEachStatement(unit_, statement.then, [&](StatementId id) {
    const Statement& label = unit_.statements[id];
    if (!IsCase(label.kind)) return;
    for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
      if (unit_.statements[at].kind != StatementKind::kSwitch) continue;
      if (at != self) return;  // of a switch inside
      break;
    }
    const uint32_t to = case_labels_[id.index] = NewLabel();
    const ir::RegionId arm = builder_.NewRegion();
    builder_.SetRegion(arm);
    flow_ = before;
    JumpTo(to);
    ir::SwitchCase chosen{.values = {}, .region = arm, .falls_through = false};
    if (label.kind == StatementKind::kDefault) {
      has_default = true;
    } else {
      chosen.values.push_back(RawValue(label.value, type));
    }
    arms.cases.push_back(std::move(chosen));
  });
  if (!has_default) {
    const ir::RegionId arm = builder_.NewRegion();
    builder_.SetRegion(arm);
    flow_ = before;
    JumpTo(end);
    arms.cases.push_back({.values = {}, .region = arm, .falls_through = false});
  }
  builder_.SetRegion(behind);
  builder_.SwitchOn(selector.id, std::move(arms));
  flow_.reachable = false;
  Lower(statement.then, false);
  around_.pop_back();
  PlaceLabel(end);
}

}  // namespace plcxx::hnc
