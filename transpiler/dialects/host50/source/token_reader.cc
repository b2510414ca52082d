#include "transpiler/dialects/host50/source/token_reader.h"

#include <algorithm>
#include <utility>

namespace plcxx::host50 {
namespace {

constexpr bool IsAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }
constexpr bool IsHexDigit(char c) { return IsDigit(c) || (Upper(c) >= 'A' && Upper(c) <= 'F'); }

/// What ends a bare symbol or an address among operands.
constexpr bool IsDelimiter(char c) {
  return IsBlank(c) || c == ',' || c == ';' || c == '=' || c == '(' || c == ')' || c == '[' || c == ']' || c == '{' ||
         c == '}';
}

struct Punctuation {
  std::string_view text;
  TokenKind kind;
};
constexpr Punctuation kPunctuation[] = {
    {":=", TokenKind::kAssign},
    {"<=", TokenKind::kLessEqual},
    {">=", TokenKind::kGreaterEqual},
    {"<>", TokenKind::kNotEqual},
    {"<", TokenKind::kLess},
    {">", TokenKind::kGreater},
    {",", TokenKind::kComma},
    {"=", TokenKind::kEquals},
    {"!", TokenKind::kExclamation},
    {"(", TokenKind::kOpenParenthesis},
    {"+", TokenKind::kPlus},
    {"-", TokenKind::kMinus},
    {")", TokenKind::kCloseParenthesis},
    {"*", TokenKind::kStar},
    {"/", TokenKind::kSlash},
    {"&", TokenKind::kAmpersand},
    {"|", TokenKind::kBar},
};

}  // namespace

bool TokenReader::AtContinuation() const {
  return Peek() == '\\' && std::ranges::all_of(text_.substr(at_ + 1, stop_ - at_ - 1), IsBlank);
}

void TokenReader::AddRange(TokenKind kind, size_t begin, size_t end) {
  tokens_.push_back({kind, {base_ + static_cast<source::Offset>(begin), base_ + static_cast<source::Offset>(end)}});
}

bool TokenReader::AtNameStart() const {
  const char c = Peek();
  return IsLetter(c) || c == '_' || (!AtStop() && !IsAscii(c) && source::IsLetter(CodePoint().value));
}

bool TokenReader::AtNameCharacter(Reading reading) const {
  if (AtStop()) return false;
  const char c = Peek();
  if (IsWordCharacter(c)) return true;
  if (!IsAscii(c)) {
    const char32_t point = CodePoint().value;
    return source::IsLetter(point) || source::IsMark(point) || source::IsNumber(point);
  }
  return reading == Reading::kOperands && (c == '+' || c == '-' || c == '/' || c == '.' || c == '#');
}

bool TokenReader::AtOperandEnd() const { return AtStop() || IsDelimiter(Peek()) || AtContinuation(); }

void TokenReader::ReadFirst() {
  if (!IsLetter(Peek())) return ReadOperand();
  const size_t begin = at_;
  while (IsWordCharacter(Peek())) ++at_;
  if (IsAscii(Peek())) return Add(TokenKind::kWord, begin);
  at_ = begin;  // a name in another script: no mnemonic, but one word
  ReadName(Reading::kOperands);
}

void TokenReader::ReadOperand() {
  const bool sign = (Peek() == '+' || Peek() == '-') && StartsNumber(1);
  if (sign || StartsNumber(0)) return ReadNumber(sign ? 1 : 0);
  ReadOther(Reading::kOperands);
}

void TokenReader::ReadExpressionToken() {
  if (StartsNumber(0)) return ReadNumber(0);
  ReadOther(Reading::kExpression);
}

void TokenReader::ReadQuotedExpression() {
  const size_t begin = at_;
  const size_t close = text_.substr(0, stop_).find('"', begin + 1);
  if (close == std::string_view::npos) {
    SkipToStop();
    return Add(TokenKind::kOpenString, begin);
  }
  ++at_;
  Add(TokenKind::kQuote, begin);
  const size_t stop = std::exchange(stop_, close);
  for (SkipBlanks(); !AtStop(); SkipBlanks()) ReadExpressionToken();
  SetBounds(close + 1, stop);
  Add(TokenKind::kQuote, close);
}

