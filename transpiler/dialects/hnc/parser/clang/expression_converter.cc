#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"

#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/call_converter.h"
#include "transpiler/dialects/hnc/parser/clang/operator_converter.h"
#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

namespace plcxx::hnc {
namespace {

/// `-f` has the type of f (6.2); Clang widens the operand there, too.
bool IsSignOfFloat(const clang::Expr* expr) {
  const auto* sign = llvm::dyn_cast<clang::UnaryOperator>(expr->IgnoreParens());
  if (sign == nullptr || (sign->getOpcode() != clang::UO_Minus && sign->getOpcode() != clang::UO_Plus)) return false;
  const auto* wide = llvm::dyn_cast<clang::ImplicitCastExpr>(sign->getSubExpr());
  if (wide == nullptr) return IsSignOfFloat(sign->getSubExpr());
  return wide->getCastKind() == clang::CK_FloatingCast &&
         wide->getSubExpr()->getType()->isSpecificBuiltinType(clang::BuiltinType::Float);
}

}  // namespace

ExprId ExpressionConverter::Operand(const clang::Expr* expr) { return promotions_.Promoted(AnyExpression(expr), expr); }

ExprId ExpressionConverter::Convert(const clang::Expr* expr) { return promotions_.Unpromoted(Operand(expr), expr); }

ExprId ExpressionConverter::AnyExpression(const clang::Expr* expr) {
  if (const auto* whole = llvm::dyn_cast<clang::ParenExpr>(expr)) return Parenthesised(whole);
  if (const auto* constant = llvm::dyn_cast<clang::ConstantExpr>(expr)) return Operand(constant->getSubExpr());
  if (const auto* integer = llvm::dyn_cast<clang::IntegerLiteral>(expr)) {
    const bool is_signed = expr->getType()->isSignedIntegerType();
    const llvm::APInt& value = integer->getValue();
    return builder_.Integer(expr, is_signed ? value.getSExtValue() : static_cast<int64_t>(value.getZExtValue()));
  }
  if (const auto* character = llvm::dyn_cast<clang::CharacterLiteral>(expr)) {
    return builder_.Integer(expr, static_cast<int16_t>(character->getValue()));
  }
  if (const auto* real = llvm::dyn_cast<clang::FloatingLiteral>(expr)) {
    Expr result = builder_.Start(ExprKind::kConstant, expr);
    result.constant = Constant{.integer = 0, .real = real->getValueAsApproximateDouble()};
    return unit_.expressions.Add(std::move(result));
  }
  if (const auto* string = llvm::dyn_cast<clang::StringLiteral>(expr))
    return builder_.String(string, types_.TypeOf(expr->getType()));
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return Name(name);
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr)) return Cast(cast);
  if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(expr)) return Unary(unary);
  if (const auto* compound = llvm::dyn_cast<clang::CompoundAssignOperator>(expr))
    return operators_.CompoundAssignment(compound);
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(expr)) return operators_.Binary(binary);
  if (const auto* conditional = llvm::dyn_cast<clang::ConditionalOperator>(expr)) return Conditional(conditional);
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return Element(element);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return MemberAccess(member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return calls_.CallOf(call);
  if (const auto* size = llvm::dyn_cast<clang::UnaryExprOrTypeTraitExpr>(expr)) {
    if (size->getKind() == clang::UETT_SizeOf && !size->isArgumentType() && IsSignOfFloat(size->getArgumentExpr())) {
      NoteThatClangDiffers("-f, where f is a float, has the type double to Clang, and so another size");
      return builder_.Integer(expr, context_.getTypeSizeInChars(context_.FloatTy).getQuantity());
    }
    clang::Expr::EvalResult value;
    if (size->EvaluateAsInt(value, context_)) return builder_.Integer(expr, value.Val.getInt().getExtValue());
    return builder_.Poison(expr);
  }
  return builder_.Poison(expr);  // an extension, already refused
}

ExprId ExpressionConverter::Parenthesised(const clang::ParenExpr* expr) {
  const ExprId id = Operand(expr->getSubExpr());
  Expr& inner = unit_.expressions[id];
  inner.parenthesized = true;
  builder_.Locate(expr, inner);
  return id;
}

