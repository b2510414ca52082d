#include "transpiler/dialects/technol/parser/check_tokens.h"

#include <algorithm>

#include "transpiler/source/characters.h"

namespace plcxx::technol {
namespace {

/// What a character of other languages is in this one, as a remedy; empty: nobody knows.
std::string_view MeantByCharacter(std::string_view character) {
  if (character == "#") return "a constant is written CNST.5, a hexadecimal number 0FFh";
  if (character == "%") return "bits and cells have the names that DATA gives them, without '%'";
  if (character == "!" || character == "~") return "the negated bit is -NAME";
  if (character == "|") return "bits are combined by LO, data by OR";
  if (character == "{" || character == "}") return "a comment begins with ';'";
  return {};
}

/// The characters of the token that may be in comments only, from the first one on; empty: it has none.
std::string_view BadCharacters(const Token& token) {
  if (token.kind == TokenKind::kInvalid) return token.text;
  if (token.kind != TokenKind::kString && token.kind != TokenKind::kQuoted && token.kind != TokenKind::kPath) return {};
  const auto bad = std::ranges::find_if(token.text, [](char c) {
    const auto byte = static_cast<uint8_t>(c);
    return byte >= 0x80U || byte < ' ' || byte == 0x7FU;
  });
  return {bad, token.text.end()};
}

void ReportCharacter(const Token& token, std::string_view bad, ParsingContext& context) {
  const source::CodePoint point = source::FirstCodePoint(bad);
  const std::string_view shown = bad.substr(0, point.length);
  const std::string name = source::CodePointName(point.value);
  const bool printable = static_cast<uint8_t>(shown.front()) >= ' ' && shown.front() != '\x7F';
  const std::string picture = printable ? "'" + std::string(shown) + "'" : "code";
  const std::string_view meant = MeantByCharacter(shown);
  if (meant.empty()) {
    context.Report(token.range, diag::TechnolCharacter, picture, name);
  } else {
    context.Report(token.range, diag::TechnolCharacterHint, picture, name, meant);
  }
}

}  // namespace

bool CheckTokens(std::span<const Token> tokens, ParsingContext& context) {
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::kWord) context.IsShort(token);
    if (const std::string_view bad = BadCharacters(token); !bad.empty()) {
      ReportCharacter(token, bad, context);
      return false;
    }
  }
  const Token& last = tokens.back();
  if (last.kind == TokenKind::kPunctuation && (last.text == "\\" || last.text == "&")) {
    context.Report(last.range, diag::TechnolContinuation, last.text);
    return false;
  }
  return true;
}

}  // namespace plcxx::technol
