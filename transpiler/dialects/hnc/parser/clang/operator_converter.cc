#include "transpiler/dialects/hnc/parser/clang/operator_converter.h"

#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"

namespace plcxx::hnc {
namespace {

BinaryOp OperatorOf(clang::BinaryOperatorKind kind) {
  switch (kind) {
    case clang::BO_Mul:
    case clang::BO_MulAssign:
      return BinaryOp::kMultiply;
    case clang::BO_Div:
    case clang::BO_DivAssign:
      return BinaryOp::kDivide;
    case clang::BO_Rem:
    case clang::BO_RemAssign:
      return BinaryOp::kRemainder;
    case clang::BO_Sub:
    case clang::BO_SubAssign:
      return BinaryOp::kSubtract;
    case clang::BO_Shl:
    case clang::BO_ShlAssign:
      return BinaryOp::kShiftLeft;
    case clang::BO_Shr:
    case clang::BO_ShrAssign:
      return BinaryOp::kShiftRight;
    case clang::BO_And:
    case clang::BO_AndAssign:
      return BinaryOp::kBitAnd;
    case clang::BO_Xor:
    case clang::BO_XorAssign:
      return BinaryOp::kBitXor;
    case clang::BO_Or:
    case clang::BO_OrAssign:
      return BinaryOp::kBitOr;
    case clang::BO_LT:
      return BinaryOp::kLess;
    case clang::BO_GT:
      return BinaryOp::kGreater;
    case clang::BO_LE:
      return BinaryOp::kLessEqual;
    case clang::BO_GE:
      return BinaryOp::kGreaterEqual;
    case clang::BO_EQ:
      return BinaryOp::kEqual;
    case clang::BO_NE:
      return BinaryOp::kNotEqual;
    default:
      return BinaryOp::kAdd;
  }
}

/// F_T[k], G_T[k]: a constant address.
bool IsTableElement(const clang::Expr* expr) {
  const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr->IgnoreParenCasts());
  if (element == nullptr) {
    const auto* star = llvm::dyn_cast<clang::UnaryOperator>(expr->IgnoreParens());
    if (star == nullptr || star->getOpcode() != clang::UO_Deref || !star->getType()->isPointerType()) return false;
  }
  const clang::Expr* base = element != nullptr ? element->getBase()->IgnoreParenCasts()
                                               : llvm::cast<clang::UnaryOperator>(expr->IgnoreParens())->getSubExpr();
  base = base->IgnoreParenCasts();
  while (const auto* sum = llvm::dyn_cast<clang::BinaryOperator>(base)) base = sum->getLHS()->IgnoreParenCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(base);
  if (name == nullptr || !name->getType()->isArrayType()) return false;
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
  if (variable == nullptr || !(variable->isFileVarDecl() || variable->isLocalExternDecl())) return false;
  const auto system = FindSystemName(variable->getNameAsString());
  return system && RowOf(system->area).table;
}

/// `f += l` is computed in double like `f + l` (6.1): of an operand on the left Clang keeps float, and would round l to
/// one. Its tree is mended here, before code is made of it.
void ComputeInDouble(const clang::CompoundAssignOperator* expr, const clang::ASTContext& context) {
  const auto* number = llvm::dyn_cast<clang::ImplicitCastExpr>(expr->getRHS());
  if (number == nullptr || number->getCastKind() != clang::CK_IntegralToFloating) return;
  if (!expr->getComputationLHSType()->isSpecificBuiltinType(clang::BuiltinType::Float)) return;
  auto* computed = const_cast<clang::CompoundAssignOperator*>(expr);
  const_cast<clang::ImplicitCastExpr*>(number)->setType(context.DoubleTy);
  computed->setComputationLHSType(context.DoubleTy);
  computed->setComputationResultType(context.DoubleTy);
}

}  // namespace

bool OperatorConverter::ReportTableStore(const clang::Expr* target) {
  if (!IsTableElement(target)) return false;
  const source::Range range = RangeOf(target);
  findings().Report(range, diag::HncPointerTable, "'" + Written(range) + "'");
  return true;
}

/// A pointer compared with a number: with 0 only as equal or not.
bool OperatorConverter::ReportComparedAddress(const clang::BinaryOperator* expr) {
  if (!expr->isComparisonOp()) return false;
  const auto becomes_pointer = [&](const clang::Expr* operand) {
    const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(operand);
    if (cast == nullptr) return false;
    return cast->getCastKind() == clang::CK_IntegralToPointer ||
           (cast->getCastKind() == clang::CK_NullToPointer && expr->isRelationalOp());
  };
  const clang::Expr* pointer = becomes_pointer(expr->getLHS())   ? expr->getRHS()
                               : becomes_pointer(expr->getRHS()) ? expr->getLHS()
                                                                 : nullptr;
  if (pointer == nullptr) return false;
  const source::Range range = RangeOf(pointer);
  findings().Report(range, diag::HncPointerAsValue, "'" + Written(range) + "' is an address");
  return true;
}