ExprId ExpressionConverter::Name(const clang::DeclRefExpr* expr) {
  const clang::ValueDecl* declaration = expr->getDecl();
  if (const auto* enumerator = llvm::dyn_cast<clang::EnumConstantDecl>(declaration)) {
    return builder_.Integer(expr, enumerator->getInitVal().getExtValue());
  }
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration);
  if (variable == nullptr) {  // a function where no function can stand
    if (llvm::isa<clang::FunctionDecl>(declaration)) {
      findings().Report(RangeOf(expr), diag::HncFunctionPointer, "'" + declaration->getNameAsString() + "' as a value");
    }
    return builder_.Poison(expr);
  }
  if (std::string_view(variable->getName()) == kPoisonName) return builder_.Poison(expr);
  const VariableId id = variables_.VariableOf(variable);
  if (unit_.variables[id].storage == Storage::kUndefined) {
    const std::string name = variable->getNameAsString();
    if (now_.undefined.insert(name).second) findings().Report(RangeOf(expr), diag::HncUndefinedVariable, name);
    return builder_.Poison(expr);
  }
  Expr result = builder_.Start(ExprKind::kVariable, expr);
  result.type = unit_.variables[id].type;
  result.variable = id;
  return unit_.expressions.Add(std::move(result));
}

ExprId ExpressionConverter::Cast(const clang::CastExpr* expr) {
  const clang::Expr* operand = expr->getSubExpr();
  const bool implicit = llvm::isa<clang::ImplicitCastExpr>(expr);
  const auto wrap = [&](ExprKind kind) {
    const ExprId inner = kind == ExprKind::kConvert ? Operand(operand) : Convert(operand);
    if (IsPoison(inner)) return inner;
    Expr result = implicit ? builder_.Unplaced(kind, expr) : builder_.Start(kind, expr);
    result.is_implicit = implicit;
    result.a = inner;
    if (kind == ExprKind::kConvert && promotions_.IsPromoted(inner, operand))
      promotions_.MarkConversion(inner, result.type);
    if (implicit) {  // the same text
      result.range = unit_.expressions[inner].range;
      result.macro = unit_.expressions[inner].macro;
      result.whole_macro = unit_.expressions[inner].whole_macro;
      result.parenthesized = unit_.expressions[inner].parenthesized;
    }
    if (kind == ExprKind::kConvert && result.type == unit_.expressions[inner].type && implicit) return inner;
    return builder_.Add(std::move(result));
  };
  switch (expr->getCastKind()) {
    case clang::CK_LValueToRValue:
      return wrap(ExprKind::kLoad);
    case clang::CK_ArrayToPointerDecay:
      return wrap(ExprKind::kDecay);
    case clang::CK_NoOp:
      if (implicit) return Convert(operand);
      return wrap(operand->getType()->isPointerType() ? ExprKind::kCast : ExprKind::kConvert);
    case clang::CK_IntegralCast:
    case clang::CK_IntegralToFloating:
    case clang::CK_FloatingToIntegral:
    case clang::CK_FloatingCast:
    case clang::CK_ToVoid:
      return wrap(ExprKind::kConvert);
    case clang::CK_BitCast:
      return wrap(ExprKind::kCast);
    case clang::CK_NullToPointer: {
      Expr result = builder_.Start(ExprKind::kNull, expr);
      result.constant = Constant{};
      return unit_.expressions.Add(std::move(result));
    }
    case clang::CK_IntegralToPointer: {
      const auto* call = llvm::dyn_cast<clang::CallExpr>(operand->IgnoreParenImpCasts());
      const clang::FunctionDecl* callee = call == nullptr ? nullptr : call->getDirectCallee();
      Convert(operand);
      if (callee != nullptr && callee->getDefinition() == nullptr && callee->isImplicit()) return builder_.Poison(expr);
      findings().Report(RangeOf(expr), diag::HncAbsoluteAddress,
                        "'" + Written(RangeOf(operand)) + "' is a number and becomes a pointer");
      return builder_.Poison(expr);
    }
    case clang::CK_PointerToIntegral:
      if (operand->IgnoreParenImpCasts()->getType()->isArrayType()) {
        const std::string text = Written(RangeOf(operand));
        if (text.starts_with('"')) {
          const std::string meant = text.size() == 3 ? "'" + text.substr(1, 1) + "'" : "one character, such as '1'";
          findings().Report(RangeOf(operand), diag::HncTextAsValue, text, meant);
        } else {
          findings().Report(RangeOf(operand), diag::HncAreaAsValue, text);
        }
        return builder_.Poison(expr);
      }
      findings().Report(RangeOf(operand), diag::HncPointerAsValue, "'" + Written(RangeOf(operand)) + "' is an address");
      return builder_.Poison(expr);
    case clang::CK_FunctionToPointerDecay:
      findings().Report(RangeOf(operand), diag::HncFunctionPointer, "'" + Written(RangeOf(operand)) + "' as a value");
      return builder_.Poison(expr);
    default:
      return builder_.Poison(expr);  // an extension, already refused
  }
}

