#include "transpiler/dialects/@name@/source/lexer.h"

#include <algorithm>
#include <string>

#include "transpiler/support/check.h"

namespace plcxx::@name@ {
namespace {

constexpr std::string_view kBlanks = " \t";

/// Tokens of the line that begins at `begin`.
void LexLine(std::string_view line, source::Offset begin, std::vector<Token>& tokens) {
  const auto add = [&](TokenKind kind, size_t from, size_t end) {
    tokens.push_back({kind, {begin + static_cast<source::Offset>(from), begin + static_cast<source::Offset>(end)}});
  };
  const size_t comment = std::min(line.find(';'), line.size());
  const std::string_view code = line.substr(0, comment);
  const size_t word = code.find_first_not_of(kBlanks);
  if (word != std::string_view::npos) {
    const size_t word_end = std::min(code.find_first_of(kBlanks, word), code.size());
    add(TokenKind::kWord, word, word_end);
    const size_t operands = code.find_first_not_of(kBlanks, word_end);
    if (operands != std::string_view::npos) add(TokenKind::kOperands, operands, code.find_last_not_of(kBlanks) + 1);
  }
  if (comment < line.size()) add(TokenKind::kComment, comment, line.size());
}

}  // namespace

std::string_view Name(TokenKind kind) {
  switch (kind) {
    case TokenKind::kWord:
      return "word";
    case TokenKind::kOperands:
      return "operands";
    case TokenKind::kComment:
      return "comment";
  }
  PLCXX_UNREACHABLE();
}

std::vector<Token> Lex(const source::SourceManager& sources, source::FileId file) {
  std::vector<Token> tokens;
  const source::File& text = sources.Get(file);
  for (uint32_t line = 1; line <= sources.LineCount(file); ++line) {
    LexLine(sources.Line(file, line), text.base + text.line_starts[line - 1], tokens);
  }
  return tokens;
}

}  // namespace plcxx::@name@
