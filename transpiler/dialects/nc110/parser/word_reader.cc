#include "transpiler/dialects/nc110/parser/word_reader.h"

#include "transpiler/dialects/nc110/parser/expression_reader.h"

namespace plcxx::nc110 {
namespace {

struct FunctionMessages {
  const diag::Message<>& as_signal;
  const diag::Message<diag::Text>& open;
  const diag::Message<diag::Text>& close;
};

const FunctionMessages& MessagesOf(Function function) {
  static const FunctionMessages kMessages[] = {
#define PLCXX_WORD_FUNCTION(Kind, ...) {diag::Nc110##Kind##AsSignal, diag::Nc110##Kind##Open, diag::Nc110##Kind##Close},
#include "transpiler/dialects/nc110/machine/functions.def"
  };
  return kMessages[static_cast<size_t>(function)];
}

bool IsComparisonSign(TokenKind kind) {
  return kind == TokenKind::kLess || kind == TokenKind::kAssign || kind == TokenKind::kGreater;
}

/// The greatest value a word expression can have.
uint32_t UpperBound(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::kConstant:
      return expr.value;
#define PLCXX_WORD_FUNCTION(Kind, NameText, Operation, greatest) \
  case ExprKind::k##Kind:                                        \
    return greatest;
#include "transpiler/dialects/nc110/machine/functions.def"
    case ExprKind::kError:
    case ExprKind::kOperand:
    case ExprKind::kAscii:
    case ExprKind::kNot:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kXor:
    case ExprKind::kAdd:
    case ExprKind::kSubtract:
    case ExprKind::kLess:
    case ExprKind::kEqual:
    case ExprKind::kGreater:
    case ExprKind::kSgn:
      return 255;
  }
  PLCXX_UNREACHABLE();
}

uint32_t LowerBound(const Expr& expr) { return expr.kind == ExprKind::kConstant ? expr.value : 0; }

}  // namespace

ExprId WordReader::ParseFunction(Type type) {
  const Token& token = Peek();
  switch (token.function) {
    case Function::kMux:
      CheckCase(token);
      return HardFault(token.range, diag::Nc110MuxPlace);
    case Function::kSgn:
      if (type == Type::kWord) {
        Fault(token.range, diag::Nc110SgnAsWord);
      }
      return ParseSgn();
#define PLCXX_WORD_FUNCTION(Kind, ...) case Function::k##Kind:
#include "transpiler/dialects/nc110/machine/functions.def"
      if (type == Type::kSignal) {
        Fault(token.range, MessagesOf(token.function).as_signal);
      }
      return ParseWordFunction();
  }
  PLCXX_UNREACHABLE();
}

ExprId WordReader::ParseWordFunction() {
  const Token& word = Take();
  CheckCase(word);
  const FunctionMessages& messages = MessagesOf(word.function);
  if (!At(TokenKind::kOpenParenthesis)) {
    return HardFault(MissingAt(), messages.open, Found());
  }
  const source::Range open = Take().range;
  if (!EnterParenthesis(open)) {
    return ErrorExpr(open);
  }
  const ExprId argument = word.function == Function::kAbs ? ParseSum() : expressions_.ParseExpression(Type::kWord);
  if (now_.panic) {
    return argument;
  }
  if (At(TokenKind::kMinus)) {
    return HardFault(Peek().range, diag::Nc110MinusOutside);
  }
  if (!At(TokenKind::kCloseParenthesis)) {
    return HardFault(MissingAt(), messages.close, Found());
  }
  --now_.parentheses;
  return expressions_.Unary(ExprKindOf(word.function), Type::kWord, {word.range.begin, Take().range.end}, argument);
}

ExprId WordReader::ParseSgn() {
  const Token& word = Take();
  CheckCase(word);
  const bool bracket = At(TokenKind::kOpenBracket);
  if (!bracket && !At(TokenKind::kOpenParenthesis)) {
    return HardFault(MissingAt(), diag::Nc110SgnOpen, Found());
  }
  const source::Range open = Take().range;
  if (bracket) {
    ++now_.open_brackets;
  } else if (!EnterParenthesis(open)) {
    return ErrorExpr(open);
  }
  const ExprId argument = ParseSum();
  if (now_.panic) {
    return argument;
  }
  if (!At(bracket ? TokenKind::kCloseBracket : TokenKind::kCloseParenthesis)) {
    return HardFault(MissingAt(), diag::Nc110SgnClose, bracket ? "']'" : "')'", Found());
  }
  --(bracket ? now_.open_brackets : now_.parentheses);
  return expressions_.Unary(ExprKind::kSgn, Type::kSignal, {word.range.begin, Take().range.end}, argument);
}