ExprId ExpressionConverter::Unary(const clang::UnaryOperator* expr) {
  const clang::Expr* operand = expr->getSubExpr();
  const clang::UnaryOperatorKind kind = expr->getOpcode();
  if (kind == clang::UO_AddrOf && operand->getType()->isFunctionType()) {
    findings().Report(RangeOf(expr), diag::HncFunctionPointer, "'" + Written(RangeOf(expr)) + "' as a value");
    return builder_.Poison(expr);
  }
  if (expr->isIncrementDecrementOp() && operators_.ReportTableStore(operand)) return builder_.Poison(expr);
  Expr result = builder_.Start(ExprKind::kUnary, expr);
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  const bool promotes = kind == clang::UO_Plus || kind == clang::UO_Minus || kind == clang::UO_Not;
  result.a = promotes ? Operand(operand) : Convert(operand);
  if (IsPoison(result.a)) return builder_.Poison(expr);
  if (promotes && promotions_.IsPromoted(result.a, operand)) result.type = unit_.expressions[result.a].type;
  switch (kind) {
    case clang::UO_Plus:
      result.unary = UnaryOp::kPlus;
      break;
    case clang::UO_Minus:
      result.unary = UnaryOp::kMinus;
      break;
    case clang::UO_Not:
      result.unary = UnaryOp::kComplement;
      break;
    case clang::UO_LNot:
      result.unary = UnaryOp::kNot;
      break;
    case clang::UO_PreInc:
    case clang::UO_PreDec:
    case clang::UO_PostInc:
    case clang::UO_PostDec:
      result.kind = ExprKind::kIncrement;
      result.is_lvalue = false;
      result.increment = kind == clang::UO_PreInc    ? IncrementOp::kPreIncrement
                         : kind == clang::UO_PreDec  ? IncrementOp::kPreDecrement
                         : kind == clang::UO_PostInc ? IncrementOp::kPostIncrement
                                                     : IncrementOp::kPostDecrement;
      break;
    case clang::UO_AddrOf:
      result.kind = ExprKind::kAddress;
      break;
    case clang::UO_Deref:
      result.kind = ExprKind::kDereference;
      break;
    default:
      return Convert(operand);  // an extension, already refused
  }
  return builder_.Add(std::move(result));
}

ExprId ExpressionConverter::Element(const clang::ArraySubscriptExpr* expr) {
  Expr result = builder_.Start(ExprKind::kIndex, expr);
  const clang::Expr* base = expr->getBase();
  // The array itself, not the address of its first element, so that its bounds are known.
  const auto* decay = llvm::dyn_cast<clang::ImplicitCastExpr>(base->IgnoreParens());
  if (decay != nullptr && decay->getCastKind() == clang::CK_ArrayToPointerDecay) base = decay->getSubExpr();
  result.a = Convert(base);
  result.b = Convert(expr->getIdx());
  if (IsPoison(result.a) || IsPoison(result.b)) return builder_.Poison(expr);
  return unit_.expressions.Add(std::move(result));
}

ExprId ExpressionConverter::MemberAccess(const clang::MemberExpr* expr) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(expr->getMemberDecl());
  if (field == nullptr) return builder_.Poison(expr);
  Expr result = builder_.Start(ExprKind::kMember, expr);
  result.member = field->getFieldIndex();
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.a = Convert(expr->getBase());
  if (IsPoison(result.a)) return builder_.Poison(expr);
  if (expr->isArrow()) {
    Expr object;
    object.kind = ExprKind::kDereference;
    object.is_implicit = true;
    object.is_lvalue = true;
    object.type = types_.TypeOf(expr->getBase()->getType()->getPointeeType());
    object.range = unit_.expressions[result.a].range;
    object.a = result.a;
    result.a = unit_.expressions.Add(std::move(object));
  }
  // A record with an error in it has no members, and what asks for one has no address.
  const Type& record = unit_.types[unit_.expressions[result.a].type];
  const bool known = record.kind == TypeKind::kRecord && result.member < unit_.records[record.record].members.size();
  return known ? unit_.expressions.Add(std::move(result)) : builder_.Poison(expr);
}

ExprId ExpressionConverter::Conditional(const clang::ConditionalOperator* expr) {
  Expr result = builder_.Start(ExprKind::kConditional, expr);
  result.op = session_.places.OfToken(expr->getQuestionLoc());
  result.a = Convert(expr->getCond());
  result.b = Operand(expr->getTrueExpr());
  result.c = Operand(expr->getFalseExpr());
  const TypeId common = promotions_.CommonType(result.b, expr->getTrueExpr(), result.c, expr->getFalseExpr());
  if (common.valid()) result.type = common;
  return builder_.Add(std::move(result));
}

}  // namespace plcxx::hnc
