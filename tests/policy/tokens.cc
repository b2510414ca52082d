#include "tests/policy/tokens.h"

namespace plcxx::policy {
namespace {

/// The end of a string or character literal that begins at `at`.
size_t EndOfLiteral(const std::string& text, size_t at) {
  const bool raw = text[at] == '"' && at > 0 && text[at - 1] == 'R';
  if (raw) {
    const size_t open = text.find('(', at);
    const std::string close = ")" + text.substr(at + 1, open - at - 1) + "\"";
    const size_t end = text.find(close, open);
    return end == std::string::npos ? text.size() : end + close.size();
  }
  const char quote = text[at];
  for (size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      return i + 1;
    }
  }
  return text.size();
}

}  // namespace

std::vector<Token> TokensOf(const std::string& text) {
  std::vector<Token> tokens;
  size_t line = 1;
  bool line_begins = true;
  const auto skip_to = [&](size_t& at, size_t end) {
    for (; at < end && at < text.size(); ++at) line += text[at] == '\n' ? 1 : 0;
  };
  for (size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '\n') {
      line_begins = true;
      skip_to(at, at + 1);
    } else if (c == ' ' || c == '\t' || c == '\r') {
      ++at;
    } else if (text.compare(at, 2, "//") == 0) {
      skip_to(at, text.find('\n', at));
    } else if (text.compare(at, 2, "/*") == 0) {
      skip_to(at, text.find("*/", at) + 2);
    } else if (c == '#' && line_begins) {
      size_t end = text.find('\n', at);
      while (end != std::string::npos && text[end - 1] == '\\') end = text.find('\n', end + 1);
      skip_to(at, end);
    } else if (c == '"' || (c == '\'' && (at == 0 || !IsWord(text[at - 1])))) {  // 1'000 is a number
      line_begins = false;
      skip_to(at, EndOfLiteral(text, at));
    } else if (IsWord(c)) {
      line_begins = false;
      const size_t begin = at;
      while (at < text.size() && IsWord(text[at])) ++at;
      tokens.push_back({text.substr(begin, at - begin), line});
    } else {
      line_begins = false;
      const size_t length = text.compare(at, 2, "::") == 0 ? 2 : 1;
      tokens.push_back({text.substr(at, length), line});
      at += length;
    }
  }
  return tokens;
}

}  // namespace plcxx::policy
