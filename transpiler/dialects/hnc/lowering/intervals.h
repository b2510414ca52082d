// What is known of integers on the way: what stores and calls change, what the outcome of a condition says.
#pragma once

#include <optional>
#include <unordered_map>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Intervals : Context {
 public:
  explicit Intervals(const Context& context) : Context(context) {}

  std::optional<Cell> CellOf(const Lvalue& lvalue) const;
  /// What was known of the bytes is no longer; what is known of the value is.
  void NoteStore(const Lvalue& lvalue, const Value& value);
  void ForgetAfterCall(const Expr& expr);
  /// What the statement may change is not known any more.
  void ForgetWrites(StatementId id);
  void ForgetWritesOf(ExprId id);
  /// What is known after a loop whose condition has just been evaluated; here, what is known where it holds. A loop
  /// that counts its iterations is also left while its condition holds.
  Flow RefineWaysOut(ExprId condition, bool counts);
  bool IsLocalObject(ObjectId object) const;
  /// The cell that an operand of a comparison reads, perhaps converted without a change of its value.
  std::optional<Cell> CellOfRead(ExprId id) const;
  /// What the outcome of a condition tells of the cells that it compares.
  void Refine(ExprId condition, bool holds);
  /// By facts of this origin at most: what is decided for good rests on nothing that may be forced.
  Bounds BoundsOfExpr(ExprId id, Origin believed);
  /// Of a function that has been lowered; none: any value.
  std::optional<Bounds> ResultOf(FunctionId function) const;
  void SetResult(FunctionId function, const Bounds& bounds) { results_[function.index] = bounds; }

 private:
  void RefineComparison(const Expr& expr, bool holds);
  std::optional<Bounds> DeclaredBounds(const Cell& cell) const;

  std::unordered_map<uint32_t, Bounds> results_;  // by FunctionId
};

}  // namespace plcxx::hnc
