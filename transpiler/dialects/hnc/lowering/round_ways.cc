#include "transpiler/dialects/hnc/lowering/round_ways.h"

#include <algorithm>
#include <optional>

#include "transpiler/dialects/hnc/analysis/live_jumps.h"
#include "transpiler/dialects/hnc/syntax/walk.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

namespace {

/// Jumps back in a chain bring something new one walk at a time: a program that needs more walks is not looked at.
constexpr int kMostWalks = 20;

constexpr Ways kAny{.never = true, .once = true, .more = true};

Ways Passed(const Ways& ways) { return {.never = false, .once = ways.never, .more = ways.once || ways.more}; }

}  // namespace

RoundWays::RoundWays(const Unit& unit, const std::vector<ExprId>& passed) : unit_(unit) {
  for (const ExprId id : passed) passed_.insert(id.index);
}

Ways RoundWays::Of(const LoopShape& loop) {
  return UntilStable([&] {
    Ways ways{.never = true};
    for (const StatementId id : loop.body) ways = Execute(id, ways);
    ways = Evaluate(loop.step, ways | continues_);
    return EvaluateTrue(loop.condition, ways);
  });
}

bool RoundWays::LeadTo(StatementId label, const std::vector<StatementId>& jumps, StatementId function_body) {
  start_ = label;
  for (const StatementId jump : jumps) looked_for_.insert(jump.index);
  return UntilStable([&] { return Execute(function_body, {}); }) == kAny || found_;
}

/// Walks until jumps back bring nothing new.
template <class Walk>
Ways RoundWays::UntilStable(Walk&& walk) {
  for (int i = 0; i < kMostWalks; ++i) {
    again_ = false;
    labels_behind_.clear();
    const Ways ways = walk();
    if (!again_) return ways;
  }
  return kAny;
}

/// In any order, for that changes no count; and along the left side without recursion, for sums may be long.
Ways RoundWays::Evaluate(ExprId id, Ways ways) const {
  for (; id.valid(); id = unit_.expressions[id].a) {
    const Expr& expr = unit_.expressions[id];
    if (passed_.contains(id.index)) ways = Passed(ways);
    if (expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr) {
      ways = ways | Evaluate(expr.b, ways);
    } else if (expr.kind == ExprKind::kConditional) {
      ways = Evaluate(expr.b, ways) | Evaluate(expr.c, ways);
    } else {
      ways = Evaluate(expr.c, Evaluate(expr.b, ways));
      for (const ExprId argument : expr.arguments) ways = Evaluate(argument, ways);
    }
  }
  return ways;
}

/// As far as the value is not 0: behind an && both sides have been evaluated.
Ways RoundWays::EvaluateTrue(ExprId id, Ways ways) const {
  while (id.valid() && unit_.expressions[id].kind == ExprKind::kAnd) {
    ways = EvaluateTrue(unit_.expressions[id].b, ways);
    id = unit_.expressions[id].a;
  }
  if (id.valid() && unit_.expressions[id].kind == ExprKind::kComma) {
    return EvaluateTrue(unit_.expressions[id].b, Evaluate(unit_.expressions[id].a, ways));
  }
  return Evaluate(id, ways);
}

/// The ways at the end of the statement.
Ways RoundWays::Execute(StatementId id, Ways ways) {
  if (!id.valid()) return ways;
  const Statement& statement = unit_.statements[id];
  switch (statement.kind) {
    case StatementKind::kCompound:
      for (const StatementId part : statement.body) ways = Execute(part, ways);
      return ways;
    case StatementKind::kIf:
      return ExecuteIf(statement, ways);
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
      return ExecuteLoop(id, ways);
    case StatementKind::kSwitch:
      return ExecuteSwitch(statement, ways);
    case StatementKind::kCase:
    case StatementKind::kDefault:
      return Execute(statement.then, ways | EnterCase(statement));
    case StatementKind::kLabel:
      labels_behind_.insert(statement.label.index);
      return Execute(statement.then, id == start_ ? Ways{.never = true} : ways | labels_[statement.label.index]);
    case StatementKind::kGoto:
    case StatementKind::kContinue:
    case StatementKind::kBreak:
    case StatementKind::kReturn:
      return ExecuteJump(id, ways);
    case StatementKind::kDeclaration:
    case StatementKind::kExpression:
    case StatementKind::kEmpty:
    case StatementKind::kCriticalEnter:
    case StatementKind::kCriticalLeave:
      ForEachOwnExpr(unit_, statement, [&](ExprId expr) { ways = Evaluate(expr, ways); });
      return ways;
  }
  PLCXX_UNREACHABLE();
}

