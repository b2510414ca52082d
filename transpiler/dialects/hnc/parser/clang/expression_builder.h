// Expressions of the tree: with the types and places of Clang's, folded when they are added.
#pragma once

#include <cstdint>

#include "transpiler/dialects/hnc/parser/clang/constant_folder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/type_converter.h"

namespace plcxx::hnc {

class ExpressionBuilder : private NodeConverter {
 public:
  ExpressionBuilder(Conversion& conversion, TypeConverter& types, ConstantFolder& folder)
      : NodeConverter(conversion), types_(types), folder_(folder) {}

  /// Without a place.
  Expr Unplaced(ExprKind kind, const clang::Expr* expr);
  Expr Start(ExprKind kind, const clang::Expr* expr);
  ExprId Add(Expr expr);
  ExprId Poison(const clang::Expr* expr);
  ExprId Integer(const clang::Expr* expr, int64_t value);
  ExprId String(const clang::StringLiteral* expr, TypeId type);
  /// The operand converted, as the same text.
  ExprId InType(ExprId operand, TypeId type);
  /// Where the expression is, which macro wrote it, and whether that wrote nothing else.
  void Locate(const clang::Expr* expr, Expr& result) const;

 private:
  TypeConverter& types_;
  ConstantFolder& folder_;
};

}  // namespace plcxx::hnc
