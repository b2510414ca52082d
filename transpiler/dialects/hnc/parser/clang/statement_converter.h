// Statements with their places (specification 3.3, 6.6 to 6.8).
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/constant_folder.h"
#include "transpiler/dialects/hnc/parser/clang/declared_type_checker.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class ExpressionConverter;
class VariableConverter;

class StatementConverter : private NodeConverter {
 public:
  StatementConverter(Conversion& conversion, ConstantFolder& folder, DeclaredTypeChecker& checker,
                     VariableConverter& variables, ExpressionConverter& expressions)
      : NodeConverter(conversion),
        folder_(folder),
        checker_(checker),
        variables_(variables),
        expressions_(expressions) {}

  /// All annotations of loops, by place.
  void SetLoopBounds(std::vector<LoopBound> bounds) { loop_bounds_ = std::move(bounds); }
  StatementId ConvertBody(const clang::FunctionDecl* function);

 private:
  StatementId Convert(const clang::Stmt* statement);
  Statement Start(StatementKind kind, const clang::Stmt* statement);
  StatementId Add(Statement statement);
  StatementId Expression(const clang::Expr* expr);
  StatementId Declaration(const clang::DeclStmt* statement);
  StatementId Compound(const clang::CompoundStmt* statement);
  StatementId If(const clang::IfStmt* statement);
  StatementId Switch(const clang::SwitchStmt* statement);
  StatementId Case(const clang::CaseStmt* statement);
  StatementId Default(const clang::DefaultStmt* statement);
  StatementId For(const clang::ForStmt* statement);
  StatementId While(const clang::WhileStmt* statement);
  StatementId Do(const clang::DoStmt* statement);
  StatementId Goto(const clang::GotoStmt* statement);
  StatementId Label(const clang::LabelStmt* statement);
  StatementId Return(const clang::ReturnStmt* statement);
  LabelId LabelOf(const clang::LabelDecl* label);
  source::Range WithSemicolon(source::Range range) const;
  std::optional<LoopBound> BoundBefore(source::Offset place) const;

  ConstantFolder& folder_;
  DeclaredTypeChecker& checker_;
  VariableConverter& variables_;
  ExpressionConverter& expressions_;
  std::vector<LoopBound> loop_bounds_;
  std::unordered_map<const clang::LabelDecl*, LabelId> labels_;  // of the function; only asked
  std::vector<TypeId> selectors_;                                // of the switches around
};

}  // namespace plcxx::hnc
