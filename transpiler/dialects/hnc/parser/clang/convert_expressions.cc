// Expressions: operands, conversions, accesses (specification 6.1, 6.5). Operators with two operands and calls are in
// convert_operators.cc.
#include <clang/Lex/Lexer.h>

#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/converter.h"

namespace plcxx::hnc {

/// Which macro wrote the expression, and whether it wrote nothing else.
void Converter::LocateMacro(const clang::Expr* expr, Expr& result) const {
  const clang::SourceLocation begin = extents_.BeginOf(expr), end = extents_.EndOf(expr);
  if (!begin.isMacroID()) return;
  const auto use = session_.macro_uses.find(result.range.begin);
  if (use == session_.macro_uses.end()) return;
  result.macro = use->second;
  clang::SourceLocation first, last;
  const clang::LangOptions& language = context_.getLangOpts();
  const clang::SourceManager& sources = context_.getSourceManager();
  result.whole_macro = end.isMacroID() && clang::Lexer::isAtStartOfMacroExpansion(begin, sources, language, &first) &&
                       clang::Lexer::isAtEndOfMacroExpansion(end, sources, language, &last);
}

/// Without a place.
Expr Converter::Unplaced(ExprKind kind, const clang::Expr* expr) {
  Expr result;
  result.kind = kind;
  result.type = TypeOf(expr->getType());
  result.is_lvalue = expr->isLValue();
  return result;
}

Expr Converter::Start(ExprKind kind, const clang::Expr* expr) {
  Expr result = Unplaced(kind, expr);
  result.range = RangeOf(expr);
  LocateMacro(expr, result);
  return result;
}

ExprId Converter::Add(Expr expr) {
  if (!expr.is_lvalue) Fold(expr);
  return unit_.expressions.Add(std::move(expr));
}

ExprId Converter::Poison(const clang::Expr* expr) { return unit_.expressions.Add(Start(ExprKind::kPoison, expr)); }

ExprId Converter::Integer(const clang::Expr* expr, int64_t value) {
  Expr result = Start(ExprKind::kConstant, expr);
  result.constant = Constant{.integer = value, .real = 0};
  return unit_.expressions.Add(std::move(result));
}

ExprId Converter::String(const clang::StringLiteral* expr, TypeId type) {
  Expr result = Start(ExprKind::kString, expr);
  result.type = type;
  result.string = static_cast<uint32_t>(unit_.strings.size());
  std::string bytes = expr->getBytes().str();
  bytes += '\0';
  unit_.strings.push_back(std::move(bytes));
  return unit_.expressions.Add(std::move(result));
}

ExprId Converter::AnyExpression(const clang::Expr* expr) {
  if (const auto* whole = llvm::dyn_cast<clang::ParenExpr>(expr)) return Parenthesised(whole);
  if (const auto* constant = llvm::dyn_cast<clang::ConstantExpr>(expr)) return Operand(constant->getSubExpr());
  if (const auto* integer = llvm::dyn_cast<clang::IntegerLiteral>(expr)) {
    const bool is_signed = expr->getType()->isSignedIntegerType();
    const llvm::APInt& value = integer->getValue();
    return Integer(expr, is_signed ? value.getSExtValue() : static_cast<int64_t>(value.getZExtValue()));
  }
  if (const auto* character = llvm::dyn_cast<clang::CharacterLiteral>(expr)) {
    return Integer(expr, static_cast<int16_t>(character->getValue()));
  }
  if (const auto* real = llvm::dyn_cast<clang::FloatingLiteral>(expr)) {
    Expr result = Start(ExprKind::kConstant, expr);
    result.constant = Constant{.integer = 0, .real = real->getValueAsApproximateDouble()};
    return unit_.expressions.Add(std::move(result));
  }
  if (const auto* string = llvm::dyn_cast<clang::StringLiteral>(expr)) return String(string, TypeOf(expr->getType()));
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return Name(name);
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr)) return Cast(cast);
  if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(expr)) return Unary(unary);
  if (const auto* compound = llvm::dyn_cast<clang::CompoundAssignOperator>(expr)) return CompoundAssignment(compound);
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(expr)) return Binary(binary);
  if (const auto* conditional = llvm::dyn_cast<clang::ConditionalOperator>(expr)) return Conditional(conditional);
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return Element(element);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return MemberAccess(member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return CallOf(call);
  if (const auto* size = llvm::dyn_cast<clang::UnaryExprOrTypeTraitExpr>(expr)) {
    clang::Expr::EvalResult value;
    if (size->EvaluateAsInt(value, context_)) return Integer(expr, value.Val.getInt().getExtValue());
    return Poison(expr);
  }
  return Poison(expr);  // an extension, already refused
}

