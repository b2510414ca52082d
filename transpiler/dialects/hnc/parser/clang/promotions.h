// What holds the value of a bit-field is promoted to int (specification 6.1), also after a postfix ++ or --.
//
// Clang promotes what it can follow to a field: an access, an assignment, a prefix step, an operand of a comma. Of
// `s.f++` it keeps the declared type, so that `s.f++ - 5` would be 65531 where `s.f - 5` is -5. Here such a value is
// int; operators above it, which Clang computes in `unsigned int` for its sake alone, are int, too. Everything else has
// the type that Clang gives it. Where the sign of such a value can matter, Clang's own code of the function is no
// measure of the program, and the function is marked.
#pragma once

#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class Promotions : private NodeConverter {
 public:
  Promotions(Conversion& conversion, TypeConverter& types, ExpressionBuilder& builder)
      : NodeConverter(conversion), types_(types), builder_(builder) {}

  /// The operand, promoted if it is the value of a bit-field after a postfix ++ or --.
  ExprId Promoted(ExprId operand, const clang::Expr* expr);
  /// In the type that Clang gives it.
  ExprId Unpromoted(ExprId operand, const clang::Expr* expr);
  /// Is it int where Clang has unsigned int?
  bool IsPromoted(ExprId operand, const clang::Expr* expr) const;
  /// a op= b, where b is promoted: a alone decides, and where that is unsigned or no integer, Clang's type is right.
  void CommonTypeOfAssignment(const clang::CompoundAssignOperator* expr, Expr& result);
  /// Of two operands that Clang has brought to one type: int where only promoted values made it unsigned int, and then
  /// both are; none: that of Clang, which both have.
  TypeId CommonType(ExprId& a, const clang::Expr* of_a, ExprId& b, const clang::Expr* of_b);

  /// Here a op b is computed in int, in Clang's code in unsigned int; marks the function where the results may differ.
  void MarkOperator(BinaryOp op, ExprId a, ExprId b);
  /// An operand that is promoted becomes `type`.
  void MarkConversion(ExprId operand, TypeId type);

 private:
  bool BecomesInt(const clang::Expr* expr) const;
  bool MayBeNegative(ExprId operand) const;
  void MarkFunction();

  TypeConverter& types_;
  ExpressionBuilder& builder_;
};

}  // namespace plcxx::hnc