ExprId OperatorConverter::Binary(const clang::BinaryOperator* expr) {
  if (expr->isAssignmentOp()) return Assignment(expr);
  if (ReportComparedAddress(expr)) return builder_.Poison(expr);
  Expr result = builder_.Start(ExprKind::kBinary, expr);
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  const bool promotes = !expr->isLogicalOp() && !expr->isCommaOp();
  result.a = promotes ? expressions_.Operand(expr->getLHS()) : expressions_.Convert(expr->getLHS());
  result.b = expr->isLogicalOp() ? expressions_.Convert(expr->getRHS()) : expressions_.Operand(expr->getRHS());
  if (IsPoison(result.a) || IsPoison(result.b)) return builder_.Poison(expr);
  switch (expr->getOpcode()) {
    case clang::BO_LAnd:
      result.kind = ExprKind::kAnd;
      return builder_.Add(std::move(result));
    case clang::BO_LOr:
      result.kind = ExprKind::kOr;
      return builder_.Add(std::move(result));
    case clang::BO_Comma:
      result.kind = ExprKind::kComma;
      if (promotions_.IsPromoted(result.b, expr->getRHS())) result.type = unit_.expressions[result.b].type;
      return unit_.expressions.Add(std::move(result));
    case clang::BO_Add:
    case clang::BO_Sub:
      if (expr->getLHS()->getType()->isPointerType() || expr->getRHS()->getType()->isPointerType()) {
        return PointerArithmetic(expr, std::move(result));
      }
      break;
    default:
      break;
  }
  result.binary = OperatorOf(expr->getOpcode());
  if (expr->isShiftOp()) {
    if (promotions_.IsPromoted(result.a, expr->getLHS())) {
      result.type = unit_.expressions[result.a].type;
      promotions_.MarkOperator(result.binary, result.a, result.b);
    }
  } else {
    const TypeId common = promotions_.CommonType(result.a, expr->getLHS(), result.b, expr->getRHS());
    if (common.valid() && !expr->isComparisonOp()) result.type = common;
    if (common.valid()) promotions_.MarkOperator(result.binary, result.a, result.b);
  }
  return ReportZeroDivisor(result) ? builder_.Poison(expr) : builder_.Add(std::move(result));
}

bool OperatorConverter::ReportZeroDivisor(const Expr& result) {
  if (result.binary != BinaryOp::kDivide && result.binary != BinaryOp::kRemainder) return false;
  const Expr& divisor = unit_.expressions[result.b];
  if (!divisor.constant || !IsInteger(unit_.types[divisor.type]) || divisor.constant->integer != 0) return false;
  findings().Report(result.op, diag::HncDivisionByZero);
  return true;
}

ExprId OperatorConverter::PointerArithmetic(const clang::BinaryOperator* expr, Expr result) {
  const bool left = expr->getLHS()->getType()->isPointerType(), right = expr->getRHS()->getType()->isPointerType();
  result.binary = left && right                        ? BinaryOp::kPointerDifference
                  : expr->getOpcode() == clang::BO_Add ? BinaryOp::kPointerAdd
                                                       : BinaryOp::kPointerSubtract;
  if (!left) std::swap(result.a, result.b);
  return unit_.expressions.Add(std::move(result));
}

ExprId OperatorConverter::Assignment(const clang::BinaryOperator* expr) {
  if (ReportTableStore(expr->getLHS())) return builder_.Poison(expr);
  Expr result = builder_.Start(ExprKind::kAssign, expr);
  result.is_lvalue = false;
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.b = expressions_.Convert(expr->getRHS());
  result.a = expressions_.Convert(expr->getLHS());
  const bool poison = IsPoison(result.a) || IsPoison(result.b);
  return poison ? builder_.Poison(expr) : unit_.expressions.Add(std::move(result));
}

ExprId OperatorConverter::CompoundAssignment(const clang::CompoundAssignOperator* expr) {
  if (ReportTableStore(expr->getLHS())) return builder_.Poison(expr);
  if (expr->getRHS()
          ->getType()
          ->isPointerType()) {  // which Clang adds to an integer as it adds an integer to a pointer
    const source::Range range = RangeOf(expr->getRHS());
    findings().Report(range, diag::HncPointerAsValue, "'" + Written(range) + "' is an address");
    return builder_.Poison(expr);
  }
  ComputeInDouble(expr, context_);
  Expr result = builder_.Start(ExprKind::kCompoundAssign, expr);
  result.is_lvalue = false;
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.b = expressions_.Operand(expr->getRHS());
  result.a = expressions_.Convert(expr->getLHS());
  result.computation = types_.TypeOf(expr->getComputationLHSType());
  result.binary = OperatorOf(expr->getOpcode());
  if (promotions_.IsPromoted(result.b, expr->getRHS()) && !expr->isShiftAssignOp()) {
    promotions_.CommonTypeOfAssignment(expr, result);
  }
  if (expr->getLHS()->getType()->isPointerType()) {
    result.binary = expr->getOpcode() == clang::BO_AddAssign ? BinaryOp::kPointerAdd : BinaryOp::kPointerSubtract;
  }
  if (ReportZeroDivisor(result)) return builder_.Poison(expr);
  const bool poison = IsPoison(result.a) || IsPoison(result.b);
  return poison ? builder_.Poison(expr) : unit_.expressions.Add(std::move(result));
}

}  // namespace plcxx::hnc
