#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/support/check.h"

#include <algorithm>
#include <optional>

namespace plcxx::hnc {

namespace {

std::string_view WordOf(StatementKind kind) {
  switch (kind) {
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
      return "loop";
    case StatementKind::kSwitch:
      return "switch";
    case StatementKind::kCompound:
    case StatementKind::kDeclaration:
    case StatementKind::kExpression:
    case StatementKind::kEmpty:
    case StatementKind::kIf:
    case StatementKind::kGoto:
    case StatementKind::kContinue:
    case StatementKind::kBreak:
    case StatementKind::kReturn:
    case StatementKind::kLabel:
    case StatementKind::kCase:
    case StatementKind::kDefault:
    case StatementKind::kCriticalEnter:
    case StatementKind::kCriticalLeave:
      return "nested statement";
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

const std::vector<StatementId>& Jumps::JumpsTo(StatementId label) const {
  static const auto* const none = new std::vector<StatementId>();
  const auto found = jumps_to_.find(label.index);
  return found == jumps_to_.end() ? *none : found->second;
}

Span Jumps::Repeated(LabelId label, const std::vector<StatementId>& jumps) const {
  Span span{OrderOf(unit_.labels[label].statement), 0};
  const auto grow = [&](StatementId to) { span.last = std::max(span.last, OrderOf(to)); };
  for (const StatementId jump : jumps) grow(jump);
  for (size_t i = span.first; i <= span.last; ++i) {
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

bool Jumps::IsEnteredElsewhere(const Span& span) const {
  for (size_t i = span.first + size_t{1}; i <= span.last; ++i) {
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

bool Jumps::HasChoiceAround(StatementId label, StatementId jump) const {
  StatementId at = ParentOf(label);
  for (; at.valid() && !Holds(at, jump); at = ParentOf(at)) {
    const StatementKind kind = unit_.statements[at].kind;
    if (kind == StatementKind::kIf || kind == StatementKind::kSwitch) return true;
  }
  // The label in one arm, the jump in the other one.
  return at.valid() && unit_.statements[at].kind == StatementKind::kIf && !Holds(label, jump);
}

bool Jumps::GoesOn(StatementId id, bool& continues) const {
  if (!id.valid()) return true;
  const Statement& statement = unit_.statements[id];
  switch (statement.kind) {
    case StatementKind::kCompound: {
      bool on = true;
      for (const StatementId part : statement.body) {
        if (!on && !IsEntered(part)) continue;
        on = GoesOn(part, continues);
      }
      return on;
    }
    case StatementKind::kReturn:
    case StatementKind::kBreak:
      return false;
    case StatementKind::kGoto:
      // Out of the loop, or to a label in it, after which all is looked at as well.
      return MayBeRefused(unit_, statement);
    case StatementKind::kContinue:
      continues = true;
      return false;
    case StatementKind::kIf: {
      const bool then = GoesOn(statement.then, continues);
      const bool otherwise = statement.otherwise.valid() ? GoesOn(statement.otherwise, continues) : true;
      return then || otherwise;
    }
    case StatementKind::kLabel:
      return GoesOn(statement.then, continues);
    case StatementKind::kDeclaration:
    case StatementKind::kExpression:
    case StatementKind::kEmpty:
    case StatementKind::kSwitch:
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
    case StatementKind::kCase:
    case StatementKind::kDefault:
    case StatementKind::kCriticalEnter:
    case StatementKind::kCriticalLeave:
      ForEachStatement(unit_, id, [&](StatementId part) { continues = continues || Continues(part, id); });
      return true;
  }
  PLCXX_UNREACHABLE();
}

/// Whether a statement in `outer` is a `continue` that belongs to a loop around `outer`.
bool Jumps::Continues(StatementId id, StatementId outer) const {
  if (unit_.statements[id].kind != StatementKind::kContinue) return false;
  for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
    if (IsLoop(unit_.statements[at].kind)) return false;
    if (at == outer) break;
  }
  return true;
}

void Jumps::Find(const Function& function) {
  // Anew, not cleared: to clear a map takes as long as the largest function did.
  statements_ = {};
  jumps_to_ = {};
  flat_ = {};
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    statements_.push_back(id);
    if (statement.kind == StatementKind::kGoto && statement.label.valid()) {
      jumps_to_[unit_.labels[statement.label].statement.index].push_back(id);
    }
  });
  FindNodes();
  live_gotos_ = FindLiveGotos(unit_, function.body);
  FindEntries(function);
  CheckJumps(function);
}

void Jumps::FindNodes() {
  nodes_.clear();
  if (statements_.empty()) return;
  const auto [least, most] = std::ranges::minmax(statements_);
  first_node_ = least.index;
  nodes_.resize(size_t{most.index} - least.index + 1);
  const auto at = [this](StatementId id) -> Node& { return nodes_[id.index - first_node_]; };
  for (uint32_t i = 0; i < statements_.size(); ++i) {
    const StatementId id = statements_[i];
    at(id).order = at(id).last = i;
    const Statement& statement = unit_.statements[id];
    for (const StatementId child : statement.body) at(child).parent = id;
    if (statement.then.valid()) at(statement.then).parent = id;
    if (statement.otherwise.valid()) at(statement.otherwise).parent = id;
  }
  for (size_t i = statements_.size(); i-- > 0;) {
    const Node& node = at(statements_[i]);
    if (node.parent.valid()) at(node.parent).last = std::max(at(node.parent).last, node.last);
  }
}

const Jumps::Node* Jumps::NodeOf(StatementId id) const {
  const size_t at = size_t{id.index} - first_node_;
  return at < nodes_.size() && nodes_[at].order != kNowhere ? &nodes_[at] : nullptr;
}

/// What is lowered although control does not come to its beginning: a live goto or a switch outside of it leads to a
/// label in it. A switch with a goto to what is not in the same arm becomes flat.
void Jumps::FindEntries(const Function& function) {
  entered_.clear();
  std::unordered_set<uint32_t> around_cases;  // by StatementId, up to the switch
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kGoto && live_gotos_.contains(id.index)) {
      StatementId at = unit_.labels[statement.label].statement, part;
      for (; at.valid() && !Holds(at, id); part = at, at = ParentOf(at)) entered_.insert(at.index);
      if (part.valid() && at.valid() && !AreInOneArm(at, part, id)) flat_.insert(ParentOf(at).index);
    }
    if (!IsCase(statement.kind)) return;
    for (StatementId at = id; at.valid() && unit_.statements[at].kind != StatementKind::kSwitch; at = ParentOf(at)) {
      entered_.insert(at.index);
      if (!around_cases.insert(at.index).second) break;  // another label of the switch has been here
    }
  });
}

/// Whether a part of a list and a jump in another part are executed in one arm where the list is the body of a switch:
/// no label of it between them.
bool Jumps::AreInOneArm(StatementId list, StatementId a, StatementId jump) const {
  const StatementId parent = ParentOf(list);
  if (!parent.valid() || unit_.statements[parent].kind != StatementKind::kSwitch) return true;
  bool between = false;
  for (const StatementId part : unit_.statements[list].body) {
    if (between && IsCase(unit_.statements[part].kind)) return false;
    if (part == a || Holds(part, jump)) between = !between;
  }
  return true;
}

StatementId Jumps::ParentOf(StatementId id) const {
  const Node* node = NodeOf(id);
  return node == nullptr ? StatementId() : node->parent;
}

/// Gotos into loops and switches, cases inside loops; what a jump leads into becomes flat.
void Jumps::CheckJumps(const Function& function) {
  std::unordered_map<uint32_t, std::optional<StatementKind>> loops_around;  // by label of a switch: a loop in between
  ForEachStatement(unit_, function.body, [&](StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kGoto && statement.label.valid()) {
      const Label& label = unit_.labels[statement.label];
      if (Holds(label.statement, id)) return;
      StatementId at = ParentOf(label.statement);
      for (; at.valid() && !Holds(at, id); at = ParentOf(at)) {
        const StatementKind kind = unit_.statements[at].kind;
        if (IsLoop(kind) || kind == StatementKind::kSwitch) {
          diagnostics_.Report(statement.range, diag::HncJumpInto, label.name, WordOf(kind));
          return;
        }
        if (kind == StatementKind::kIf) flat_.insert(at.index);
      }
      // From one arm into the other.
      if (at.valid() && unit_.statements[at].kind == StatementKind::kIf) flat_.insert(at.index);
      return;
    }
    if (!IsCase(statement.kind)) return;
    const auto above = loops_around.find(ParentOf(id).index);
    if (above != loops_around.end()) {  // `case 1: case 2:`, and all around it is looked at
      if (above->second) diagnostics_.Report(statement.head, diag::HncCaseInside, WordOf(*above->second));
      loops_around.emplace(id.index, above->second);
      return;
    }
    std::optional<StatementKind>& loop_around = loops_around[id.index];
    bool direct = true;  // stands in the body of its switch
    for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
      const StatementKind kind = unit_.statements[at].kind;
      if (kind == StatementKind::kSwitch) {
        if (!direct) flat_.insert(at.index);
        return;
      }
      if (IsLoop(kind)) {
        diagnostics_.Report(statement.head, diag::HncCaseInside, WordOf(kind));
        loop_around = kind;
        return;
      }
      if (kind == StatementKind::kIf) flat_.insert(at.index);
      const bool body = kind == StatementKind::kCompound && ParentOf(at).valid() &&
                        unit_.statements[ParentOf(at)].kind == StatementKind::kSwitch;
      if (!IsCase(kind) && !body) direct = false;
    }
  });
}

bool Jumps::Holds(StatementId outer, StatementId inner) const {
  const Node* node = NodeOf(outer);
  return node != nullptr && node->order <= OrderOf(inner) && OrderOf(inner) <= node->last;
}

uint32_t Jumps::OrderOf(StatementId id) const {
  const Node* node = NodeOf(id);
  return node == nullptr ? kNowhere : node->order;
}

bool Jumps::IsPartOf(StatementId id, const std::vector<StatementId>& statements) const {
  for (StatementId at = id; at.valid(); at = ParentOf(at)) {
    if (std::ranges::find(statements, at) != statements.end()) return true;
  }
  return false;
}

}  // namespace plcxx::hnc
