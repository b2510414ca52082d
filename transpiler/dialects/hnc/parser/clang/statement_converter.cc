#include "transpiler/dialects/hnc/parser/clang/statement_converter.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"
#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

namespace plcxx::hnc {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n'; }

/// How many bytes of `text` are blanks, line ends and comments.
size_t GapLength(std::string_view text) {
  size_t at = 0;
  while (at < text.size()) {
    if (IsBlank(text[at]) || (text[at] == '\\' && at + 1 < text.size() && IsBlank(text[at + 1]))) {
      ++at;
    } else if (text.substr(at).starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.substr(at).starts_with("/*")) {
      const size_t end = text.find("*/", at + 2);
      at = end == std::string_view::npos ? text.size() : end + 2;
    } else {
      return at;
    }
  }
  return at;
}

}  // namespace

Statement StatementConverter::Start(StatementKind kind, const clang::Stmt* statement) {
  Statement result;
  result.kind = kind;
  result.range = session_.places.Of(statement->getBeginLoc(), now_.extents.EndOf(statement));
  result.keyword = session_.places.OfToken(statement->getBeginLoc());
  result.head = result.range;
  if (statement->getBeginLoc().isMacroID()) {
    result.macro = session_.macro_uses.At(result.range.begin);
    if (result.macro.valid()) result.keyword = unit_.macro_uses[result.macro].range;
  }
  return result;
}

StatementId StatementConverter::Add(Statement statement) {
  if (statement.kind != StatementKind::kCompound && statement.kind != StatementKind::kEmpty) ++unit_.statement_count;
  return unit_.statements.Add(std::move(statement));
}

/// With the ';' after it.
source::Range StatementConverter::WithSemicolon(source::Range range) const {
  if (range.begin == 0) return range;
  if (Written({range.end, range.end + 1}) == ";") return {range.begin, range.end + 1};
  constexpr source::Offset kFar = 2000;  // of comments between a statement and its ';'
  const std::string behind = Written({range.end, range.end + kFar});
  const size_t gap = GapLength(behind);
  if (gap < behind.size() && behind[gap] == ';') range.end += static_cast<source::Offset>(gap) + 1;
  return range;
}

/// The annotation directly in front of a loop; comments and blanks may stand between.
std::optional<LoopBound> StatementConverter::BoundBefore(source::Offset place) const {
  const auto behind =
      std::ranges::upper_bound(loop_bounds_, place, {}, [](const LoopBound& bound) { return bound.range.end; });
  if (place == 0 || behind == loop_bounds_.begin()) return std::nullopt;
  const LoopBound& bound = *std::prev(behind);
  constexpr source::Offset kFar = 4000;  // of comments between an annotation and its loop
  if (place - bound.range.end > kFar) return std::nullopt;
  const std::string gap = Written({bound.range.end, place});
  if (bound.range.end < place && gap.empty()) return std::nullopt;  // in another file
  return GapLength(gap) == gap.size() ? std::optional(bound) : std::nullopt;
}

LabelId StatementConverter::LabelOf(const clang::LabelDecl* label) {
  const auto known = labels_.find(label);
  if (known != labels_.end()) return known->second;
  const LabelId id =
      unit_.labels.Add({.name = label->getNameAsString(), .range = NameOf(label), .statement = {}, .used = false});
  labels_.emplace(label, id);
  if (now_.function.valid()) unit_.functions[now_.function].labels.push_back(id);
  return id;
}

StatementId StatementConverter::Expression(const clang::Expr* expr) {
  Statement result = Start(StatementKind::kExpression, expr);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr->IgnoreParens())) {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    const std::string name = callee == nullptr ? std::string() : callee->getNameAsString();
    const bool defined = callee != nullptr && (callee->isDefined() || callee->isImplicit());
    if (name == kCliName || (name == "disable" && !defined)) result.kind = StatementKind::kCriticalEnter;
    if (name == kStiName || (name == "enable" && !defined)) result.kind = StatementKind::kCriticalLeave;
  }
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  const auto* function = name == nullptr ? nullptr : llvm::dyn_cast<clang::FunctionDecl>(name->getDecl());
  if (function != nullptr) {
    findings().Report(RangeOf(name), diag::HncFunctionNotCalled, function->getNameAsString());
    result.kind = StatementKind::kEmpty;
  }
  if (result.kind == StatementKind::kExpression) result.expression = expressions_.Convert(expr);
  result.range = WithSemicolon(result.range);
  result.head = result.range;
  return Add(std::move(result));
}

