// Visiting parts of a tree without recursion: chains of operators nest without limit.
#pragma once

#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// As ForEachExpr below; parts for which wanted(ExprId) is false are left out with all that is in them.
template <class Wanted, class Visit>
void ForEachExprWhere(const Unit& unit, ExprId root, std::vector<ExprId>& open, Wanted&& wanted, Visit&& visit) {
  const auto push = [&](ExprId id) {
    if (id.valid() && wanted(id)) open.push_back(id);
  };
  push(root);
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    visit(id);
    const Expr& expr = unit.expressions[id];
    for (const ExprId argument : expr.arguments) push(argument);
    push(expr.c);
    push(expr.b);
    push(expr.a);
  }
}

/// Calls visit(ExprId) for the expression and everything in it, each one before its parts. `open` is empty before and
/// afterwards: who visits many gives the same one.
template <class Visit>
void ForEachExpr(const Unit& unit, ExprId root, std::vector<ExprId>& open, Visit&& visit) {
  ForEachExprWhere(unit, root, open, [](ExprId) { return true; }, visit);
}

template <class Visit>
void ForEachExpr(const Unit& unit, ExprId root, Visit&& visit) {
  std::vector<ExprId> open;
  ForEachExpr(unit, root, open, visit);
}

/// The expressions that a statement holds itself, initialisers included, in the order of their evaluation.
template <class Visit>
void ForEachOwnExpr(const Unit& unit, const Statement& statement, Visit&& visit) {
  for (const ExprId id : {statement.first, statement.expression, statement.step}) {
    if (id.valid()) visit(id);
  }
  for (const VariableId id : statement.variables) {
    if (unit.variables[id].storage != Storage::kAutomatic) continue;
    for (const InitialValue& initial : unit.variables[id].initial) {
      if (initial.value.valid()) visit(initial.value);
    }
  }
}

/// Calls visit(StatementId) for the statement and everything in it, in the order of the source.
template <class Visit>
void ForEachStatement(const Unit& unit, StatementId root, Visit&& visit) {
  std::vector<StatementId> open;
  const auto push = [&open](StatementId id) {
    if (id.valid()) open.push_back(id);
  };
  push(root);
  while (!open.empty()) {
    const StatementId id = open.back();
    open.pop_back();
    visit(id);
    const Statement& statement = unit.statements[id];
    push(statement.otherwise);
    push(statement.then);
    for (size_t i = statement.body.size(); i-- > 0;) push(statement.body[i]);
  }
}

/// All expressions under a statement.
template <class Visit>
void ForEachExprIn(const Unit& unit, StatementId root, Visit&& visit) {
  std::vector<ExprId> open;
  ForEachStatement(unit, root, [&](StatementId id) {
    ForEachOwnExpr(unit, unit.statements[id], [&](ExprId expr) { ForEachExpr(unit, expr, open, visit); });
  });
}

}  // namespace plcxx::hnc
