#include "transpiler/dialects/hnc/analysis/registrations.h"

#include <algorithm>

#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {
namespace {

/// Follows what is executed from the beginning of init() on, whatever values the program meets.
class Straight {
 public:
  Straight(const Unit& unit, const Facts& facts) : unit_(unit), facts_(facts) {}

  /// The calls of set_mst_func on the way, in order.
  std::vector<ExprId> Calls() {
    if (unit_.init.valid()) Follow(unit_.init);
    return calls_;
  }

 private:
  static constexpr size_t kDeepest = 64;  // of calls (6.4); a program with recursion is refused elsewhere

  void Follow(FunctionId function) {
    if (depth_ == kDeepest || !unit_.functions[function].body.valid()) return;
    ++depth_;
    Follow(unit_.functions[function].body);
    --depth_;
  }

  /// False: what stands after it in the function need not be executed.
  bool Follow(StatementId id) {
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kCompound) {
      return std::ranges::all_of(statement.body, [this](StatementId part) { return Follow(part); });
    }
    if (statement.kind == StatementKind::kExpression) FollowCall(statement.expression);
    bool goes_on = true;
    ForEachStatement(unit_, id, [&](StatementId part) {
      const StatementKind kind = unit_.statements[part].kind;
      if (kind == StatementKind::kReturn || kind == StatementKind::kGoto || kind == StatementKind::kLabel) {
        goes_on = false;
      }
    });
    return goes_on;
  }

  void FollowCall(ExprId id) {
    const Expr& expr = unit_.expressions[id];
    if (expr.kind == ExprKind::kComma) {
      FollowCall(expr.a);
      FollowCall(expr.b);
      return;
    }
    if (expr.kind != ExprKind::kCall || !expr.function.valid()) return;
    if (std::ranges::find(facts_.registrations(), id, &Registration::call) != facts_.registrations().end()) {
      calls_.push_back(id);
    } else {
      Follow(expr.function);
    }
  }

  const Unit& unit_;
  const Facts& facts_;
  std::vector<ExprId> calls_;
  size_t depth_ = 0;
};

}  // namespace

FixedHandlers FindFixedHandlers(const Unit& unit, const Facts& facts) {
  const std::vector<ExprId> calls = Straight(unit, facts).Calls();
  FixedHandlers fixed;
  for (const ExprId call : calls) {
    const Registration& registration = *std::ranges::find(facts.registrations(), call, &Registration::call);
    fixed[registration.channel][registration.kind] = registration.function;
  }
  for (const Registration& registration : facts.registrations()) {
    if (std::ranges::find(calls, registration.call) == calls.end()) {
      fixed[registration.channel][registration.kind] = std::nullopt;
    }
  }
  return fixed;
}

}  // namespace plcxx::hnc