Ways RoundWays::ExecuteIf(const Statement& statement, Ways ways) {
  ways = Evaluate(statement.expression, ways);
  const Ways then = Execute(statement.then, ways);
  return then | Execute(statement.otherwise, ways);
}

Ways RoundWays::ExecuteLoop(StatementId id, Ways ways) {
  const Statement& loop = unit_.statements[id];
  const bool is_do = loop.kind == StatementKind::kDo;
  const std::optional<bool> always = ConstantCondition(unit_, loop.expression);
  const bool endless = !loop.expression.valid() || always == true, once = is_do && always == false;
  if (loop.kind == StatementKind::kFor) ways = Evaluate(loop.first, ways);
  const Ways head = ways | heads_[id.index];
  const Ways entered = is_do ? head : Evaluate(loop.expression, head);
  around_.push_back({.is_loop = true, .defaults = false, .entry = {}, .breaks = {}, .continues = {}});
  const Ways end = Execute(loop.then, entered);
  const Around around = around_.back();
  around_.pop_back();
  Ways next = end | around.continues;
  if (loop.kind == StatementKind::kFor) next = Evaluate(loop.step, next);
  if (is_do) next = Evaluate(loop.expression, next);
  if (!once) {
    again_ = again_ || (head | next) != head;
    heads_[id.index] = heads_[id.index] | next;
  }
  const Ways left = is_do ? next : entered;
  return around.breaks | (endless ? Ways() : left) | (loop.loop_bound ? left : Ways());
}

Ways RoundWays::ExecuteSwitch(const Statement& statement, Ways ways) {
  const Ways entry = Evaluate(statement.expression, ways);
  around_.push_back({.is_loop = false, .defaults = false, .entry = entry, .breaks = {}, .continues = {}});
  const Ways end = Execute(statement.then, {});
  const Around around = around_.back();
  around_.pop_back();
  return end | around.breaks | (around.defaults ? Ways() : entry);
}

/// What comes from the head of the switch to a label of it.
Ways RoundWays::EnterCase(const Statement& label) {
  const auto around = std::ranges::find_if_not(around_.rbegin(), around_.rend(), &Around::is_loop);
  if (around == around_.rend()) return {};  // of a switch around the loop: that is refused
  around->defaults = around->defaults || label.kind == StatementKind::kDefault;
  return around->entry;
}

Ways RoundWays::ExecuteJump(StatementId id, const Ways& ways) {
  const Statement& jump = unit_.statements[id];
  if (jump.kind == StatementKind::kGoto) {
    found_ = found_ || (ways.exist() && looked_for_.contains(id.index));
    if (!jump.label.valid()) return {};
    Ways& known = labels_[jump.label.index];
    again_ = again_ || (labels_behind_.contains(jump.label.index) && (known | ways) != known);
    known = known | ways;
    return MayBeRefused(unit_, jump) ? ways : Ways();
  }
  if (jump.kind == StatementKind::kBreak && !around_.empty()) around_.back().breaks = around_.back().breaks | ways;
  if (jump.kind == StatementKind::kContinue) {
    const auto loop = std::ranges::find_if(around_.rbegin(), around_.rend(), &Around::is_loop);
    Ways& continues = loop == around_.rend() ? continues_ : loop->continues;
    continues = continues | ways;
  }
  return {};
}

}  // namespace plcxx::hnc