StatementId StatementConverter::Declaration(const clang::DeclStmt* statement) {
  Statement result = Start(StatementKind::kDeclaration, statement);
  for (const clang::Decl* declaration : statement->decls()) {
    if (const auto* record = llvm::dyn_cast<clang::RecordDecl>(declaration)) checker_.CheckMembers(record);
    if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(declaration)) checker_.CheckEnumerators(enumeration);
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration);
    // What is no plain variable may be seen beyond the body, or has members of its own.
    if (variable == nullptr || variable->isInvalidDecl() || variable->isLocalExternDecl()) now_.recorder.Refuse();
    if (variable == nullptr || variable->isInvalidDecl()) continue;
    if (variable->isLocalExternDecl()) {
      variables_.CheckSystemVariable(variable);
      continue;
    }
    const VariableId id = variables_.VariableOf(variable);
    unit_.functions[now_.function].locals.push_back(id);
    result.variables.push_back(id);
  }
  result.range = WithSemicolon(result.range);
  result.head = result.range;
  if (result.variables.empty()) result.kind = StatementKind::kEmpty;
  return Add(std::move(result));
}

StatementId StatementConverter::Switch(const clang::SwitchStmt* statement) {
  Statement result = Start(StatementKind::kSwitch, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getRParenLoc());
  result.expression = expressions_.Convert(statement->getCond());
  const Type& type = unit_.TypeOf(result.expression);
  if (type.kind == TypeKind::kPointer) {
    findings().Report(unit_.expressions[result.expression].range, diag::HncPointerAsValue,
                      "the selector of a switch is an address");
  }
  constexpr int64_t kMostCases = 1024;  // 10.1
  int64_t cases = 0;
  for (const clang::SwitchCase* label = statement->getSwitchCaseList(); label != nullptr;
       label = label->getNextSwitchCase()) {
    ++cases;
  }
  if (cases > kMostCases) findings().Report(result.keyword, diag::HncTooManyCases, kMostCases);
  selectors_.push_back(unit_.expressions[result.expression].type);
  result.then = Convert(statement->getBody());
  selectors_.pop_back();
  return Add(std::move(result));
}

StatementId StatementConverter::Case(const clang::CaseStmt* statement) {
  Statement result = Start(StatementKind::kCase, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getColonLoc());
  result.case_expression = expressions_.Convert(statement->getLHS());
  if (folder_.HasWildShift(result.case_expression)) {
    findings().Report(unit_.expressions[result.case_expression].range, diag::HncConstantRequired,
                      "with a shift count inside the width");
  }
  const Expr& written = unit_.expressions[result.case_expression];
  if (written.constant && !selectors_.empty()) {
    const auto value = Converted(*written.constant, unit_.types[written.type], unit_.types[selectors_.back()]);
    result.value = value ? value->integer : 0;
  }
  result.then = Convert(statement->getSubStmt());
  return Add(std::move(result));
}

StatementId StatementConverter::For(const clang::ForStmt* statement) {
  Statement result = Start(StatementKind::kFor, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getRParenLoc());
  result.loop_bound = BoundBefore(result.keyword.begin);
  if (const auto* first = llvm::dyn_cast_or_null<clang::Expr>(statement->getInit()))
    result.first = expressions_.Convert(first);
  if (statement->getCond() != nullptr) result.expression = expressions_.Convert(statement->getCond());
  if (statement->getInc() != nullptr) result.step = expressions_.Convert(statement->getInc());
  result.then = Convert(statement->getBody());
  return Add(std::move(result));
}

StatementId StatementConverter::Compound(const clang::CompoundStmt* statement) {
  Statement result = Start(StatementKind::kCompound, statement);
  result.head = session_.places.OfToken(statement->getLBracLoc());
  result.close = session_.places.OfToken(statement->getRBracLoc());
  for (const clang::Stmt* inner : statement->body()) result.body.push_back(Convert(inner));
  return Add(std::move(result));
}

StatementId StatementConverter::If(const clang::IfStmt* statement) {
  Statement result = Start(StatementKind::kIf, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getRParenLoc());
  result.expression = expressions_.Convert(statement->getCond());
  result.then = Convert(statement->getThen());
  if (statement->getElse() != nullptr) {
    result.otherwise_keyword = session_.places.OfToken(statement->getElseLoc());
    result.otherwise = Convert(statement->getElse());
  }
  return Add(std::move(result));
}