/// '[' in a word position: 8-bit arithmetic.
ExprId WordReader::ParseBracket() {
  const source::Offset begin = Take().range.begin;
  ++now_.open_brackets;
  const ExprId sum = ParseSum();
  if (now_.panic) {
    return sum;
  }
  if (!At(TokenKind::kCloseBracket)) {
    return HardFault(MissingAt(), diag::Nc110ArithmeticClose, Found());
  }
  --now_.open_brackets;
  program_.exprs[sum].range = {begin, Take().range.end};
  return sum;
}

/// Addition and subtraction, from left to right.
ExprId WordReader::ParseSum() {
  ExprId left = ParseTerm();
  while (!now_.panic && (At(TokenKind::kPlus) || At(TokenKind::kMinus))) {
    const ExprKind kind = Take().kind == TokenKind::kPlus ? ExprKind::kAdd : ExprKind::kSubtract;
    const ExprId right = ParseTerm();
    left = expressions_.Binary(kind, Type::kWord, left, right);
  }
  return left;
}

ExprId WordReader::ParseTerm() {
  if (AtOperand()) return expressions_.ParseOperand(Type::kWord);
  if (At(TokenKind::kNumber)) return expressions_.ParseConstant(Type::kWord);
  if (At(TokenKind::kAscii)) return expressions_.ParseAscii(Type::kWord);
  if (At(TokenKind::kFunction)) return ParseFunction(Type::kWord);
  if (At(TokenKind::kMinus)) {
    return HardFault(MissingAt(), diag::Nc110ExpectedHint, "word, constant or function", Found(),
                     "no sign stands in front of a term: subtract from 0, [0-W1K0]; -1 is 255");
  }
  if (!At(TokenKind::kOpenParenthesis)) return Expected("word, constant or function");
  const source::Range open = Take().range;
  if (!EnterParenthesis(open)) {
    return ErrorExpr(open);
  }
  const ExprId sum = ParseSum();
  if (!now_.panic && !At(TokenKind::kCloseParenthesis)) {
    Expected("')'");
  }
  if (!now_.panic) {
    --now_.parentheses;
    program_.exprs[sum].range = {open.begin, Take().range.end};
  }
  return sum;
}

/// '[' in a signal position.
ExprId WordReader::ParseComparator() {
  const source::Offset begin = Take().range.begin;
  ++now_.open_brackets;
  const ExprId left = ParseComparatorArgument();
  if (now_.panic) {
    return left;
  }
  const TokenKind sign = Peek().kind;
  if (sign == TokenKind::kPlus || sign == TokenKind::kMinus || sign == TokenKind::kStar ||
      sign == TokenKind::kAmpersand) {
    return HardFault(Peek().range, diag::Nc110ComparatorArithmetic, Found());
  }
  if (!IsComparisonSign(sign)) {
    now_.failed = now_.failed || sign == TokenKind::kBad;  // its character has been reported
    return HardFault(MissingAt(), diag::Nc110ComparisonSign, Found());
  }
  Take();
  if (IsComparisonSign(Peek().kind)) {
    return DoubledSign(left, sign);
  }
  if (Peek().first_on_line && LooksLikeTarget(0)) {
    return HardFault(MissingAt(), diag::Nc110WordArgumentExpected, Found());  // the next statement
  }
  const ExprId right = ParseComparatorArgument();
  if (now_.panic) {
    return right;
  }
  const TokenKind next = Peek().kind;
  if (next == TokenKind::kPlus || next == TokenKind::kMinus || next == TokenKind::kStar ||
      next == TokenKind::kAmpersand) {
    return HardFault(Peek().range, diag::Nc110ComparatorArithmetic, Found());
  }
  if (next != TokenKind::kCloseBracket) {
    return HardFault(MissingAt(), diag::Nc110ComparatorClose, Found());
  }
  --now_.open_brackets;
  const ExprKind kind = sign == TokenKind::kLess     ? ExprKind::kLess
                        : sign == TokenKind::kAssign ? ExprKind::kEqual
                                                     : ExprKind::kGreater;
  const ExprId result = expressions_.Binary(kind, Type::kSignal, left, right);
  program_.exprs[result].range = {begin, Take().range.end};
  CheckComparison(result);
  return result;
}

