// From Clang's tree to ours (syntax.h). One object for one program; the parts are in convert_*.cc.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>
#include <clang/AST/Stmt.h>

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/extents.h"
#include "transpiler/dialects/hnc/parser/clang/session.h"

namespace plcxx::hnc {

class Converter {
 public:
  explicit Converter(Session& session)
      : session_(session), context_(session.clang.getASTContext()), unit_(session.output.unit) {}

  void Run();

 private:
  // convert_types.cc
  TypeId TypeOf(clang::QualType type);
  TypeId Describe(clang::QualType type);
  TypeId Integer(unsigned bits, bool is_signed);
  TypeId Add(Type type);
  RecordId RecordOf(const clang::RecordDecl* record);
  void FillMembers(const clang::RecordDecl* record, RecordId id);
  std::string TextOf(clang::QualType type) const;

  // convert_declarations.cc
  void CollectComments();
  void Declare(const clang::Decl* declaration);
  VariableId VariableOf(const clang::VarDecl* variable);
  void DescribeFileVariable(const clang::VarDecl* variable, Variable& result);
  void CheckSystemVariable(const clang::VarDecl* variable);
  void Initialise(const clang::VarDecl* variable, VariableId id);
  void Flatten(const clang::Expr* init, clang::QualType type, uint32_t offset, std::vector<InitialValue>& values);
  FunctionId FunctionOf(const clang::FunctionDecl* function);
  void Define(const clang::FunctionDecl* function);
  void CheckFunction(const clang::FunctionDecl* function);
  void CheckEntry(const clang::FunctionDecl* function);
  const clang::FunctionDecl* Expected(const clang::FunctionDecl* function) const;

  // check_types.cc
  enum class Holder : uint8_t { kObject, kMember, kParameter, kResult };
  void CheckDeclaredType(clang::QualType type, Holder holder, const std::string& name, source::Range range,
                         const clang::VarDecl* variable = nullptr);
  void CheckMembers(const clang::RecordDecl* record);
  bool IsTableOfStrings(const clang::VarDecl* variable) const;

  // check_calls.cc
  struct Call {
    ExprId expr;
    const clang::FunctionDecl* function;
    bool had_prototype;
    source::Range range;
  };
  void CheckCalls();
  bool ReportRefused(const Call& call);
  void CheckArguments(const Call& call, const clang::FunctionDecl* definition);
  void ReportUndefined(const Call& call);
  std::string NearFunction(const std::string& name) const;
  void CheckEntries();

  // convert_expressions.cc
  /// In the type that Clang gives it.
  ExprId Convert(const clang::Expr* expr);
  /// The operand of an operator that promotes. After a postfix ++ or -- Clang forgets that the value is that of a
  /// bit-field: where it has `unsigned int` then, this gives `int` as 6.1 says (promote_bit_fields.cc).
  ExprId Operand(const clang::Expr* expr);
  ExprId AnyExpression(const clang::Expr* expr);
  bool IsPromoted(ExprId operand, const clang::Expr* expr) const;
  bool BecomesInt(const clang::Expr* expr) const;
  ExprId InType(ExprId operand, TypeId type);
  void CommonTypeOfAssignment(const clang::CompoundAssignOperator* expr, Expr& result);
  TypeId CommonType(ExprId& a, const clang::Expr* of_a, ExprId& b, const clang::Expr* of_b);
  Expr Unplaced(ExprKind kind, const clang::Expr* expr);
  Expr Start(ExprKind kind, const clang::Expr* expr);
  ExprId Add(Expr expr);
  ExprId Poison(const clang::Expr* expr);
  ExprId Parenthesised(const clang::ParenExpr* expr);
  ExprId Name(const clang::DeclRefExpr* expr);
  ExprId String(const clang::StringLiteral* expr, TypeId type);
  ExprId Integer(const clang::Expr* expr, int64_t value);
  ExprId Cast(const clang::CastExpr* expr);
  ExprId Unary(const clang::UnaryOperator* expr);
  ExprId Element(const clang::ArraySubscriptExpr* expr);
  ExprId MemberAccess(const clang::MemberExpr* expr);
  ExprId Conditional(const clang::ConditionalOperator* expr);
  void LocateMacro(const clang::Expr* expr, Expr& result) const;

  // convert_operators.cc
  ExprId Binary(const clang::BinaryOperator* expr);
  ExprId Assignment(const clang::BinaryOperator* expr);
  ExprId CompoundAssignment(const clang::CompoundAssignOperator* expr);
  ExprId PointerArithmetic(const clang::BinaryOperator* expr, Expr result);
  ExprId CallOf(const clang::CallExpr* expr);
  ExprId Handler(const clang::Expr* argument);
  bool IsTableElement(const clang::Expr* expr) const;
  bool ReportTableStore(const clang::Expr* target);
  bool ReportComparedAddress(const clang::BinaryOperator* expr);

  // fold.cc
  void Fold(Expr& expr);
  std::optional<Constant> FoldBinary(const Expr& expr);
  std::optional<Constant> FoldUnary(const Expr& expr) const;
  std::optional<Constant> Converted(const Constant& value, const Type& from, const Type& to) const;
  bool HasWildShift(ExprId expr) const;

  // convert_statements.cc
  StatementId Convert(const clang::Stmt* statement);
  Statement Start(StatementKind kind, const clang::Stmt* statement);
  StatementId Add(Statement statement);
  StatementId Expression(const clang::Expr* expr);
  StatementId Declaration(const clang::DeclStmt* statement);
  StatementId Switch(const clang::SwitchStmt* statement);
  StatementId Case(const clang::CaseStmt* statement);
  StatementId For(const clang::ForStmt* statement);
  LabelId LabelOf(const clang::LabelDecl* label);
  source::Range WithSemicolon(source::Range range) const;
  source::Range Head(clang::SourceLocation first, clang::SourceLocation last) const;
  std::optional<LoopBound> BoundBefore(source::Offset place) const;

  Findings& findings() { return session_.findings(); }
  source::Range RangeOf(const clang::Expr* expr) const {
    return session_.places.Of(extents_.BeginOf(expr), extents_.EndOf(expr));
  }
  source::Range NameOf(const clang::NamedDecl* declaration) const {
    return session_.places.OfToken(declaration->getLocation());
  }
  std::string Written(source::Range range) const { return session_.input.text(range); }
  bool InProduct(const clang::Decl* declaration) const { return session_.places.InProduct(declaration->getLocation()); }

  Session& session_;
  clang::ASTContext& context_;
  Unit& unit_;

  mutable Extents extents_;
  // Only asked, never walked through.
  std::unordered_map<std::string, TypeId> types_;
  std::unordered_map<const void*, TypeId> known_types_;  // by Clang's type
  std::unordered_map<const clang::RecordDecl*, RecordId> records_;
  std::unordered_map<const clang::VarDecl*, VariableId> variables_;
  std::unordered_map<const clang::FunctionDecl*, FunctionId> functions_;
  std::unordered_map<const clang::LabelDecl*, LabelId> labels_;
  std::unordered_map<std::string, const clang::NamedDecl*> expected_;  // by name: what the product declares
  std::unordered_set<const clang::RecordDecl*> checked_records_;
  std::unordered_set<std::string> undefined_;  // reported
  std::unordered_set<std::string> bodies_;     // functions that have one, also where it was refused

  std::vector<Call> calls_;  // in the order of the source
  std::vector<LoopBound> loop_bounds_;
  FunctionId function_;            // the one that is converted
  std::vector<TypeId> selectors_;  // of the switches around
};

}  // namespace plcxx::hnc
