#include "transpiler/dialects/host50/parser/statement_reader.h"

#include <algorithm>

#include "transpiler/source/characters.h"

namespace plcxx::host50 {
namespace {

constexpr size_t kLongestQuote = 40;  // characters of a text in a message

std::string Quoted(std::string_view text) {
  size_t length = 0;
  for (size_t characters = 0; length < text.size(); ++characters) {
    if (characters == kLongestQuote) return "'" + std::string(text.substr(0, length)) + "...'";
    length += source::FirstCodePoint(text.substr(length)).length;
  }
  return "'" + std::string(text) + "'";
}

}  // namespace

void StatementReader::EnterFile(uint32_t file) {
  now_.file = file;
  now_.source = &sources_.Get(files_[file].file);
}

void StatementReader::Begin(const Line& line) {
  Begin(std::span(files_[now_.file].tokens).subspan(line.tokens.first, line.tokens.count), line.range);
}

void StatementReader::Begin(std::span<const Token> tokens, source::Range statement) {
  now_.tokens = tokens;
  now_.range = statement;
  now_.position = 0;
  now_.failed = false;
}

Token StatementReader::Peek(size_t ahead) const {
  const size_t at = now_.position + ahead;
  if (at < now_.tokens.size()) return now_.tokens[at];
  const source::Offset end = now_.tokens.empty() ? now_.range.end : now_.tokens.back().range.end;
  return {TokenKind::kEnd, {end, end}};
}

Token StatementReader::Take() {
  const Token token = Peek();
  if (now_.position < now_.tokens.size()) ++now_.position;
  return token;
}

bool StatementReader::TakeIf(TokenKind kind) {
  if (!At(kind)) return false;
  Take();
  return true;
}

std::string StatementReader::Found() const {
  return At(TokenKind::kEnd) ? "the end of the statement" : Quoted(TextOf(Peek()));
}

std::string StatementReader::StringOf(const Token& token) const {
  std::string_view text = TextOf(token);
  text = text.substr(1, text.size() - 2);
  std::string value;
  for (size_t i = 0; i < text.size(); ++i) {
    value += text[i];
    if (text[i] == '"') ++i;
  }
  return value;
}

std::string_view StatementReader::WordOf(const Line& line) const {
  if (line.kind != LineKind::kStatement) return {};
  const Token& token = files_[now_.file].tokens[line.tokens.first];
  return token.kind == TokenKind::kWord ? TextOf(token) : std::string_view();
}

char NarrowOf(char32_t point) {
  constexpr char32_t kWideBlank = 0x3000, kFirstWide = 0xFF01, kLastWide = 0xFF5E, kWideDistance = 0xFEE0;
  if (point == kWideBlank) return ' ';
  const bool wide = point >= kFirstWide && point <= kLastWide;
  return wide ? static_cast<char>(point - kWideDistance) : '\0';
}

std::string Narrowed(std::string_view text) {
  std::string narrowed;
  while (!text.empty()) {
    const source::CodePoint point = source::FirstCodePoint(text);
    const char narrow = NarrowOf(point.value);
    narrowed += narrow != '\0' ? std::string_view(&narrow, 1) : text.substr(0, point.length);
    text.remove_prefix(point.length);
  }
  return narrowed;
}

Span StatementReader::AddComments(std::vector<source::Range>& above, source::Range row) {
  Span span{.first = static_cast<uint32_t>(program_.comments.size())};
  for (const source::Range range : above) program_.comments.push_back({range, CommentPlace::kAbove});
  above.clear();
  if (row.end > row.begin) program_.comments.push_back({row, CommentPlace::kRow});
  span.count = static_cast<uint32_t>(program_.comments.size()) - span.first;
  return span;
}

void StatementReader::FaultOfBadCharacter(const Token& token) {
  const std::string_view text = TextOf(token);
  const char32_t point = source::FirstCodePoint(text).value;
  const std::string picture = point < ' ' ? "without a picture" : "'" + std::string(text) + "'";
  const char narrow = NarrowOf(point);
  const bool behind_letter =
      token.range.begin > now_.source->base && IsLetter(now_.source->text[token.range.begin - now_.source->base - 1]);
  const bool behind_digit =
      token.range.begin > now_.source->base && IsDigit(now_.source->text[token.range.begin - now_.source->base - 1]);
  constexpr char32_t kOpeningQuote = 0x201C, kClosingQuote = 0x201D;
  if (point == kOpeningQuote || point == kClosingQuote) {
    Fault(token.range, diag::Host50BadCharacterHint, picture, source::CodePointName(point),
          "a text stands between straight quotes: \"")
        .fixits.push_back({token.range, "\""});
  } else if (narrow != '\0') {
    Fault(token.range, diag::Host50WideCharacter, picture, source::CodePointName(point),
          narrow != ' ' ? "'" + std::string(1, narrow) + "'" : std::string("blank"))
        .fixits.push_back({token.range, std::string(1, narrow)});
  } else if (point == '%' && behind_letter) {
    Fault(token.range, diag::Host50PercentBehindLetter).fixits.push_back({{token.range.begin, token.range.begin}, " "});
  } else if (point == '#' && behind_digit) {
    Fault(token.range, diag::Host50BadCharacterHint, picture, source::CodePointName(point),
          "a hexadecimal number begins with '$': 16#FF is $FF");
  } else if (point == '!' || point == '~') {
    Fault(token.range, diag::Host50BadCharacterHint, picture, source::CodePointName(point),
          "an inverted contact is LDI, ANDI or ORI; 'not equal' is '<>'");
  } else {
    Fault(token.range, diag::Host50BadCharacter, picture, source::CodePointName(point));
  }
}

bool StatementReader::FaultOfBadToken() {
  const Token token = Peek();
  if (!IsBad(token.kind)) return false;
  const source::Range first = {token.range.begin, token.range.begin + 1};
  if (token.kind == TokenKind::kOpenString) {
    Fault(first, diag::Host50StringOpen);
  } else if (token.kind == TokenKind::kOpenQuotedSymbol) {
    Fault(first, diag::Host50QuotedSymbolOpen);
  } else if (std::ranges::binary_search(now_.source->replaced, token.range.begin - now_.source->base)) {
    now_.failed = program_.faulty = true;  // a byte without a character: reported with its line
  } else {
    FaultOfBadCharacter(token);
  }
  return true;
}

void StatementReader::FaultOfMissing(std::string_view what) {
  if (FaultOfBadToken()) return;
  if (TextOf(Peek()) == "!") {
    Fault(Peek().range, diag::Host50OperandForeign, what, Found(), "the inverted contact is LDI, ANDI or ORI");
  } else {
    Fault(Peek().range, diag::Host50OperandExpected, what, Found());
  }
}

void StatementReader::ExpectEnd() {
  if (At(TokenKind::kEnd) || FaultOfBadToken()) return;
  Fault({Peek().range.begin, now_.tokens.back().range.end}, diag::Host50SurplusOperand, Found());
}

}  // namespace plcxx::host50
