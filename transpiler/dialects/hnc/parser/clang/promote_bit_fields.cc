// What holds the value of a bit-field is promoted to int (specification 6.1), also after a postfix ++ or --.
//
// Clang promotes what it can follow to a field: an access, an assignment, a prefix step, an operand of a comma. Of
// `s.f++` it keeps the declared type, so that `s.f++ - 5` would be 65531 where `s.f - 5` is -5. Here such a value is
// int; operators above it, which Clang computes in `unsigned int` for its sake alone, are int, too. Everything else has
// the type that Clang gives it.
#include <utility>

#include "transpiler/dialects/hnc/parser/clang/converter.h"

namespace plcxx::hnc {
namespace {

bool IsUnsigned(const clang::Expr* expr) { return expr->getType()->isSpecificBuiltinType(clang::BuiltinType::UInt); }

}  // namespace

/// Is it int where Clang has unsigned int?
bool Converter::IsPromoted(ExprId operand, const clang::Expr* expr) const {
  const Expr& converted = unit_.expressions[operand];
  if (converted.kind == ExprKind::kPoison || !converted.type.valid() || !IsUnsigned(expr)) return false;
  const Type& type = unit_.types[converted.type];
  return type.kind == TypeKind::kInteger && type.is_signed && type.bits == 16;
}

ExprId Converter::InType(ExprId operand, TypeId type) {
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

ExprId Converter::Operand(const clang::Expr* expr) {
  const ExprId id = AnyExpression(expr);
  const auto* step = llvm::dyn_cast<clang::UnaryOperator>(expr);
  if (step == nullptr || !step->isPostfix() || !IsUnsigned(expr)) return id;
  if (unit_.expressions[id].kind == ExprKind::kPoison) return id;
  const bool is_narrow = context_.isPromotableBitField(step->getSubExpr()) == context_.IntTy;
  return is_narrow ? InType(id, TypeOf(context_.IntTy)) : id;
}

ExprId Converter::Convert(const clang::Expr* expr) {
  const ExprId id = Operand(expr);
  if (!IsPromoted(id, expr)) return id;
  const TypeId type = TypeOf(expr->getType());
  const Expr& promoted = unit_.expressions[id];
  const bool is_made = promoted.kind == ExprKind::kConvert && promoted.is_implicit;
  if (!is_made || unit_.expressions[promoted.a].type != type) return InType(id, type);
  Expr& step = unit_.expressions[promoted.a];
  step.range = promoted.range;
  step.macro = promoted.macro;
  step.whole_macro = promoted.whole_macro;
  step.parenthesized = promoted.parenthesized;
  return promoted.a;
}

/// By the promotions of integers.
bool Converter::BecomesInt(const clang::Expr* expr) const {
  const clang::QualType type = expr->getType();
  return type->isSpecificBuiltinType(clang::BuiltinType::Int) ||
         context_.isPromotableBitField(const_cast<clang::Expr*>(expr)) ==
             context_.IntTy ||  // Clang has it without const
         (context_.isPromotableIntegerType(type) && context_.getPromotedIntegerType(type) == context_.IntTy);
}

/// a op= b, where b is promoted: a alone decides, and where that is unsigned or no integer, Clang's type is right.
void Converter::CommonTypeOfAssignment(const clang::CompoundAssignOperator* expr, Expr& result) {
  if (!expr->getLHS()->getType()->isIntegerType()) return;
  if (BecomesInt(expr->getLHS())) {
    result.computation = unit_.expressions[result.b].type;
  } else {
    result.b = InType(result.b, result.computation);
  }
}

/// Of two operands that Clang has brought to one type: int where only promoted values made it unsigned int, and then
/// both are; none: that of Clang, which both have.
TypeId Converter::CommonType(ExprId& a, const clang::Expr* of_a, ExprId& b, const clang::Expr* of_b) {
  const bool a_is_promoted = IsPromoted(a, of_a), b_is_promoted = IsPromoted(b, of_b);
  if (!a_is_promoted && !b_is_promoted) return {};
  for (const ExprId id : {a, b}) {
    const Expr& operand = unit_.expressions[id];
    if (operand.kind == ExprKind::kPoison || !operand.type.valid()) return {};
  }
  const TypeId int_type = unit_.expressions[a_is_promoted ? a : b].type;
  // An int that was converted for the other one's sake.
  const auto before = [&](ExprId id, const clang::Expr* of) {
    const Expr& operand = unit_.expressions[id];
    const bool is_made = operand.kind == ExprKind::kConvert && operand.is_implicit;
    if (is_made && unit_.expressions[operand.a].type == int_type) return operand.a;
    // Of a char, a short or another bit-field Clang has the promotion and the conversion in one cast; of a bit-field it
    // changes no type.
    const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(of);
    if (cast == nullptr || cast->getCastKind() != clang::CK_IntegralCast || !BecomesInt(cast->getSubExpr()))
      return ExprId();
    return InType(is_made ? operand.a : id, int_type);
  };
  if (!a_is_promoted || !b_is_promoted) {
    ExprId& other = a_is_promoted ? b : a;
    const ExprId unconverted = before(other, a_is_promoted ? of_b : of_a);
    if (!unconverted.valid()) {
      ExprId& promoted = a_is_promoted ? a : b;
      promoted = InType(promoted, unit_.expressions[other].type);
      return {};
    }
    other = unconverted;
  }
  return int_type;
}

}  // namespace plcxx::hnc