ExprId Converter::Parenthesised(const clang::ParenExpr* expr) {
  const ExprId id = Operand(expr->getSubExpr());
  Expr& inner = unit_.expressions[id];
  inner.parenthesized = true;
  inner.range = RangeOf(expr);
  LocateMacro(expr, inner);
  return id;
}

ExprId Converter::Name(const clang::DeclRefExpr* expr) {
  const clang::ValueDecl* declaration = expr->getDecl();
  if (const auto* enumerator = llvm::dyn_cast<clang::EnumConstantDecl>(declaration)) {
    return Integer(expr, enumerator->getInitVal().getExtValue());
  }
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(declaration);
  if (variable == nullptr) {  // a function where no function can stand
    if (llvm::isa<clang::FunctionDecl>(declaration)) {
      findings().Report(RangeOf(expr), diag::HncFunctionPointer, "'" + declaration->getNameAsString() + "' as a value");
    }
    return Poison(expr);
  }
  if (std::string_view(variable->getName()) == kPoisonName) return Poison(expr);
  const VariableId id = VariableOf(variable);
  if (unit_.variables[id].storage == Storage::kUndefined) {
    const std::string name = variable->getNameAsString();
    if (undefined_.insert(name).second) findings().Report(RangeOf(expr), diag::HncUndefinedVariable, name);
    return Poison(expr);
  }
  Expr result = Start(ExprKind::kVariable, expr);
  result.type = unit_.variables[id].type;
  result.variable = id;
  return unit_.expressions.Add(std::move(result));
}

ExprId Converter::Cast(const clang::CastExpr* expr) {
  const clang::Expr* operand = expr->getSubExpr();
  const bool implicit = llvm::isa<clang::ImplicitCastExpr>(expr);
  const auto wrap = [&](ExprKind kind) {
    const ExprId inner = kind == ExprKind::kConvert ? Operand(operand) : Convert(operand);
    if (unit_.expressions[inner].kind == ExprKind::kPoison) return inner;
    Expr result = implicit ? Unplaced(kind, expr) : Start(kind, expr);
    result.is_implicit = implicit;
    result.a = inner;
    if (implicit) {  // the same text
      result.range = unit_.expressions[inner].range;
      result.macro = unit_.expressions[inner].macro;
      result.whole_macro = unit_.expressions[inner].whole_macro;
      result.parenthesized = unit_.expressions[inner].parenthesized;
    }
    if (kind == ExprKind::kConvert && result.type == unit_.expressions[inner].type && implicit) return inner;
    return Add(std::move(result));
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
      Expr result = Start(ExprKind::kNull, expr);
      result.constant = Constant{};
      return unit_.expressions.Add(std::move(result));
    }
    case clang::CK_IntegralToPointer: {
      const auto* call = llvm::dyn_cast<clang::CallExpr>(operand->IgnoreParenImpCasts());
      const clang::FunctionDecl* callee = call == nullptr ? nullptr : call->getDirectCallee();
      Convert(operand);
      if (callee != nullptr && callee->getDefinition() == nullptr && callee->isImplicit()) return Poison(expr);
      findings().Report(RangeOf(expr), diag::HncAbsoluteAddress,
                        "'" + Written(RangeOf(operand)) + "' is a number and becomes a pointer");
      return Poison(expr);
    }
    case clang::CK_PointerToIntegral:
      if (operand->IgnoreParenImpCasts()->getType()->isArrayType()) {
        findings().Report(RangeOf(operand), diag::HncAreaAsValue, Written(RangeOf(operand)));
        return Poison(expr);
      }
      findings().Report(RangeOf(operand), diag::HncPointerAsValue, "'" + Written(RangeOf(operand)) + "' is an address");
      return Poison(expr);
    case clang::CK_FunctionToPointerDecay:
      findings().Report(RangeOf(operand), diag::HncFunctionPointer, "'" + Written(RangeOf(operand)) + "' as a value");
      return Poison(expr);
    default:
      return Poison(expr);  // an extension, already refused
  }
}

