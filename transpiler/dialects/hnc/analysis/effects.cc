#include "transpiler/dialects/hnc/analysis/effects.h"

#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {

Effects::Effects(const Unit& unit) : of_function_(unit.functions.size()), has_inner_stores_(unit.statements.size()) {
  for (uint32_t i = 0; i < unit.expressions.size(); ++i) {
    const ExprKind kind = unit.expressions[ExprId(i)].kind;
    if (kind == ExprKind::kAssign || kind == ExprKind::kCall) flows_.emplace_back(i);
    if (kind == ExprKind::kAddress) addresses_.emplace_back(i);
  }
  std::vector<ExprId> open;
  for (const FunctionId id : unit.definitions) {
    std::vector<ExprId>& effects = of_function_[id.index];
    ForEachStatement(unit, unit.functions[id].body, [&](StatementId statement) {
      ForEachOwnExpr(unit, unit.statements[statement], [&](ExprId root) {
        ForEachExpr(unit, root, open, [&](ExprId part) {
          const bool store = IsStore(unit.expressions[part]);
          if (store && part != root) has_inner_stores_[statement.index] = true;
          if (store || unit.expressions[part].kind == ExprKind::kCall) effects.push_back(part);
        });
      });
    });
  }
}

}  // namespace plcxx::hnc