void TokenReader::ReadString() {
  const size_t begin = at_++;
  while (!AtStop()) {
    if (Peek() == '"' && Peek(1) != '"') {
      ++at_;
      return Add(TokenKind::kString, begin);
    }
    at_ += Peek() == '"' ? 2 : 1;
  }
  Add(TokenKind::kOpenString, begin);
}

void TokenReader::ReadNumber(size_t sign) {
  const size_t begin = at_;
  at_ += sign;
  bool is_float = false;
  while (IsDigit(Peek())) ++at_;
  if (Peek() == '.') {
    is_float = true;
    ++at_;
    while (IsDigit(Peek())) ++at_;
  }
  const size_t exponent_sign = Peek(1) == '+' || Peek(1) == '-' ? 1 : 0;
  if (Upper(Peek()) == 'E' && IsDigit(Peek(1 + exponent_sign))) {
    is_float = true;
    at_ += 1 + exponent_sign;
    while (IsDigit(Peek())) ++at_;
  }
  Add(is_float ? TokenKind::kFloat : TokenKind::kInteger, begin);
}

void TokenReader::ReadOther(Reading reading) {
  const size_t begin = at_;
  const char c = Peek();
  if (AtNameStart()) return ReadName(reading);
  if (c == '%') return ReadAddress(reading);
  if (c == '"') return ReadString();
  if (c == '\'') return ReadQuotedSymbol();
  if (c == '$' && IsHexDigit(Peek(1))) {
    ++at_;
    while (IsHexDigit(Peek())) ++at_;
    return Add(TokenKind::kHex, begin);
  }
  for (const Punctuation& row : kPunctuation) {
    if (!text_.substr(at_, stop_ - at_).starts_with(row.text)) continue;
    at_ += row.text.size();
    return Add(row.kind, begin);
  }
  at_ += CodePoint().length;
  Add(TokenKind::kCharacter, begin);
}

void TokenReader::ReadAddress(Reading reading) {
  const size_t begin = at_++;
  if (reading == Reading::kExpression) {
    while (IsWordCharacter(Peek()) || Peek() == '.') ++at_;
  } else {
    while (!AtOperandEnd()) ++at_;
  }
  Add(TokenKind::kAddress, begin);
}

void TokenReader::ReadName(Reading reading) {
  const size_t begin = at_;
  while (AtNameCharacter(reading)) at_ += CodePoint().length;
  if (reading == Reading::kExpression) {
    ReadAttribute();
  } else if (!AtOperandEnd()) {
    // The rest of the name is no name: one character is reported, the others go with it.
    const size_t bad = at_;
    const size_t length = CodePoint().length;
    while (!AtOperandEnd()) ++at_;
    return AddRange(TokenKind::kCharacter, bad, bad + length);
  }
  Add(TokenKind::kWord, begin);
}

/// ".Q" after a symbol.
void TokenReader::ReadAttribute() {
  if (Peek() != '.' || !IsLetter(Peek(1))) return;
  ++at_;
  while (IsWordCharacter(Peek())) ++at_;
}

void TokenReader::ReadQuotedSymbol() {
  const size_t begin = at_++;
  const size_t close = text_.substr(0, stop_).find('\'', at_);
  if (close == std::string_view::npos) {
    SkipToStop();
    return Add(TokenKind::kOpenQuotedSymbol, begin);
  }
  const bool starts_well = AtNameStart();
  while (starts_well && at_ < close && AtNameCharacter(Reading::kOperands)) at_ += CodePoint().length;
  const size_t bad = at_;
  const size_t length = CodePoint().length;
  const bool good = starts_well && at_ == close;
  at_ = close + 1;
  ReadAttribute();
  if (good) return Add(TokenKind::kQuotedSymbol, begin);
  AddRange(TokenKind::kCharacter, bad, bad + length);
}

}  // namespace plcxx::host50