ExprId Converter::Unary(const clang::UnaryOperator* expr) {
  const clang::Expr* operand = expr->getSubExpr();
  const clang::UnaryOperatorKind kind = expr->getOpcode();
  if (kind == clang::UO_AddrOf && operand->getType()->isFunctionType()) {
    findings().Report(RangeOf(expr), diag::HncFunctionPointer, "'" + Written(RangeOf(expr)) + "' as a value");
    return Poison(expr);
  }
  if (expr->isIncrementDecrementOp() && ReportTableStore(operand)) return Poison(expr);
  Expr result = Start(ExprKind::kUnary, expr);
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  const bool promotes = kind == clang::UO_Plus || kind == clang::UO_Minus || kind == clang::UO_Not;
  result.a = promotes ? Operand(operand) : Convert(operand);
  if (unit_.expressions[result.a].kind == ExprKind::kPoison) return Poison(expr);
  if (promotes && IsPromoted(result.a, operand)) result.type = unit_.expressions[result.a].type;
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
  return Add(std::move(result));
}

ExprId Converter::Element(const clang::ArraySubscriptExpr* expr) {
  Expr result = Start(ExprKind::kIndex, expr);
  const clang::Expr* base = expr->getBase();
  // The array itself, not the address of its first element, so that its bounds are known.
  const auto* decay = llvm::dyn_cast<clang::ImplicitCastExpr>(base->IgnoreParens());
  if (decay != nullptr && decay->getCastKind() == clang::CK_ArrayToPointerDecay) base = decay->getSubExpr();
  result.a = Convert(base);
  result.b = Convert(expr->getIdx());
  const bool poison =
      unit_.expressions[result.a].kind == ExprKind::kPoison || unit_.expressions[result.b].kind == ExprKind::kPoison;
  if (poison) return Poison(expr);
  return unit_.expressions.Add(std::move(result));
}

ExprId Converter::MemberAccess(const clang::MemberExpr* expr) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(expr->getMemberDecl());
  if (field == nullptr) return Poison(expr);
  Expr result = Start(ExprKind::kMember, expr);
  result.member = field->getFieldIndex();
  result.op = session_.places.OfToken(expr->getOperatorLoc());
  result.a = Convert(expr->getBase());
  if (unit_.expressions[result.a].kind == ExprKind::kPoison) return Poison(expr);
  if (expr->isArrow()) {
    Expr object;
    object.kind = ExprKind::kDereference;
    object.is_implicit = true;
    object.is_lvalue = true;
    object.type = TypeOf(expr->getBase()->getType()->getPointeeType());
    object.range = unit_.expressions[result.a].range;
    object.a = result.a;
    result.a = unit_.expressions.Add(std::move(object));
  }
  // A record with an error in it has no members, and what asks for one has no address.
  const Type& record = unit_.types[unit_.expressions[result.a].type];
  const bool known = record.kind == TypeKind::kRecord && result.member < unit_.records[record.record].members.size();
  return known ? unit_.expressions.Add(std::move(result)) : Poison(expr);
}

ExprId Converter::Conditional(const clang::ConditionalOperator* expr) {
  Expr result = Start(ExprKind::kConditional, expr);
  result.op = session_.places.OfToken(expr->getQuestionLoc());
  result.a = Convert(expr->getCond());
  result.b = Operand(expr->getTrueExpr());
  result.c = Operand(expr->getFalseExpr());
  const TypeId common = CommonType(result.b, expr->getTrueExpr(), result.c, expr->getFalseExpr());
  if (common.valid()) result.type = common;
  return Add(std::move(result));
}

}  // namespace plcxx::hnc
