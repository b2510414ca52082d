#include "transpiler/dialects/nc110/lowering/expressions.h"

#include <string_view>

#include "transpiler/dialects/nc110/lowering/latched_inputs.h"
#include "transpiler/dialects/nc110/lowering/texts.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {

using ir::OpKind;

ir::ValueId Expressions::Evaluate(ExprId id, ir::Type wanted) {
  if (!id.valid()) return builder_.Poison(wanted);
  const ir::ValueId value = EvaluateExpr(tree_.exprs[id]);
  return program_[value].type == wanted ? value : builder_.Poison(wanted);
}

ir::ValueId Expressions::Constant(const Expr& expr) {
  builder_.SetRange(expr.range);
  if (expr.type == Type::kSignal) return builder_.Bit(expr.value);
  const std::string_view text = sources_.Text(expr.range);
  const size_t last = text.find_last_not_of(" \t)]");
  const bool hexadecimal = last != std::string_view::npos && Upper(text[last]) == 'H';
  return builder_.Constant(ir::Type::kI8, expr.value, hexadecimal ? 16 : 10);
}

ir::ValueId Expressions::Two(OpKind bits, OpKind words, const Expr& expr) {
  const bool signal = expr.type == Type::kSignal;
  const ir::Type type = signal ? ir::Type::kBit : ir::Type::kI8;
  const ir::ValueId left = Evaluate(expr.left, type), right = Evaluate(expr.right, type);
  builder_.SetRange(expr.range);
  return builder_.Pure(signal ? bits : words, {left, right});
}

ir::ValueId Expressions::EvaluateExpr(const Expr& expr) {
  const auto one = [&](OpKind op) {
    const ir::ValueId operand = Evaluate(expr.left, ir::Info(op).operands[0]);
    builder_.SetRange(expr.range);
    return builder_.Pure(op, {operand});
  };
  const auto two_words = [&](OpKind op) {
    const ir::ValueId left = Evaluate(expr.left, ir::Type::kI8), right = Evaluate(expr.right, ir::Type::kI8);
    builder_.SetRange(expr.range);
    return builder_.Pure(op, {left, right});
  };
  switch (expr.kind) {
    case ExprKind::kError:
      return builder_.Poison(expr.type == Type::kWord ? ir::Type::kI8 : ir::Type::kBit);
    case ExprKind::kOperand: {
      builder_.SetRange(expr.range);
      if (expr.operand.kind == OperandKind::kNone) return builder_.Poison(ir::Type::kBit);
      return builder_.Load(inputs_.ReadPlaceOf(expr.operand));
    }
    case ExprKind::kConstant:
      return Constant(expr);
    case ExprKind::kAscii:
      builder_.SetRange(expr.range);
      return builder_.Load(texts_.FlagOf(expr.literal));
    case ExprKind::kNot:
      return one(expr.type == Type::kWord ? OpKind::kNot8 : OpKind::kBitNot);
    case ExprKind::kAnd:
      return Two(OpKind::kBitAnd, OpKind::kAnd8, expr);
    case ExprKind::kOr:
      return Two(OpKind::kBitOr, OpKind::kOr8, expr);
    case ExprKind::kXor:
      return Two(OpKind::kBitXor, OpKind::kXor8, expr);
    case ExprKind::kAdd:
      return two_words(OpKind::kAdd8);
    case ExprKind::kSubtract:
      return two_words(OpKind::kSub8);
    case ExprKind::kLess:
      return two_words(OpKind::kLess8);
    case ExprKind::kEqual:
      return two_words(OpKind::kEqual8);
    case ExprKind::kGreater:
      return two_words(OpKind::kGreater8);
#define PLCXX_WORD_FUNCTION(Kind, NameText, Operation, ...) \
  case ExprKind::k##Kind:                                   \
    return one(OpKind::k##Operation);
#include "transpiler/dialects/nc110/machine/functions.def"
    case ExprKind::kSgn:
      return one(OpKind::kSignBit8);
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::nc110
