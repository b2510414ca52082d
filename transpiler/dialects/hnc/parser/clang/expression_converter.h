// Expressions: operands, conversions, accesses (specification 6.1, 6.5).
#pragma once

#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/promotions.h"

namespace plcxx::hnc {

class CallConverter;
class OperatorConverter;
class VariableConverter;

class ExpressionConverter : private NodeConverter {
 public:
  ExpressionConverter(Conversion& conversion, TypeConverter& types, ExpressionBuilder& builder, Promotions& promotions,
                      VariableConverter& variables, OperatorConverter& operators, CallConverter& calls)
      : NodeConverter(conversion),
        types_(types),
        builder_(builder),
        promotions_(promotions),
        variables_(variables),
        operators_(operators),
        calls_(calls) {}

  /// In the type that Clang gives it.
  ExprId Convert(const clang::Expr* expr);
  /// The operand of an operator that promotes. After a postfix ++ or -- Clang forgets that the value is that of a
  /// bit-field: where it has `unsigned int` then, this gives `int` as 6.1 says (promotions.h).
  ExprId Operand(const clang::Expr* expr);

 private:
  ExprId AnyExpression(const clang::Expr* expr);
  ExprId Parenthesised(const clang::ParenExpr* expr);
  ExprId Name(const clang::DeclRefExpr* expr);
  ExprId Cast(const clang::CastExpr* expr);
  ExprId Unary(const clang::UnaryOperator* expr);
  ExprId Element(const clang::ArraySubscriptExpr* expr);
  ExprId MemberAccess(const clang::MemberExpr* expr);
  ExprId Conditional(const clang::ConditionalOperator* expr);

  TypeConverter& types_;
  ExpressionBuilder& builder_;
  Promotions& promotions_;
  VariableConverter& variables_;
  OperatorConverter& operators_;
  CallConverter& calls_;
};

}  // namespace plcxx::hnc
