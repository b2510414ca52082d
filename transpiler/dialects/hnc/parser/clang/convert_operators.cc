// Operators with two operands, assignments, calls (specification 6.2, 6.4, 7.3).
#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/converter.h"

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

}  // namespace

/// F_T[k], G_T[k]: a constant address.
bool Converter::IsTableElement(const clang::Expr* expr) const {
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

bool Converter::ReportTableStore(const clang::Expr* target) {
  if (!IsTableElement(target)) return false;
  const source::Range range = RangeOf(target);
  findings().Report(range, diag::HncPointerTable, "'" + Written(range) + "'");
  return true;
}

/// A pointer compared with a number other than 0.
bool Converter::ReportComparedAddress(const clang::BinaryOperator* expr) {
  if (!expr->isComparisonOp()) return false;
  const auto becomes_pointer = [](const clang::Expr* operand) {
    const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(operand);
    return cast != nullptr && cast->getCastKind() == clang::CK_IntegralToPointer;
  };
  const clang::Expr* pointer = becomes_pointer(expr->getLHS())   ? expr->getRHS()
                               : becomes_pointer(expr->getRHS()) ? expr->getLHS()
                                                                 : nullptr;
  if (pointer == nullptr) return false;
  const source::Range range = RangeOf(pointer);
  findings().Report(range, diag::HncPointerAsValue, "'" + Written(range) + "' is an address");
  return true;
}

ExprId Converter::Binary(const clang::BinaryOperator* expr) {
  if (expr->isAssignmentOp()) return Assignment(expr);
  if (ReportComparedAddress(expr)) return Poison(expr);
  Expr result = Start(ExprKind::kBinary, expr);
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  const bool promotes = !expr->isLogicalOp() && !expr->isCommaOp();
  result.a = promotes ? Operand(expr->getLHS()) : Convert(expr->getLHS());
  result.b = expr->isLogicalOp() ? Convert(expr->getRHS()) : Operand(expr->getRHS());
  const bool poison =
      unit_.expressions[result.a].kind == ExprKind::kPoison || unit_.expressions[result.b].kind == ExprKind::kPoison;
  if (poison) return Poison(expr);
  switch (expr->getOpcode()) {
    case clang::BO_LAnd:
      result.kind = ExprKind::kAnd;
      return Add(std::move(result));
    case clang::BO_LOr:
      result.kind = ExprKind::kOr;
      return Add(std::move(result));
    case clang::BO_Comma:
      result.kind = ExprKind::kComma;
      if (IsPromoted(result.b, expr->getRHS())) result.type = unit_.expressions[result.b].type;
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
    if (IsPromoted(result.a, expr->getLHS())) result.type = unit_.expressions[result.a].type;
  } else {
    const TypeId common = CommonType(result.a, expr->getLHS(), result.b, expr->getRHS());
    if (common.valid() && !expr->isComparisonOp()) result.type = common;
  }
  const bool divides = result.binary == BinaryOp::kDivide || result.binary == BinaryOp::kRemainder;
  const Expr& divisor = unit_.expressions[result.b];
  if (divides && divisor.constant && IsInteger(unit_.types[divisor.type]) && divisor.constant->integer == 0) {
    findings().Report(result.op, diag::HncDivisionByZero);
    return Poison(expr);
  }
  return Add(std::move(result));
}

ExprId Converter::PointerArithmetic(const clang::BinaryOperator* expr, Expr result) {
  const bool left = expr->getLHS()->getType()->isPointerType(), right = expr->getRHS()->getType()->isPointerType();
  result.binary = left && right                        ? BinaryOp::kPointerDifference
                  : expr->getOpcode() == clang::BO_Add ? BinaryOp::kPointerAdd
                                                       : BinaryOp::kPointerSubtract;
  if (!left) std::swap(result.a, result.b);
  return unit_.expressions.Add(std::move(result));
}

ExprId Converter::Assignment(const clang::BinaryOperator* expr) {
  if (ReportTableStore(expr->getLHS())) return Poison(expr);
  Expr result = Start(ExprKind::kAssign, expr);
  result.is_lvalue = false;
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.b = Convert(expr->getRHS());
  result.a = Convert(expr->getLHS());
  const bool poison =
      unit_.expressions[result.a].kind == ExprKind::kPoison || unit_.expressions[result.b].kind == ExprKind::kPoison;
  return poison ? Poison(expr) : unit_.expressions.Add(std::move(result));
}

ExprId Converter::CompoundAssignment(const clang::CompoundAssignOperator* expr) {
  if (ReportTableStore(expr->getLHS())) return Poison(expr);
  Expr result = Start(ExprKind::kCompoundAssign, expr);
  result.is_lvalue = false;
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.b = Operand(expr->getRHS());
  result.a = Convert(expr->getLHS());
  result.computation = TypeOf(expr->getComputationLHSType());
  if (IsPromoted(result.b, expr->getRHS()) && !expr->isShiftAssignOp()) {
    CommonTypeOfAssignment(expr, result);
  }
  result.binary = OperatorOf(expr->getOpcode());
  if (expr->getLHS()->getType()->isPointerType()) {
    result.binary = expr->getOpcode() == clang::BO_AddAssign ? BinaryOp::kPointerAdd : BinaryOp::kPointerSubtract;
  }
  const bool divides = result.binary == BinaryOp::kDivide || result.binary == BinaryOp::kRemainder;
  const Expr& right = unit_.expressions[result.b];
  if (divides && right.constant && IsInteger(unit_.types[right.type]) && right.constant->integer == 0) {
    findings().Report(result.op, diag::HncDivisionByZero);
    return Poison(expr);
  }
  const bool poison = unit_.expressions[result.a].kind == ExprKind::kPoison || right.kind == ExprKind::kPoison;
  return poison ? Poison(expr) : unit_.expressions.Add(std::move(result));
}

/// The third argument of set_mst_func: the name of a function, or 0.
ExprId Converter::Handler(const clang::Expr* argument) {
  const clang::Expr* inner = argument->IgnoreParenCasts();
  if (const auto* address = llvm::dyn_cast<clang::UnaryOperator>(inner)) {
    if (address->getOpcode() == clang::UO_AddrOf) inner = address->getSubExpr()->IgnoreParenCasts();
  }
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(inner);
  const auto* function = name == nullptr ? nullptr : llvm::dyn_cast<clang::FunctionDecl>(name->getDecl());
  Expr result = Start(ExprKind::kFunction, argument);
  if (function != nullptr) {
    result.function = FunctionOf(function);
    calls_.push_back({{}, function, true, RangeOf(argument)});
    return unit_.expressions.Add(std::move(result));
  }
  if (argument->isNullPointerConstant(context_, clang::Expr::NPC_NeverValueDependent) != clang::Expr::NPCK_NotNull) {
    result.kind = ExprKind::kNull;
    result.constant = Constant{};
    return unit_.expressions.Add(std::move(result));
  }
  findings().Report(RangeOf(argument), diag::HncSetMstFunc, "the third argument is neither a function nor 0");
  return Poison(argument);
}

ExprId Converter::CallOf(const clang::CallExpr* expr) {
  const auto* decay = llvm::dyn_cast<clang::ImplicitCastExpr>(expr->getCallee()->IgnoreParens());
  const auto* name =
      decay == nullptr ? nullptr : llvm::dyn_cast<clang::DeclRefExpr>(decay->getSubExpr()->IgnoreParens());
  const auto* function = name == nullptr ? nullptr : llvm::dyn_cast<clang::FunctionDecl>(name->getDecl());
  if (function == nullptr) {
    findings().Report(RangeOf(expr->getCallee()), diag::HncFunctionPointer,
                      "'" + Written(RangeOf(expr->getCallee())) + "' is called");
    return Poison(expr);
  }
  const bool registers = function->getName() == "set_mst_func" && function->getDefinition() == nullptr;
  Expr result = Start(ExprKind::kCall, expr);
  result.is_lvalue = false;
  result.function = FunctionOf(function);
  result.op = session_.places.OfToken(expr->getCallee()->getBeginLoc());
  bool poison = false;
  for (unsigned i = 0; i < expr->getNumArgs(); ++i) {
    constexpr unsigned kHandler = 2;
    const ExprId argument = registers && i == kHandler ? Handler(expr->getArg(i)) : Convert(expr->getArg(i));
    poison = poison || unit_.expressions[argument].kind == ExprKind::kPoison;
    result.arguments.push_back(argument);
  }
  const source::Range range = result.op;
  if (poison) result.kind = ExprKind::kPoison;
  const ExprId id = unit_.expressions.Add(std::move(result));
  // The type of the name is that at this place: a prototype after it does not convert arguments.
  calls_.push_back({poison ? ExprId() : id, function, decay->getSubExpr()->getType()->isFunctionProtoType(), range});
  return id;
}

}  // namespace plcxx::hnc
