#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {
namespace {

std::string_view FirstText(const Statement& statement) {
  return statement.words.empty() ? statement.label->text : statement.first().text;
}

}  // namespace

std::string UpperWord(std::span<const Token> words, size_t index) {
  return index < words.size() && words[index].kind == TokenKind::kWord ? Upper(words[index].text) : std::string();
}

bool StatementReader::IsOutside(const Statement& statement) {
  if (now_.including.size() <= 1) return false;
  context_.Report(statement.range, diag::TechnolCodeInInclude, FirstText(statement));
  return true;
}

bool StatementReader::IsCodePlace(const Statement& statement) {
  if (IsOutside(statement)) return false;
  if (!now_.in_data) return true;
  context_.Report(statement.range, diag::TechnolCodeInData, FirstText(statement));
  return false;
}

bool StatementReader::ExpectEnd(const Statement& statement, size_t words) {
  if (statement.words.size() <= words) return true;
  const Token& surplus = statement.words[words];
  context_.Report(surplus.range, diag::TechnolSurplus, Shown(&surplus), statement.first().text);
  return false;
}

void StatementReader::WarnOfCompletion(const Token& word) {
  if (context_.settings.evidence != EvidenceRule::kStrict) return;
  context_.Report(word.range, diag::TechnolCompletion, word.text);
}

}  // namespace plcxx::technol
