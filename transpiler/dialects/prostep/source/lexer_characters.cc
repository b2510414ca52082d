#include <algorithm>

#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {
namespace {

std::string_view SkipBlanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

size_t LettersAt(std::string_view text) {
  return static_cast<size_t>(std::ranges::find_if_not(text, IsLetter) - text.begin());
}

}  // namespace

bool IsBlank(char c) { return c == ' ' || c == '\t'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

std::string Upper(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

std::string_view TrimBlanks(std::string_view text) {
  text = SkipBlanks(text);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

bool IsMarked(std::string_view comment) { return comment.starts_with(';') || comment.starts_with('*'); }

bool IsOperandLike(std::string_view rest) {
  rest = SkipBlanks(rest);
  if (rest.empty()) return false;
  if (IsDigit(rest.front())) return true;
  const size_t letters = LettersAt(rest);
  if (letters == 0 || letters > 2) return false;
  const bool constant = letters == 1 && (rest.front() == 'K' || rest.front() == 'k');
  rest = SkipBlanks(rest.substr(letters));
  return !rest.empty() && (IsDigit(rest.front()) || (constant && rest.front() == '-'));
}

bool LooksLikeOperand(std::string_view rest) {
  rest = SkipBlanks(rest);
  return IsOperandLike(rest) && ClassByName(Upper(rest.substr(0, LettersAt(rest)))) != OperandClass::kNone;
}

}  // namespace plcxx::prostep
