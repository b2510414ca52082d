// Operators and what both types share: precedence, parentheses, operands, constants.
#include "transpiler/dialects/nc110/parser/internal.h"

namespace plcxx::nc110 {

constexpr uint32_t kMaxParentheses = 32;

ExprId Parser::ErrorExpr(source::Range range) {
  Expr expr;
  expr.range = range;
  return program_.exprs.Add(expr);
}

ExprId Parser::OperandExpr(const OperandUse& use) {
  Expr expr;
  expr.kind = use.operand.kind == OperandKind::kNone ? ExprKind::kError : ExprKind::kOperand;
  expr.type = TypeOf(use.operand.kind);
  expr.range = use.range;
  expr.operand = use.operand;
  expr.symbol = use.symbol;
  return program_.exprs.Add(expr);
}

ExprId Parser::Unary(ExprKind kind, Type type, source::Range range, ExprId left) {
  Expr expr;
  expr.kind = kind;
  expr.type = type;
  expr.range = range;
  expr.left = left;
  return program_.exprs.Add(expr);
}

ExprId Parser::Binary(ExprKind kind, Type type, ExprId left, ExprId right) {
  Expr expr;
  expr.kind = kind;
  expr.type = type;
  expr.range = {program_.exprs[left].range.begin, program_.exprs[right].range.end};
  expr.left = left;
  expr.right = right;
  return program_.exprs.Add(expr);
}

/// '+' and '&' on one level from left to right; or, by option, '&' above '+'.
ExprId Parser::ParseExpression(Type type) {
  const bool above = options_.xor_precedence == XorPrecedence::kAboveOr;
  ExprId sum;  // above only: the terms of '+' that are complete
  ExprId current = ParseAnd(type);
  bool has_or = false;
  bool has_xor = false;
  while (!panic_ && (At(TokenKind::kPlus) || At(TokenKind::kAmpersand))) {
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

ExprId Parser::ParseAnd(Type type) {
  ExprId left = ParseNot(type);
  while (!panic_ && TakeIf(TokenKind::kStar)) {
    const ExprId right = ParseNot(type);
    left = Binary(ExprKind::kAnd, type, left, right);
  }
  return left;
}

ExprId Parser::ParseNot(Type type) {
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

ExprId Parser::ParsePrimary(Type type) {
  if (AtOperand()) return ParseOperand(type);
  if (At(TokenKind::kNumber)) return ParseConstant(type);
  if (At(TokenKind::kOpenParenthesis)) return ParseGroup(type);
  if (At(TokenKind::kOpenBracket)) return type == Type::kSignal ? ParseComparator() : ParseBracket();
  if (At(TokenKind::kAscii)) return ParseAscii(type);
  if (At(TokenKind::kFunction)) return ParseFunction(type);
  if (At(TokenKind::kMinus)) return HardFault(Peek().range, diag::Nc110MinusOutside);
  return Expected(primary_name_);
}

bool Parser::EnterParenthesis(source::Range range) {
  if (++parentheses_ > kMaxParentheses) {
    HardFault(range, diag::Nc110TooDeep);
    return false;
  }
  return true;
}

ExprId Parser::ParseGroup(Type type) {
  const source::Range open = Take().range;
  if (!EnterParenthesis(open)) {
    return ErrorExpr(open);
  }
  const ExprId inner = ParseExpression(type);
  if (!panic_ && At(TokenKind::kMinus)) {
    return HardFault(Peek().range, diag::Nc110MinusOutside);
  }
  if (!At(TokenKind::kCloseParenthesis) && !panic_) {
    Expected("')'");
    return inner;
  }
  if (!panic_) {
    program_.exprs[inner].range = {open.begin, Take().range.end};
    --parentheses_;
  }
  return inner;
}

ExprId Parser::ParseOperand(Type type) {
  // "U4K0=I0A0*" and the next statement on the next line: the operand there is not ours.
  if (Peek().first_on_line && LooksLikeTarget(0) && position_ > 0) {
    return Expected(primary_name_);
  }
  CountOperand();
  if (panic_) {
    return ErrorExpr(Peek().range);
  }
  if (At(TokenKind::kRun)) {
    return ParseUnknownPrimary();
  }
  const std::string text(TextOf(Peek()));
  const OperandUse use = TakeOperand();
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

ExprId Parser::ParseUnknownPrimary() {
  const ExprId expr = OperandExpr(TakeOperand());
  panic_ = panic_ || At(TokenKind::kOpenParenthesis);  // a misspelled function
  return expr;
}

ExprId Parser::ParseConstant(Type type) {
  CountOperand();
  if (panic_) {
    return ErrorExpr(Peek().range);
  }
  const ConstantUse constant = TakeConstant();
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
void Parser::WarnOrOfNumber(source::Range sign, ExprId left, ExprId right) {
  const Expr& number = program_.exprs[right];
  const Expr& word = program_.exprs[left];
  if (panic_ || number.kind != ExprKind::kConstant || word.kind != ExprKind::kOperand) {
    return;
  }
  const std::string_view digits = sources_.Text(number.range);
  if (!digits.empty() && (IsDigit(digits.back()) || Upper(digits.back()) == 'D')) {
    Warn(sign, diag::Nc110OrOfNumber, std::string(sources_.Text(word.range)) + "+" + std::string(digits));
  }
}

/// Once per file; conditions have a warning of their own, W321.
void Parser::WarnConstantSignal(source::Range range) {
  if (!in_condition_ && !std::exchange(constant_warned_, true)) {
    Warn(range, diag::Nc110Extension, "a constant in a signal expression");
  }
}

ExprId Parser::ParseAscii(Type type) {
  CountOperand();
  if (panic_) {
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
