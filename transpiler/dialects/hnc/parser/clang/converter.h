// From Clang's tree to ours (syntax.h): all declarations of a program, one after the other.
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/parser/clang/body_keeper.h"
#include "transpiler/dialects/hnc/parser/clang/call_converter.h"
#include "transpiler/dialects/hnc/parser/clang/constant_folder.h"
#include "transpiler/dialects/hnc/parser/clang/declared_type_checker.h"
#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"
#include "transpiler/dialects/hnc/parser/clang/function_converter.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"
#include "transpiler/dialects/hnc/parser/clang/operator_converter.h"
#include "transpiler/dialects/hnc/parser/clang/promotions.h"
#include "transpiler/dialects/hnc/parser/clang/statement_converter.h"
#include "transpiler/dialects/hnc/parser/clang/type_converter.h"
#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

namespace plcxx::hnc {

/// The parts of a conversion. Those of expressions, variables, functions and statements use each other, as the language
/// nests them.
class Converter : private NodeConverter {
 public:
  explicit Converter(Conversion& conversion)
      : NodeConverter(conversion),
        types_(conversion),
        folder_(conversion),
        builder_(conversion, types_, folder_),
        promotions_(conversion, types_, builder_),
        checker_(conversion, folder_, expressions_),
        variables_(conversion, types_, checker_, builder_, expressions_),
        functions_(conversion, types_, checker_, variables_, bodies_),
        expressions_(conversion, types_, builder_, promotions_, variables_, operators_, calls_),
        operators_(conversion, types_, builder_, promotions_, expressions_),
        calls_(conversion, types_, builder_, expressions_, functions_),
        statements_(conversion, folder_, checker_, variables_, expressions_),
        bodies_(conversion, types_, variables_, functions_, statements_) {}
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  void Run();

 private:
  void CollectComments();
  /// Of #pragma and of comments.
  std::vector<LoopBound> CollectLoopBounds();
  /// What is asked by name: functions with a body, declarations of the product.
  void CollectNames();
  void Declare(const clang::Decl* declaration);
  void CheckEntries();

  TypeConverter types_;
  ConstantFolder folder_;
  ExpressionBuilder builder_;
  Promotions promotions_;
  DeclaredTypeChecker checker_;
  VariableConverter variables_;
  FunctionConverter functions_;
  ExpressionConverter expressions_;
  OperatorConverter operators_;
  CallConverter calls_;
  StatementConverter statements_;
  BodyKeeper bodies_;
};

}  // namespace plcxx::hnc
