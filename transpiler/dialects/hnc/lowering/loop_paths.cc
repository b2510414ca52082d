#include "transpiler/dialects/hnc/lowering/loop_paths.h"

#include <algorithm>

#include "transpiler/dialects/hnc/lowering/jumps.h"

namespace plcxx::hnc {

/// Whether the change is executed in every evaluation of `root`.
bool LoopPaths::IsUnconditional(ExprId change, ExprId root) const {
  std::vector<ExprId> open = {root};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid()) continue;
    if (id == change) return true;
    const Expr& expr = ExprAt(id);
    open.push_back(expr.a);
    const bool skips = expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr || expr.kind == ExprKind::kConditional;
    if (skips) continue;
    open.push_back(expr.b);
    open.insert(open.end(), expr.arguments.begin(), expr.arguments.end());
  }
  return false;
}

bool LoopPaths::IsInEveryIteration(ExprId change, const LoopShape& loop) const {
  for (const StatementId test : loop.tests) {
    if (IsUnconditional(change, unit_.statements[test].expression)) return !IsPassedBy(test, loop);
  }
  // Statements one after the other.
  std::vector<StatementId> list(loop.body.rbegin(), loop.body.rend());
  while (!list.empty()) {
    const StatementId id = list.back();
    list.pop_back();
    if (!id.valid()) continue;
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kCompound) {
      list.insert(list.end(), statement.body.rbegin(), statement.body.rend());
      continue;
    }
    if (statement.kind == StatementKind::kLabel) {
      list.push_back(statement.then);
      continue;
    }
    const bool plain = statement.kind == StatementKind::kExpression;
    const bool head = statement.kind == StatementKind::kIf || statement.kind == StatementKind::kSwitch;
    const bool first = statement.kind == StatementKind::kFor && statement.first.valid();
    if (((plain || head) && IsUnconditional(change, statement.expression)) ||
        (first && IsUnconditional(change, statement.first))) {
      return !IsPassedBy(id, loop);
    }
  }
  return false;
}

bool LoopPaths::PathBack(StatementId label, StatementId jump, std::vector<StatementId>& body,
                         std::vector<RoundTest>& tests) const {
  std::unordered_set<uint32_t> around;
  for (StatementId at = jump; at.valid(); at = jumps_.ParentOf(at)) around.insert(at.index);
  const auto holds_jump = [&around](StatementId id) { return id.valid() && around.contains(id.index); };
  // Pushes the statements up to the one with the jump in it, which is the result.
  const auto pass = [&](const std::vector<StatementId>& list, size_t from) {
    for (size_t i = from; i < list.size(); ++i) {
      if (holds_jump(list[i])) return list[i];
      body.push_back(list[i]);
    }
    return StatementId();
  };
  StatementId at = unit_.statements[label].then;
  if (!holds_jump(label)) {
    body.push_back(at);
    StatementId first = label;  // with what labels stand in front of this one
    while (jumps_.ParentOf(first).valid() && unit_.statements[jumps_.ParentOf(first)].then == first &&
           (unit_.statements[jumps_.ParentOf(first)].kind == StatementKind::kLabel ||
            IsCase(unit_.statements[jumps_.ParentOf(first)].kind))) {
      first = jumps_.ParentOf(first);
    }
    if (!jumps_.ParentOf(first).valid()) return false;
    const std::vector<StatementId>& list = unit_.statements[jumps_.ParentOf(first)].body;
    const auto found =
        std::ranges::lower_bound(list, jumps_.OrderOf(first), {}, [&](StatementId id) { return jumps_.OrderOf(id); });
    at = found == list.end() || *found != first ? StatementId()
                                                : pass(list, static_cast<size_t>(found - list.begin()) + 1);
  }
  while (at.valid() && at != jump) {
    const Statement& statement = unit_.statements[at];
    switch (statement.kind) {
      case StatementKind::kCompound:
        at = pass(statement.body, 0);
        break;
      case StatementKind::kLabel:
        at = statement.then;
        break;
      case StatementKind::kIf: {
        const bool then = holds_jump(statement.then);
        tests.push_back({.test = at, .holds = then, .in_front = body.size()});
        at = then ? statement.then : statement.otherwise;
        break;
      }
      case StatementKind::kDeclaration:
      case StatementKind::kExpression:
      case StatementKind::kEmpty:
      case StatementKind::kSwitch:
      case StatementKind::kWhile:
      case StatementKind::kDo:
      case StatementKind::kFor:
      case StatementKind::kGoto:
      case StatementKind::kContinue:
      case StatementKind::kBreak:
      case StatementKind::kReturn:
      case StatementKind::kCase:
      case StatementKind::kDefault:
      case StatementKind::kCriticalEnter:
      case StatementKind::kCriticalLeave:
        return false;
    }
  }
  return at.valid();
}

bool LoopPaths::IsPassedBy(StatementId place, const LoopShape& loop) const {
  const std::vector<StatementId>& statements = jumps_.statements();
  const uint32_t middle = jumps_.OrderOf(place);
  // To the label itself only the jump back leads, and what enters the loop.
  for (size_t i = loop.region.first + size_t{1}; i <= loop.region.last; ++i) {
    if (unit_.statements[statements[i]].kind != StatementKind::kLabel) continue;
    for (const StatementId jump : jumps_.JumpsTo(statements[i])) {
      const uint32_t from = jumps_.OrderOf(jump);
      if (from < loop.region.first) continue;
      if (!jumps_.IsPartOf(jump, loop.body) || (from < middle) != (i <= middle)) return true;
    }
  }
  return false;
}

}  // namespace plcxx::hnc