StatementId StatementConverter::While(const clang::WhileStmt* statement) {
  Statement result = Start(StatementKind::kWhile, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getRParenLoc());
  result.loop_bound = BoundBefore(result.keyword.begin);
  result.expression = expressions_.Convert(statement->getCond());
  result.then = Convert(statement->getBody());
  return Add(std::move(result));
}

StatementId StatementConverter::Do(const clang::DoStmt* statement) {
  Statement result = Start(StatementKind::kDo, statement);
  result.head = result.keyword;
  result.loop_bound = BoundBefore(result.keyword.begin);
  result.then = Convert(statement->getBody());
  result.expression = expressions_.Convert(statement->getCond());
  result.close = session_.places.Of(statement->getWhileLoc(), statement->getRParenLoc());
  result.range = WithSemicolon(result.range);
  return Add(std::move(result));
}

StatementId StatementConverter::Goto(const clang::GotoStmt* statement) {
  Statement result = Start(StatementKind::kGoto, statement);
  result.label = LabelOf(statement->getLabel());
  unit_.labels[result.label].used = true;
  result.range = result.head = WithSemicolon(result.range);
  return Add(std::move(result));
}

StatementId StatementConverter::Label(const clang::LabelStmt* statement) {
  Statement result = Start(StatementKind::kLabel, statement);
  result.label = LabelOf(statement->getDecl());
  result.loop_bound = BoundBefore(result.keyword.begin);
  result.head = result.keyword;
  result.then = Convert(statement->getSubStmt());
  const LabelId id = result.label;
  const StatementId added = Add(std::move(result));
  unit_.labels[id].statement = added;
  return added;
}

StatementId StatementConverter::Default(const clang::DefaultStmt* statement) {
  Statement result = Start(StatementKind::kDefault, statement);
  result.head = session_.places.Of(statement->getBeginLoc(), statement->getColonLoc());
  result.then = Convert(statement->getSubStmt());
  return Add(std::move(result));
}

StatementId StatementConverter::Return(const clang::ReturnStmt* statement) {
  Statement result = Start(StatementKind::kReturn, statement);
  if (statement->getRetValue() != nullptr) result.expression = expressions_.Convert(statement->getRetValue());
  result.range = result.head = WithSemicolon(result.range);
  return Add(std::move(result));
}

StatementId StatementConverter::ConvertBody(const clang::FunctionDecl* function) {
  labels_.clear();
  selectors_.clear();
  return Convert(function->getBody());
}

StatementId StatementConverter::Convert(const clang::Stmt* statement) {
  if (statement == nullptr) return Add(Statement{});
  if (const auto* expr = llvm::dyn_cast<clang::Expr>(statement)) return Expression(expr);
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(statement)) return Declaration(declaration);
  if (const auto* selection = llvm::dyn_cast<clang::SwitchStmt>(statement)) return Switch(selection);
  if (const auto* label = llvm::dyn_cast<clang::CaseStmt>(statement)) return Case(label);
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(statement)) return For(loop);
  if (const auto* block = llvm::dyn_cast<clang::CompoundStmt>(statement)) return Compound(block);
  if (const auto* choice = llvm::dyn_cast<clang::IfStmt>(statement)) return If(choice);
  if (const auto* loop = llvm::dyn_cast<clang::WhileStmt>(statement)) return While(loop);
  if (const auto* loop = llvm::dyn_cast<clang::DoStmt>(statement)) return Do(loop);
  if (const auto* jump = llvm::dyn_cast<clang::GotoStmt>(statement)) return Goto(jump);
  if (const auto* label = llvm::dyn_cast<clang::LabelStmt>(statement)) return Label(label);
  if (const auto* label = llvm::dyn_cast<clang::DefaultStmt>(statement)) return Default(label);
  if (const auto* jump = llvm::dyn_cast<clang::ReturnStmt>(statement)) return Return(jump);
  StatementKind kind = StatementKind::kEmpty;
  if (llvm::isa<clang::ContinueStmt>(statement)) kind = StatementKind::kContinue;
  if (llvm::isa<clang::BreakStmt>(statement)) kind = StatementKind::kBreak;
  Statement result = Start(kind, statement);
  if (kind != StatementKind::kEmpty) result.range = result.head = WithSemicolon(result.range);
  return Add(std::move(result));
}

}  // namespace plcxx::hnc
