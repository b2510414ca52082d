#include "transpiler/dialects/hnc/parser/clang/extents.h"

#include <llvm/ADT/SmallVector.h>

namespace plcxx::hnc {
namespace {

/// The operand with which the expression begins; none: it begins with a token of its own.
const clang::Expr* FirstOperand(const clang::Expr* expr) {
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(expr)) return cast->getSubExpr();
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(expr)) return binary->getLHS();
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr)) return choice->getCond();
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getLHS();
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return call->getCallee();
  const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(expr);
  return unary != nullptr && unary->isPostfix() ? unary->getSubExpr() : nullptr;
}

/// The part with which it ends; none: it ends with a token of its own.
const clang::Stmt* LastPart(const clang::Stmt* whole) {
  if (const auto* label = llvm::dyn_cast<clang::SwitchCase>(whole)) return label->getSubStmt();
  if (const auto* label = llvm::dyn_cast<clang::LabelStmt>(whole)) return label->getSubStmt();
  if (const auto* choice = llvm::dyn_cast<clang::IfStmt>(whole)) {
    return choice->getElse() != nullptr ? choice->getElse() : choice->getThen();
  }
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(whole)) return loop->getBody();
  if (const auto* loop = llvm::dyn_cast<clang::WhileStmt>(whole)) return loop->getBody();
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(whole)) return cast->getSubExpr();
  if (const auto* cast = llvm::dyn_cast<clang::CStyleCastExpr>(whole)) return cast->getSubExpr();
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(whole)) return binary->getRHS();
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(whole)) return choice->getFalseExpr();
  const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(whole);
  return unary != nullptr && unary->isPrefix() ? unary->getSubExpr() : nullptr;
}

/// So far down nothing is kept: nearly all expressions are no deeper, and going there costs less than a table of all.
constexpr size_t kShallow = 8;

/// `part_of` goes one down, `place_of` asks the last one.
template <class Map, class Node, class PartOf, class PlaceOf>
clang::SourceLocation Find(Map& known, const Node* node, PartOf part_of, PlaceOf place_of) {
  const Node* at = node;
  for (size_t i = 0; i < kShallow; ++i) {
    const Node* part = part_of(at);
    if (part == nullptr) return place_of(at);
    at = part;
  }
  llvm::SmallVector<const Node*> passed;
  clang::SourceLocation place;
  for (;;) {
    const auto found = known.find(at);
    if (found != known.end()) {
      place = found->second;
      break;
    }
    passed.push_back(at);
    const Node* part = part_of(at);
    if (part == nullptr) {
      place = place_of(at);
      break;
    }
    at = part;
  }
  for (const Node* each : passed) known[each] = place;
  return place;
}

}  // namespace

clang::SourceLocation Extents::BeginOf(const clang::Expr* expr) {
  return Find(begins_, expr, FirstOperand, [](const clang::Expr* first) { return first->getBeginLoc(); });
}

clang::SourceLocation Extents::EndOf(const clang::Stmt* statement) {
  return Find(ends_, statement, LastPart, [](const clang::Stmt* last) { return last->getEndLoc(); });
}

}  // namespace plcxx::hnc
