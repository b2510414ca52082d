#include "transpiler/dialects/nc110/parser/expression_reader.h"

namespace plcxx::nc110 {

ExprId ExpressionReader::OperandExpr(const OperandUse& use) {
  Expr expr;
  expr.kind = use.operand.kind == OperandKind::kNone ? ExprKind::kError : ExprKind::kOperand;
  expr.type = TypeOf(use.operand.kind);
  expr.range = use.range;
  expr.operand = use.operand;
  expr.symbol = use.symbol;
  return program_.exprs.Add(expr);
}

ExprId ExpressionReader::Unary(ExprKind kind, Type type, source::Range range, ExprId left) {
  Expr expr;
  expr.kind = kind;
  expr.type = type;
  expr.range = range;
  expr.left = left;
  return program_.exprs.Add(expr);
}

ExprId ExpressionReader::Binary(ExprKind kind, Type type, ExprId left, ExprId right) {
  Expr expr;
  expr.kind = kind;
  expr.type = type;
  expr.range = {program_.exprs[left].range.begin, program_.exprs[right].range.end};
  expr.left = left;
  expr.right = right;
  return program_.exprs.Add(expr);
}

/// '+' and '&' on one level from left to right; or, by option, '&' above '+'.
ExprId ExpressionReader::ParseExpression(Type type) {
  const bool above = options_.xor_precedence == XorPrecedence::kAboveOr;
  ExprId sum;  // above only: the terms of '+' that are complete
  ExprId current = ParseAnd(type);
  bool has_or = false;
  bool has_xor = false;
  while (!now_.panic && (At(TokenKind::kPlus) || At(TokenKind::kAmpersand))) {
    const Token& sign = Take();
    const bool is_or = sign.kind == TokenKind::kPlus;
    if (is_or ? has_xor && !has_or : has_or && !has_xor) {
      Warn(sign.range, diag::Nc110OrXorMixed);
    }
    (is_or ? has_or : has_xor) = true;
    const ExprId right = ParseAnd(type);
    if (is_or && type == Type::kWord) {
      WarnOrOfNumber(sign.range, current, right);
    }
    if (!is_or || !above) {
      current = Binary(is_or ? ExprKind::kOr : ExprKind::kXor, type, current, right);
    } else {
      sum = sum.valid() ? Binary(ExprKind::kOr, type, sum, current) : current;
      current = right;
    }
  }
  return sum.valid() ? Binary(ExprKind::kOr, type, sum, current) : current;
}

ExprId ExpressionReader::ParseAnd(Type type) {
  ExprId left = ParseNot(type);
  while (!now_.panic && TakeIf(TokenKind::kStar)) {
    const ExprId right = ParseNot(type);
    left = Binary(ExprKind::kAnd, type, left, right);
  }
  return left;
}

ExprId ExpressionReader::ParseNot(Type type) {
  const source::Offset begin = Peek().range.begin;
  bool inverted = false;
  bool any = false;
  while (TakeIf(TokenKind::kSlash)) {
    inverted = !inverted;  // two of them cancel, so that a chain does not make a deep tree
    any = true;
  }
  const ExprId inner = ParsePrimary(type);
  if (!inverted) {
    if (any) {
      program_.exprs[inner].range.begin = begin;
    }
    return inner;
  }
  return Unary(ExprKind::kNot, type, {begin, program_.exprs[inner].range.end}, inner);
}

ExprId ExpressionReader::ParsePrimary(Type type) {
  if (AtOperand()) return ParseOperand(type);
  if (At(TokenKind::kNumber)) return ParseConstant(type);
  if (At(TokenKind::kOpenParenthesis)) return ParseGroup(type);
  if (At(TokenKind::kOpenBracket)) return type == Type::kSignal ? words_.ParseComparator() : words_.ParseBracket();
  if (At(TokenKind::kAscii)) return ParseAscii(type);
  if (At(TokenKind::kFunction)) return words_.ParseFunction(type);
  if (At(TokenKind::kMinus)) return HardFault(Peek().range, diag::Nc110MinusOutside);
  return Expected(now_.primary_name);
}

ExprId ExpressionReader::ParseGroup(Type type) {
  const source::Range open = Take().range;
  if (!EnterParenthesis(open)) {
    return ErrorExpr(open);
  }
  const ExprId inner = ParseExpression(type);
  if (!now_.panic && At(TokenKind::kMinus)) {
    return HardFault(Peek().range, diag::Nc110MinusOutside);
  }
  if (!At(TokenKind::kCloseParenthesis) && !now_.panic) {
    Expected("')'");
    return inner;
  }
  if (!now_.panic) {
    program_.exprs[inner].range = {open.begin, Take().range.end};
    --now_.parentheses;
  }
  return inner;
}

ExprId ExpressionReader::ParseOperand(Type type) {
  // "U4K0=I0A0*" and the next statement on the next line: the operand there is not ours.
  if (Peek().first_on_line && LooksLikeTarget(0) && now_.position > 0) {
    return Expected(now_.primary_name);
  }
  operands_.CountOperand();
  if (now_.panic) {
    return ErrorExpr(Peek().range);
  }
  if (At(TokenKind::kRun)) {
    return ParseUnknownPrimary();
  }
  const std::string text(TextOf(Peek()));
  const OperandUse use = operands_.TakeOperand();
  const Type found = TypeOf(use.operand.kind);
  if (found == Type::kUnknown || found == type) {
    return OperandExpr(use);
  }
  if (type == Type::kSignal) {
    Fault(use.range, diag::Nc110SignalExpected, Quoted(text), text);
  } else {
    Fault(use.range, diag::Nc110WordExpected, Quoted(text));
  }
  return ErrorExpr(use.range);
}

ExprId ExpressionReader::ParseUnknownPrimary() {
  const ExprId expr = OperandExpr(operands_.TakeOperand());
  now_.panic = now_.panic || At(TokenKind::kOpenParenthesis);  // a misspelled function
  return expr;
}

ExprId ExpressionReader::ParseConstant(Type type) {
  operands_.CountOperand();
  if (now_.panic) {
    return ErrorExpr(Peek().range);
  }
  const ConstantUse constant = operands_.TakeConstant();
  Expr expr;
  expr.range = constant.range;
  if (!constant.well_formed) {
    return program_.exprs.Add(expr);
  }
  if (type == Type::kSignal ? constant.value > 1 : constant.value > 255) {
    if (type == Type::kSignal) {
      Fault(constant.range, diag::Nc110SignalConstant, constant.text);
    } else {
      Fault(constant.range, diag::Nc110ConstantRange, constant.text);
    }
    return program_.exprs.Add(expr);
  }
  if (type == Type::kSignal) {
    WarnConstantSignal(constant.range);
  }
  expr.kind = ExprKind::kConstant;
  expr.type = type;
  expr.value = static_cast<uint8_t>(constant.value);
  return program_.exprs.Add(expr);
}

/// "W1K0+1" looks like a sum. A mask of bits is written in hexadecimal, as a rule; a decimal number is meant as one.
void ExpressionReader::WarnOrOfNumber(source::Range sign, ExprId left, ExprId right) {
  const Expr& number = program_.exprs[right];
  const Expr& word = program_.exprs[left];
  if (now_.panic || number.kind != ExprKind::kConstant || word.kind != ExprKind::kOperand) {
    return;
  }
  const std::string_view digits = sources_.Text(number.range);
  if (!digits.empty() && (IsDigit(digits.back()) || Upper(digits.back()) == 'D')) {
    Warn(sign, diag::Nc110OrOfNumber, std::string(sources_.Text(word.range)) + "+" + std::string(digits));
  }
}

/// Once per file; conditions have a warning of their own, W321.
void ExpressionReader::WarnConstantSignal(source::Range range) {
  if (!now_.in_condition && !std::exchange(now_.constant_warned, true)) {
    Warn(range, diag::Nc110Extension, "a constant in a signal expression");
  }
}

ExprId ExpressionReader::ParseAscii(Type type) {
  operands_.CountOperand();
  if (now_.panic) {
    return ErrorExpr(Peek().range);
  }
  const Token& token = Take();
  Expr expr;
  expr.range = token.range;
  if (type == Type::kWord) {
    Fault(token.range, diag::Nc110WordExpected, TextOf(token));
  } else if (!token.faulty) {
    const std::string_view text = TextOf(token);
    const auto [entry, is_new] = literals_.try_emplace(text.substr(1, text.size() - 2));
    if (is_new) {
      entry->second = program_.literals.Add({{token.range.begin + 1, token.range.end - 1}});
    }
    expr.kind = ExprKind::kAscii;
    expr.type = Type::kSignal;
    expr.literal = entry->second;
  }
  return program_.exprs.Add(expr);
}

}  // namespace plcxx::nc110
