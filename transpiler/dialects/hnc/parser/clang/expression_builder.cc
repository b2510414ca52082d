#include "transpiler/dialects/hnc/parser/clang/expression_builder.h"

#include <clang/Lex/Lexer.h>

#include <utility>

namespace plcxx::hnc {

void ExpressionBuilder::Locate(const clang::Expr* expr, Expr& result) const {
  const clang::SourceLocation begin = now_.extents.BeginOf(expr), end = now_.extents.EndOf(expr);
  result.range = session_.places.Of(begin, end);
  if (!begin.isMacroID()) return;
  const MacroUseId use = session_.macro_uses.At(result.range.begin);
  if (!use.valid()) return;
  result.macro = use;
  clang::SourceLocation first, last;
  const clang::LangOptions& language = context_.getLangOpts();
  const clang::SourceManager& sources = context_.getSourceManager();
  result.whole_macro = end.isMacroID() && clang::Lexer::isAtStartOfMacroExpansion(begin, sources, language, &first) &&
                       clang::Lexer::isAtEndOfMacroExpansion(end, sources, language, &last);
}

Expr ExpressionBuilder::Unplaced(ExprKind kind, const clang::Expr* expr) {
  Expr result;
  result.kind = kind;
  result.type = types_.TypeOf(expr->getType());
  result.is_lvalue = expr->isLValue();
  return result;
}

Expr ExpressionBuilder::Start(ExprKind kind, const clang::Expr* expr) {
  Expr result = Unplaced(kind, expr);
  Locate(expr, result);
  return result;
}

ExprId ExpressionBuilder::Add(Expr expr) {
  if (!expr.is_lvalue) folder_.Fold(expr);
  return unit_.expressions.Add(std::move(expr));
}

ExprId ExpressionBuilder::Poison(const clang::Expr* expr) {
  return unit_.expressions.Add(Start(ExprKind::kPoison, expr));
}

ExprId ExpressionBuilder::Integer(const clang::Expr* expr, int64_t value) {
  Expr result = Start(ExprKind::kConstant, expr);
  result.constant = Constant{.integer = value, .real = 0};
  return unit_.expressions.Add(std::move(result));
}

ExprId ExpressionBuilder::String(const clang::StringLiteral* expr, TypeId type) {
  Expr result = Start(ExprKind::kString, expr);
  result.type = type;
  result.string = static_cast<uint32_t>(unit_.strings.size());
  std::string bytes = expr->getBytes().str();
  bytes += '\0';
  unit_.strings.push_back(std::move(bytes));
  return unit_.expressions.Add(std::move(result));
}

ExprId ExpressionBuilder::InType(ExprId operand, TypeId type) {
  const Expr& inner = unit_.expressions[operand];
  Expr result;
  result.kind = ExprKind::kConvert;
  result.is_implicit = true;
  result.type = type;
  result.a = operand;
  result.range = inner.range;
  result.macro = inner.macro;
  result.whole_macro = inner.whole_macro;
  result.parenthesized = inner.parenthesized;
  return Add(std::move(result));
}

}  // namespace plcxx::hnc
