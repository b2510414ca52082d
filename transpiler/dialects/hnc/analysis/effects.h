// What each function itself changes and calls: its stores and calls, found in one walk over the tree. A tree is many
// times as large as these, and nearly all that is asked of a whole program is asked of them.
//
// In: the tree. Out: expressions by function, in the order of ForEachExprIn.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

inline bool IsStore(const Expr& expr) {
  return expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement;
}

class Effects {
 public:
  explicit Effects(const Unit& unit);

  /// All assignments and calls of the tree, and all addresses of objects that are taken, by ExprId.
  const std::vector<ExprId>& flows() const { return flows_; }
  const std::vector<ExprId>& addresses() const { return addresses_; }

  /// Stores and calls of a function that the program defines.
  const std::vector<ExprId>& Of(FunctionId function) const { return of_function_[function.index]; }
  /// Whether an expression of the statement stores somewhere else than at its top.
  bool HasInnerStores(StatementId statement) const { return has_inner_stores_[statement.index]; }

 private:
  std::vector<ExprId> flows_, addresses_;
  std::vector<std::vector<ExprId>> of_function_;  // by FunctionId
  std::vector<bool> has_inner_stores_;            // by StatementId
};

}  // namespace plcxx::hnc