/// '>=', '==' and the like: what is meant, with the operands that are there.
ExprId WordReader::DoubledSign(ExprId left, TokenKind first) {
  const TokenKind second = Peek().kind;
  const Token& right = Peek(1);
  const bool both = first == second && first != TokenKind::kAssign;  // '<<', '>>'
  const bool operand =
      right.kind == TokenKind::kOperand || right.kind == TokenKind::kNumber || right.kind == TokenKind::kSymbol;
  if (both || !operand) {
    return HardFault(Peek().range, diag::Nc110ComparisonSignTwice, Found());
  }
  const auto either = [&](TokenKind kind) { return first == kind || second == kind; };
  const bool less = either(TokenKind::kLess), greater = either(TokenKind::kGreater);
  const std::string_view sign = less == greater ? "=" : less ? ">" : "<";
  const std::string comparator = "[" + std::string(sources_.Text(program_.exprs[left].range)) + std::string(sign) +
                                 std::string(TextOf(right)) + "]";
  const bool negated = less || greater;
  const auto text = [](TokenKind kind) {
    return kind == TokenKind::kLess ? "<" : kind == TokenKind::kGreater ? ">" : "=";
  };
  const std::string written = std::string(text(first)) + text(second);
  return HardFault(Peek().range, diag::Nc110ComparisonSignForeign, written, (negated ? "/" : "") + comparator);
}

ExprId WordReader::ParseComparatorArgument() {
  const Token& token = Peek();
  if (AtOperand()) {
    operands_.CountOperand();
    if (now_.panic) {
      return ErrorExpr(token.range);
    }
    const OperandUse use = operands_.TakeOperand();
    if (TypeOf(use.operand.kind) == Type::kSignal) {
      Fault(use.range, diag::Nc110WordExpected, Quoted(TextOf(token)));
      return ErrorExpr(use.range);
    }
    now_.panic = now_.panic || At(TokenKind::kOpenParenthesis);  // a misspelled function, reported
    if (now_.panic && !now_.failed) {
      return HardFault(MissingAt(), diag::Nc110ComparisonSign, Found());
    }
    return expressions_.OperandExpr(use);
  }
  if (token.kind == TokenKind::kNumber) return expressions_.ParseConstant(Type::kWord);
  if (token.kind == TokenKind::kFunction) {
    if (token.function != Function::kMux && token.function != Function::kSgn) {
      Warn(token.range, diag::Nc110Extension, "a function in a comparator");
    }
    return ParseFunction(Type::kWord);
  }
  if (token.kind == TokenKind::kBad) return Expected("word");
  if (IsComparisonSign(token.kind)) return HardFault(token.range, diag::Nc110ComparisonSign, Found());
  return HardFault(MissingAt(), diag::Nc110WordArgumentExpected, Found());
}

void WordReader::CheckComparison(ExprId comparison) {
  const Expr& expr = program_.exprs[comparison];
  const Expr& left = program_.exprs[expr.left];
  const Expr& right = program_.exprs[expr.right];
  if (left.kind == ExprKind::kConstant && right.kind == ExprKind::kConstant) {
    Warn(expr.range, diag::Nc110ConstantComparison);
    return;
  }
  const bool out_of_reach = expr.kind == ExprKind::kLess ? LowerBound(left) >= UpperBound(right)
                            : expr.kind == ExprKind::kGreater
                                ? UpperBound(left) <= LowerBound(right)
                                : LowerBound(left) > UpperBound(right) || UpperBound(left) < LowerBound(right);
  if (out_of_reach) {
    Warn(expr.range, diag::Nc110NeverTrue, Plain(expr.range));
  }
}

}  // namespace plcxx::nc110
