#include "transpiler/dialects/hnc/parser/clang/promotions.h"

#include "transpiler/dialects/hnc/parser/clang/value_range.h"

namespace plcxx::hnc {
namespace {

bool IsUnsigned(const clang::Expr* expr) { return expr->getType()->isSpecificBuiltinType(clang::BuiltinType::UInt); }

}  // namespace

bool Promotions::IsPromoted(ExprId operand, const clang::Expr* expr) const {
  const Expr& converted = unit_.expressions[operand];
  if (converted.kind == ExprKind::kPoison || !converted.type.valid() || !IsUnsigned(expr)) return false;
  const Type& type = unit_.types[converted.type];
  return type.kind == TypeKind::kInteger && type.is_signed && type.bits == 16;
}

ExprId Promotions::Promoted(ExprId operand, const clang::Expr* expr) {
  const auto* step = llvm::dyn_cast<clang::UnaryOperator>(expr);
  if (step == nullptr || !step->isPostfix() || !IsUnsigned(expr) || IsPoison(operand)) return operand;
  const bool is_narrow = context_.isPromotableBitField(step->getSubExpr()) == context_.IntTy;
  return is_narrow ? builder_.InType(operand, types_.TypeOf(context_.IntTy)) : operand;
}

ExprId Promotions::Unpromoted(ExprId operand, const clang::Expr* expr) {
  if (!IsPromoted(operand, expr)) return operand;
  const TypeId type = types_.TypeOf(expr->getType());
  const Expr& promoted = unit_.expressions[operand];
  const bool is_made = promoted.kind == ExprKind::kConvert && promoted.is_implicit;
  if (!is_made || unit_.expressions[promoted.a].type != type) return builder_.InType(operand, type);
  Expr& step = unit_.expressions[promoted.a];
  step.range = promoted.range;
  step.macro = promoted.macro;
  step.whole_macro = promoted.whole_macro;
  step.parenthesized = promoted.parenthesized;
  return promoted.a;
}

/// By the promotions of integers.
bool Promotions::BecomesInt(const clang::Expr* expr) const {
  const clang::QualType type = expr->getType();
  return type->isSpecificBuiltinType(clang::BuiltinType::Int) ||
         context_.isPromotableBitField(const_cast<clang::Expr*>(expr)) ==
             context_.IntTy ||  // Clang has it without const
         (context_.isPromotableIntegerType(type) && context_.getPromotedIntegerType(type) == context_.IntTy);
}

void Promotions::CommonTypeOfAssignment(const clang::CompoundAssignOperator* expr, Expr& result) {
  if (!expr->getLHS()->getType()->isIntegerType()) return;
  if (BecomesInt(expr->getLHS())) {
    result.computation = unit_.expressions[result.b].type;
    MarkOperator(result.binary, result.a, result.b);
  } else {
    result.b = builder_.InType(result.b, result.computation);
  }
}

TypeId Promotions::CommonType(ExprId& a, const clang::Expr* of_a, ExprId& b, const clang::Expr* of_b) {
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
    return builder_.InType(is_made ? operand.a : id, int_type);
  };
  if (!a_is_promoted || !b_is_promoted) {
    ExprId& other = a_is_promoted ? b : a;
    const ExprId unconverted = before(other, a_is_promoted ? of_b : of_a);
    if (!unconverted.valid()) {
      ExprId& promoted = a_is_promoted ? a : b;
      promoted = builder_.InType(promoted, unit_.expressions[other].type);
      return {};
    }
    other = unconverted;
  }
  return int_type;
}

bool Promotions::MayBeNegative(ExprId operand) const { return ValueRangeOf(unit_, operand).low < 0; }

void Promotions::MarkFunction() {
  NoteThatClangDiffers("the value of a bit-field after a postfix '++' or '--' is unsigned to Clang, and int in C");
}

/// Of two numbers that are not negative both have the same; sums, products and bits are the same of all numbers.
void Promotions::MarkOperator(BinaryOp op, ExprId a, ExprId b) {
  const bool is_quotient = op == BinaryOp::kDivide || op == BinaryOp::kRemainder;
  const bool looks_at_both = is_quotient || Info(op).family == BinaryFamily::kOrder;
  const bool looks_at_one = op == BinaryOp::kShiftRight;
  if (!looks_at_both && !looks_at_one) return;
  if (MayBeNegative(a) || (looks_at_both && MayBeNegative(b))) MarkFunction();
}

void Promotions::MarkConversion(ExprId operand, TypeId type) {
  const Type& target = unit_.types[type];
  const bool shows_sign = target.kind == TypeKind::kReal || (target.kind == TypeKind::kInteger && target.bits > 16);
  if (shows_sign && MayBeNegative(operand)) MarkFunction();
}

}  // namespace plcxx::hnc
