// Operators with two operands, assignments (specification 6.2, 6.4).
#pragma once

#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/promotions.h"

namespace plcxx::hnc {

class ExpressionConverter;

class OperatorConverter : private NodeConverter {
 public:
  OperatorConverter(Conversion& conversion, TypeConverter& types, ExpressionBuilder& builder, Promotions& promotions,
                    ExpressionConverter& expressions)
      : NodeConverter(conversion),
        types_(types),
        builder_(builder),
        promotions_(promotions),
        expressions_(expressions) {}

  ExprId Binary(const clang::BinaryOperator* expr);
  ExprId CompoundAssignment(const clang::CompoundAssignOperator* expr);
  /// Is the target an element of F_T or G_T, which are constant addresses?
  bool ReportTableStore(const clang::Expr* target);

 private:
  ExprId Assignment(const clang::BinaryOperator* expr);
  ExprId PointerArithmetic(const clang::BinaryOperator* expr, Expr result);
  bool ReportComparedAddress(const clang::BinaryOperator* expr);
  bool ReportZeroDivisor(const Expr& result);

  TypeConverter& types_;
  ExpressionBuilder& builder_;
  Promotions& promotions_;
  ExpressionConverter& expressions_;
};

}  // namespace plcxx::hnc
