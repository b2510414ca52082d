// Variables and their initialisers (specification 3.1, 3.2, 9.2).
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/declared_type_checker.h"
#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class ExpressionConverter;

class VariableConverter : private NodeConverter {
 public:
  VariableConverter(Conversion& conversion, TypeConverter& types, DeclaredTypeChecker& checker,
                    ExpressionBuilder& builder, ExpressionConverter& expressions)
      : NodeConverter(conversion), types_(types), checker_(checker), builder_(builder), expressions_(expressions) {}

  VariableId VariableOf(const clang::VarDecl* variable);
  /// A declaration of the program for a name of the system header (9.2).
  void CheckSystemVariable(const clang::VarDecl* variable);

 private:
  void DescribeFileVariable(const clang::VarDecl* variable, Variable& result);
  void Initialise(const clang::VarDecl* variable, VariableId id);
  void CheckConstant(const clang::Expr* init);
  void Flatten(const clang::Expr* init, clang::QualType type, uint32_t offset, std::vector<InitialValue>& values);

  TypeConverter& types_;
  DeclaredTypeChecker& checker_;
  ExpressionBuilder& builder_;
  ExpressionConverter& expressions_;
  struct Known {
    VariableId id;
    uint32_t noted = 0;  // by which body last
  };
  void Note(const clang::VarDecl* variable, Known& known);

  std::unordered_map<const clang::VarDecl*, Known> variables_;  // only asked
};

}  // namespace plcxx::hnc
