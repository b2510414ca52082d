// Constant expressions by the rules of 6.2, which are not Clang's: shift counts outside the width, wrapping.
#pragma once

#include <optional>

#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

/// None: no value of the type.
std::optional<Constant> Converted(const Constant& value, const Type& from, const Type& to);

class ConstantFolder : private NodeConverter {
 public:
  using NodeConverter::NodeConverter;

  /// Gives the expression its value, if it has one.
  void Fold(Expr& expr);
  /// Where C itself needs the value, a shift count outside the width has none (D33).
  bool HasWildShift(ExprId expr) const;

 private:
  std::optional<Constant> FoldBinary(const Expr& expr);
  std::optional<Constant> FoldUnary(const Expr& expr) const;
};

}  // namespace plcxx::hnc
