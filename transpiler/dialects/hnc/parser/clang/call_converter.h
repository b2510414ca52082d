// Calls (specification 6.4, 6.11, 7.3); once all definitions are known: what exists, what is refused by name, and
// whether arguments fit where no prototype stood in front of the call.
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class ExpressionConverter;
class FunctionConverter;

class CallConverter : private NodeConverter {
 public:
  CallConverter(Conversion& conversion, TypeConverter& types, ExpressionBuilder& builder,
                ExpressionConverter& expressions, FunctionConverter& functions)
      : NodeConverter(conversion), types_(types), builder_(builder), expressions_(expressions), functions_(functions) {}

  ExprId CallOf(const clang::CallExpr* expr);
  /// All calls, after the whole program.
  void CheckCalls();

 private:
  struct Call {
    ExprId expr;
    const clang::FunctionDecl* function;
    bool had_prototype;
    source::Range range;
    uint32_t body = 0;  // among ParserOutput::bodies
  };

  ExprId Handler(const clang::Expr* argument);
  bool CopiesTooLate(const clang::CallExpr* expr) const;
  bool ReportRefused(const Call& call);
  void ReportUndefined(const Call& call);
  std::string NearFunction(const std::string& name) const;
  void CheckArguments(const Call& call, const clang::FunctionDecl* definition);
  void CheckArgument(const Call& call, unsigned number, clang::QualType parameter, ExprId& argument);

  TypeConverter& types_;
  ExpressionBuilder& builder_;
  ExpressionConverter& expressions_;
  FunctionConverter& functions_;
  /// What is found of a call, or changed in it, once all definitions are known, is no part of its body.
  void RefuseBodyOf(const Call& call);

  std::vector<Call> list_;  // in the order of the source
};

}  // namespace plcxx::hnc
