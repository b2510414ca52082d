#include "transpiler/dialects/host50/parser/expression_reader.h"

#include <algorithm>

namespace plcxx::host50 {
namespace {

constexpr uint32_t kMostOperandsOfExpression = 1024;
constexpr uint32_t kMostParentheses = 64;

struct Relation {
  TokenKind token;
  ExprKind kind;
};
constexpr Relation kRelations[] = {{TokenKind::kGreater, ExprKind::kGreater},
                                   {TokenKind::kLess, ExprKind::kLess},
                                   {TokenKind::kGreaterEqual, ExprKind::kGreaterEqual},
                                   {TokenKind::kLessEqual, ExprKind::kLessEqual},
                                   {TokenKind::kEquals, ExprKind::kEqual},
                                   {TokenKind::kNotEqual, ExprKind::kNotEqual}};

std::optional<ExprKind> RelationOf(TokenKind token) {
  for (const Relation& relation : kRelations) {
    if (relation.token == token) return relation.kind;
  }
  return std::nullopt;
}

}  // namespace

ExprId ExpressionReader::ErrorExpr(source::Range range) {
  return program_.exprs.Add({.kind = ExprKind::kError, .range = range});
}

/// E401, E111, or where a comparison stands in its place E402 and E403.
void ExpressionReader::FaultOfExpression(std::string_view what) {
  if (FaultOfBadToken()) return;
  const std::string_view meant = MeantInExpression();
  if (meant.empty()) {
    Fault(Peek().range, diag::Host50ExpressionExpected, what, Found());
  } else {
    Fault(Peek().range, diag::Host50ExpressionForeign, what, Found(), meant);
  }
}

/// What operators and numbers of other languages are in this one, as a remedy; empty: nobody knows.
std::string_view ExpressionReader::MeantInExpression() const {
  const Token token = Peek();
  const std::string_view text = TextOf(token);
  const size_t at = token.range.begin - now_.source->base;
  const char before = at > 0 ? now_.source->text[at - 1] : ' ';
  const char behind = token.range.end - now_.source->base < now_.source->text.size()
                          ? now_.source->text[token.range.end - now_.source->base]
                          : ' ';
  if (before == '=' && text == "=") return "'equal' is one '='";
  if (before == '=' && text == "<") return "'less or equal' is '<='";
  if (before == '=' && text == ">") return "'greater or equal' is '>='";
  if (text == "!" && behind == '=') return "'not equal' is '<>'";
  if (behind == '=' && (text == "+" || text == "-" || text == "*" || text == "/")) {
    return "name the target again: %W1 = %W1 + 5";
  }
  if (text == "!") return "there is no negation in an expression: compare with 0";
  if (before == '&' && text == "&")
    return "'and' is one '&', on the bits of integers; conditions are joined by contacts";
  if (before == '|' && text == "|")
    return "'or' is one '|', on the bits of integers; conditions are joined by contacts";
  const auto is_hexadecimal = [](char c) { return IsDigit(c) || (Upper(c) >= 'A' && Upper(c) <= 'F'); };
  const auto digits = [&](std::string_view part) { return !part.empty() && std::ranges::all_of(part, is_hexadecimal); };
  const bool c_form = before == '0' && (text.starts_with('x') || text.starts_with('X')) && digits(text.substr(1));
  const bool h_form = IsDigit(before) && !text.empty() && Upper(text.back()) == 'H' &&
                      (text.size() == 1 || digits(text.substr(0, text.size() - 1)));
  if (c_form || h_form) return "a hexadecimal number begins with '$': $FF";
  if (EqualIgnoringCase(text, "AND")) return "'and' is '&', on the bits of integers";
  if (EqualIgnoringCase(text, "OR")) return "'or' is '|', on the bits of integers";
  if (text == "%" || EqualIgnoringCase(text, "MOD")) return "there is no remainder: %W3 - %W3 / 10 * 10";
  return {};
}

/// The rest of the statement must be empty.
void ExpressionReader::CloseExpression(bool quoted) {
  if (quoted && !TakeIf(TokenKind::kQuote)) return FaultOfExpression("the end of the expression");
  if (At(TokenKind::kEnd)) return;
  quoted ? ExpectEnd() : FaultOfExpression("an operator or the end of the statement");
}

Operand ExpressionReader::ReadComparison() {
  expression_of_ = ExpressionOf::kComparison;
  parentheses_ = expression_operands_ = 0;
  Operand operand{.type = Type::kBit, .role = OperandRole::kComparison, .range = Peek().range};
  const bool quoted = TakeIf(TokenKind::kQuote);
  if (AtExpressionEnd()) {
    Fault(Peek().range, diag::Host50OneComparison, "nothing");
    return operand;
  }
  const source::Offset begin = Peek().range.begin;
  const ExprId left = ReadOr();
  const Token relation = Peek();
  const auto kind = RelationOf(relation.kind);
  if (!kind) {
    if (AtExpressionEnd()) Fault({begin, relation.range.begin}, diag::Host50OneComparison, "none");
    FaultOfExpression("a comparison operator");
    return operand;
  }
  Take();
  const ExprId right = ReadOr();
  if (RelationOf(Peek().kind)) Fault(Peek().range, diag::Host50OneComparison, "a second one");
  CloseExpression(quoted);
  if (now_.failed) return operand;
  operand.kind = OperandKind::kExpression;
  operand.range = {begin, program_.exprs[right].range.end};
  operand.expr =
      program_.exprs.Add({.kind = *kind, .type = Type::kBit, .left = left, .right = right, .range = operand.range});
  return operand;
}

void ExpressionReader::ReadAssignment(std::vector<Operand>& operands) {
  expression_of_ = ExpressionOf::kAssignment;
  parentheses_ = expression_operands_ = 0;
  const bool quoted = TakeIf(TokenKind::kQuote);
  size_t assign = 0;
  while (Peek(assign).kind != TokenKind::kEnd && Peek(assign).kind != TokenKind::kEquals &&
         Peek(assign).kind != TokenKind::kAssign && !IsBad(Peek(assign).kind)) {
    ++assign;
  }
  if (Peek(assign).kind == TokenKind::kEnd) {
    const std::string found = AtExpressionEnd() ? "nothing" : "no '='";
    Fault(assign == 0 ? now_.range : source::Range{Peek().range.begin, now_.tokens.back().range.end},
          diag::Host50Assignment, found);
    return;
  }
  if (At(TokenKind::kEquals) || At(TokenKind::kAssign) || At(TokenKind::kOpenParenthesis)) {
    return FaultOfExpression("a destination");
  }
  operands.push_back(operands_.ReadOperand(OperandRole::kNumberResult));
  if (!TakeIf(TokenKind::kEquals) && !TakeIf(TokenKind::kAssign)) {
    if (RelationOf(Peek().kind)) Fault(Peek().range, diag::Host50Assignment, "a comparison");
    return FaultOfExpression("'='");
  }
  Operand value{.role = OperandRole::kAssignment};
  value.expr = ReadOr();
  if (RelationOf(Peek().kind)) Fault(Peek().range, diag::Host50Assignment, "a comparison");
  CloseExpression(quoted);
  value.kind = now_.failed ? OperandKind::kError : OperandKind::kExpression;
  value.type = program_.exprs[value.expr].type;
  value.range = program_.exprs[value.expr].range;
  operands.push_back(value);
}

ExprId ExpressionReader::AddBinary(ExprKind kind, ExprId left, ExprId right, const Token& op) {
  const Expr& a = program_.exprs[left];
  const Expr& b = program_.exprs[right];
  const source::Range range = {a.range.begin, b.range.end};
  const bool is_float = a.type == Type::kFloat || b.type == Type::kFloat;
  if (is_float && (kind == ExprKind::kAnd || kind == ExprKind::kOr)) {
    Fault(op.range, diag::Host50IntegerOperator, TextOf(op));
    return ErrorExpr(range);
  }
  const bool unknown = a.type == Type::kUnknown || b.type == Type::kUnknown;
  const Type type = unknown ? Type::kUnknown : is_float ? Type::kFloat : Type::kInteger;
  return program_.exprs.Add({.kind = kind, .type = type, .left = left, .right = right, .range = range});
}

ExprId ExpressionReader::ReadOr() {
  ExprId left = ReadAnd();
  while (!now_.failed && At(TokenKind::kBar)) {
    const Token op = Take();
    left = AddBinary(ExprKind::kOr, left, ReadAnd(), op);
  }
  return left;
}

ExprId ExpressionReader::ReadAnd() {
  ExprId left = ReadSum();
  while (!now_.failed && At(TokenKind::kAmpersand)) {
    const Token op = Take();
    left = AddBinary(ExprKind::kAnd, left, ReadSum(), op);
  }
  return left;
}

ExprId ExpressionReader::ReadSum() {
  ExprId left = ReadProduct();
  while (!now_.failed && (At(TokenKind::kPlus) || At(TokenKind::kMinus))) {
    const Token op = Take();
    left = AddBinary(op.kind == TokenKind::kPlus ? ExprKind::kAdd : ExprKind::kSubtract, left, ReadProduct(), op);
  }
  return left;
}

ExprId ExpressionReader::ReadProduct() {
  ExprId left = ReadUnary();
  while (!now_.failed && (At(TokenKind::kStar) || At(TokenKind::kSlash))) {
    const Token op = Take();
    left = AddBinary(op.kind == TokenKind::kStar ? ExprKind::kMultiply : ExprKind::kDivide, left, ReadUnary(), op);
  }
  return left;
}

ExprId ExpressionReader::ReadUnary() {
  if (!At(TokenKind::kPlus) && !At(TokenKind::kMinus)) return ReadPrimary();
  const Token sign = Take();
  if (At(TokenKind::kPlus) || At(TokenKind::kMinus)) {
    Fault(Peek().range, diag::Host50ExpressionSign);
    return ErrorExpr(sign.range);
  }
  if (AtNumber()) return ReadSignedConstant(sign);
  const ExprId operand = ReadPrimary();
  const Expr& expr = program_.exprs[operand];
  if (sign.kind == TokenKind::kPlus || now_.failed) return operand;
  return program_.exprs.Add(
      {.kind = ExprKind::kNegate, .type = expr.type, .left = operand, .range = {sign.range.begin, expr.range.end}});
}

/// A sign and a literal are one constant; only so 2147483648 is one.
ExprId ExpressionReader::ReadSignedConstant(const Token& sign) {
  const Token token = Take();
  return AddConstant(token, {sign.range.begin, token.range.end}, sign.kind == TokenKind::kMinus);
}

ExprId ExpressionReader::AddConstant(const Token& token, source::Range range, bool negative) {
  if (++expression_operands_ > kMostOperandsOfExpression) Fault(range, diag::Host50ExpressionTooLarge);
  constexpr uint32_t kFloatSign = 0x8000'0000;
  if (token.kind == TokenKind::kFloat) {
    const auto bits = FloatBitsOf(token, TextOf(token));
    if (!bits) {
      Fault(range, diag::Host50FloatRange, TextOf(range));
      return ErrorExpr(range);
    }
    return program_.exprs.Add({.kind = ExprKind::kConstant,
                               .type = Type::kFloat,
                               .bits = negative ? *bits ^ kFloatSign : *bits,
                               .range = range});
  }
  constexpr int64_t kLeast = int64_t{1} << 31;  // its negative fits
  Integer integer = IntegerOf(token, TextOf(token));
  if (negative && token.kind == TokenKind::kInteger && integer.value == kLeast) integer.fits = true;
  if (!integer.fits) {
    Fault(range, diag::Host50IntegerRange, TextOf(range));
    return ErrorExpr(range);
  }
  return program_.exprs.Add({.kind = ExprKind::kConstant,
                             .type = Type::kInteger,
                             .bits = static_cast<uint32_t>(negative ? -integer.value : integer.value),
                             .range = range});
}

ExprId ExpressionReader::ReadPrimary() {
  const Token token = Peek();
  if (AtNumber()) {
    Take();
    return AddConstant(token, token.range, false);
  }
  if (At(TokenKind::kOpenParenthesis)) return ReadParenthesis();
  if (!At(TokenKind::kAddress) && !At(TokenKind::kWord) && !At(TokenKind::kQuotedSymbol)) {
    FaultOfExpression("an operand");
    return ErrorExpr(token.range);
  }
  if (++expression_operands_ > kMostOperandsOfExpression) Fault(token.range, diag::Host50ExpressionTooLarge);
  SymbolReader::Resolved resolved = symbols_.ReadAddress();
  if (!resolved.ok) return ErrorExpr(token.range);
  Type type = TypeOf(resolved.address);
  if (type == Type::kTimer || type == Type::kCounter) resolved.address.attribute = Attribute::kQ;
  if (type != Type::kFloat) type = Type::kInteger;
  return program_.exprs.Add({.kind = ExprKind::kAddress,
                             .type = type,
                             .address = resolved.address,
                             .symbol = resolved.symbol,
                             .range = token.range});
}

ExprId ExpressionReader::ReadParenthesis() {
  const Token open = Take();
  if (++parentheses_ > kMostParentheses) {
    Fault(open.range, diag::Host50ExpressionTooLarge);
    return ErrorExpr(open.range);
  }
  const ExprId inner = ReadOr();
  --parentheses_;
  if (now_.failed) return inner;
  if (RelationOf(Peek().kind)) {
    if (expression_of_ == ExpressionOf::kComparison) {
      Fault(Peek().range, diag::Host50OneComparison, "one in parentheses");
    } else {
      Fault(Peek().range, diag::Host50Assignment, "a comparison");
    }
    return inner;
  }
  const source::Offset end = Peek().range.end;
  if (!TakeIf(TokenKind::kCloseParenthesis)) {
    FaultOfExpression("')'");
    return inner;
  }
  program_.exprs[inner].range = {open.range.begin, end};
  return inner;
}

}  // namespace plcxx::host50
