#include "transpiler/dialects/host50/parser/parser.h"

#include <algorithm>
#include <cstdio>

#include "transpiler/dialects/host50/parser/call_graph.h"
#include "transpiler/dialects/host50/parser/internal.h"
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

std::string CodePointName(char32_t value) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "U+%04X", static_cast<unsigned>(value));
  return buffer;
}

}  // namespace

void Parser::EnterFile(LexedFile& file) { source_ = &sources_.Get(file.file); }

void Parser::Begin(const Line& line) {
  Begin(std::span(files_[file_].tokens).subspan(line.tokens.first, line.tokens.count), line.range);
}

void Parser::Begin(std::span<const Token> tokens, source::Range statement) {
  tokens_ = tokens;
  statement_ = statement;
  position_ = 0;
  failed_ = false;
}

Token Parser::Peek(size_t ahead) const {
  const size_t at = position_ + ahead;
  if (at < tokens_.size()) return tokens_[at];
  const source::Offset end = tokens_.empty() ? statement_.end : tokens_.back().range.end;
  return {TokenKind::kEnd, {end, end}};
}

Token Parser::Take() {
  const Token token = Peek();
  if (position_ < tokens_.size()) ++position_;
  return token;
}

bool Parser::TakeIf(TokenKind kind) {
  if (!At(kind)) return false;
  Take();
  return true;
}

std::string Parser::Found() const { return At(TokenKind::kEnd) ? "the end of the statement" : Quoted(TextOf(Peek())); }

std::string Parser::StringOf(const Token& token) const {
  std::string_view text = TextOf(token);
  text = text.substr(1, text.size() - 2);
  std::string value;
  for (size_t i = 0; i < text.size(); ++i) {
    value += text[i];
    if (text[i] == '"') ++i;
  }
  return value;
}

std::string_view Parser::WordOf(const Line& line) const {
  if (line.kind != LineKind::kStatement) return {};
  const Token& token = files_[file_].tokens[line.tokens.first];
  return token.kind == TokenKind::kWord ? TextOf(token) : std::string_view();
}

char NarrowOf(char32_t point) {
  constexpr char32_t kWideBlank = 0x3000, kFirstWide = 0xFF01, kLastWide = 0xFF5E, kWideDistance = 0xFEE0;
  if (point == kWideBlank) return ' ';
  const bool wide = point >= kFirstWide && point <= kLastWide;
  return wide ? static_cast<char>(point - kWideDistance) : '\0';
}

void Parser::FaultOfBadCharacter(const Token& token) {
  const std::string_view text = TextOf(token);
  const char32_t point = source::FirstCodePoint(text).value;
  const std::string picture = point < ' ' ? "without a picture" : "'" + std::string(text) + "'";
  const char narrow = NarrowOf(point);
  const bool behind_letter =
      token.range.begin > source_->base && IsLetter(source_->text[token.range.begin - source_->base - 1]);
  const bool behind_digit =
      token.range.begin > source_->base && IsDigit(source_->text[token.range.begin - source_->base - 1]);
  if (narrow != '\0') {
    Fault(token.range, diag::Host50WideCharacter, picture, CodePointName(point),
          narrow != ' ' ? "'" + std::string(1, narrow) + "'" : std::string("blank"))
        .fixits.push_back({token.range, std::string(1, narrow)});
  } else if (point == '%' && behind_letter) {
    Fault(token.range, diag::Host50PercentBehindLetter).fixits.push_back({{token.range.begin, token.range.begin}, " "});
  } else if (point == '#' && behind_digit) {
    Fault(token.range, diag::Host50BadCharacterHint, picture, CodePointName(point),
          "a hexadecimal number begins with '$': 16#FF is $FF");
  } else if (point == '!' || point == '~') {
    Fault(token.range, diag::Host50BadCharacterHint, picture, CodePointName(point),
          "an inverted contact is LDI, ANDI or ORI; 'not equal' is '<>'");
  } else {
    Fault(token.range, diag::Host50BadCharacter, picture, CodePointName(point));
  }
}

bool Parser::FaultOfBadToken() {
  const Token token = Peek();
  if (!IsBad(token.kind)) return false;
  const source::Range first = {token.range.begin, token.range.begin + 1};
  if (token.kind == TokenKind::kOpenString) {
    Fault(first, diag::Host50StringOpen);
  } else if (token.kind == TokenKind::kOpenQuotedSymbol) {
    Fault(first, diag::Host50QuotedSymbolOpen);
  } else if (std::ranges::binary_search(source_->replaced, token.range.begin - source_->base)) {
    failed_ = program_.faulty = true;  // a byte without a character: reported with its line
  } else {
    FaultOfBadCharacter(token);
  }
  return true;
}

void Parser::FaultOfMissing(std::string_view what) {
  if (!FaultOfBadToken()) Fault(Peek().range, diag::Host50OperandExpected, what, Found());
}

void Parser::ExpectEnd() {
  if (At(TokenKind::kEnd) || FaultOfBadToken()) return;
  Fault({Peek().range.begin, tokens_.back().range.end}, diag::Host50SurplusOperand, Found());
}

/// E111 for each line with bytes that its encoding does not define, also in comments and texts.
void Parser::ReportUndefinedBytes() {
  constexpr uint32_t kReplacementBytes = 3;  // of U+FFFD
  uint32_t last_line = 0;
  for (const uint32_t at : source_->replaced) {
    const source::Offset begin = source_->base + at;
    const uint32_t line = sources_.Locate(begin).line;
    if (line == last_line) continue;
    last_line = line;
    Report({begin, begin + kReplacementBytes}, diag::Host50UndefinedByte, source::Name(source_->encoding));
  }
}

Program Parser::Run(std::span<const source::FileId> files) {
  program_.files.assign(files.begin(), files.end());
  for (const source::FileId file : files) {
    files_.push_back(Lex(sources_, file));
    program_.line_count += sources_.LineCount(file);
    EnterFile(files_.back());
    for (const Line& line : files_.back().lines) {
      if (line.continuation.rest.end != 0) program_.continuations.push_back(line.continuation);
    }
    ReportUndefinedBytes();
  }
  ReadStructure();
  ReadDirectives();
  ReadTables();
  ReadBodies();
  CheckCalls(program_, diagnostics_);
  return std::move(program_);
}

void PlaceInFirstLines(const Program& program, diag::Engine& diagnostics) {
  if (program.continuations.empty()) return;
  diagnostics.MovePlaces([&](source::Range range) {
    const auto behind = std::ranges::upper_bound(program.continuations, range.begin, {},
                                                 [](const Continuation& lines) { return lines.rest.begin; });
    if (behind == program.continuations.begin()) return range;
    const Continuation& lines = *std::prev(behind);
    return range.begin <= lines.rest.end ? lines.first : range;
  });
}

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files,
              const std::map<std::string, std::string>& options, diag::Engine& diagnostics) {
  return Parser(sources, options, diagnostics).Run(files);
}

}  // namespace plcxx::host50
