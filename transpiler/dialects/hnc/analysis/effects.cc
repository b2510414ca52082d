#include "transpiler/dialects/hnc/analysis/effects.h"

#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {

Effects::Effects(const Unit& unit) : of_function_(unit.functions.size()), has_inner_stores_(unit.statements.size()) {
  // By ExprId: it is a store or a call, or has one in it. Parts have smaller ids, and in calls all are of interest.
  std::vector<uint8_t> has_effect(unit.expressions.size());
  const auto has = [&](ExprId id) { return id.valid() && has_effect[id.index] != 0; };
  for (uint32_t i = 0; i < unit.expressions.size(); ++i) {
    const Expr& expr = unit.expressions[ExprId(i)];
    if (expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCall) flows_.emplace_back(i);
    if (expr.kind == ExprKind::kAddress) addresses_.emplace_back(i);
    const bool own = IsStore(expr) || expr.kind == ExprKind::kCall || !expr.arguments.empty();
    has_effect[i] = own || has(expr.a) || has(expr.b) || has(expr.c) ? 1 : 0;
  }
  std::vector<ExprId> open;
  for (const FunctionId id : unit.definitions) {
    std::vector<ExprId>& effects = of_function_[id.index];
    ForEachStatement(unit, unit.functions[id].body, [&](StatementId statement) {
      ForEachOwnExpr(unit, unit.statements[statement], [&](ExprId root) {
        const auto has_some = [&](ExprId part) { return has(part); };
        ForEachExprWhere(unit, root, open, has_some, [&](ExprId part) {
          const bool store = IsStore(unit.expressions[part]);
          if (store && part != root) has_inner_stores_[statement.index] = true;
          if (store || unit.expressions[part].kind == ExprKind::kCall) effects.push_back(part);
        });
      });
    });
  }
}

}  // namespace plcxx::hnc
