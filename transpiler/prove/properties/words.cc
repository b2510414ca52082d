#include "transpiler/prove/properties/words.h"

namespace plcxx::prove::properties {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

bool IsBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// The sign at the beginning of `text`, or nothing.
std::string_view SignAt(std::string_view text) {
  for (const std::string_view sign : {"!=", "<>", "<=", ">=", "==", "..", "=", "<", ">", "(", ")", ","}) {
    if (text.starts_with(sign)) return text.substr(0, sign.size());
  }
  return {};
}

/// Where a word ends that begins at `begin`: before a blank or a sign; ".." ends numbers only, so that a name may hold
/// any point.
size_t EndOfWord(std::string_view line, size_t begin) {
  const bool is_number = IsDigit(line[begin]) || line[begin] == '-' || line[begin] == '+';
  size_t end = begin;
  while (end < line.size() && !IsBlank(line[end])) {
    const std::string_view sign = SignAt(line.substr(end));
    if (!sign.empty() && end > begin && (sign != ".." || is_number)) break;
    ++end;
  }
  return end;
}

}  // namespace

PropertyLine SplitProperty(std::string_view line) {
  PropertyLine split;
  size_t at = 0, text_end = 0, text_begin = line.size();
  while (at < line.size()) {
    if (IsBlank(line[at])) {
      ++at;
      continue;
    }
    if (line[at] == '#' && (at == 0 || IsBlank(line[at - 1]))) break;
    PropertyWord word{.text = {}, .column = static_cast<uint32_t>(at + 1)};
    size_t end = at;
    if (line[at] == '\'') {
      const size_t close = line.find('\'', at + 1);
      split.unclosed = close == std::string_view::npos;
      end = split.unclosed ? line.size() : close + 1;
      word.text = line.substr(at + 1, split.unclosed ? std::string_view::npos : close - at - 1);
      word.quoted = true;
    } else {
      const std::string_view sign = SignAt(line.substr(at));
      end = sign.empty() ? EndOfWord(line, at) : at + sign.size();
      word.text = line.substr(at, end - at);
    }
    word.length = static_cast<uint32_t>(end - at);
    text_begin = split.words.empty() ? at : text_begin;
    text_end = end;
    split.words.push_back(std::move(word));
    at = end;
  }
  if (!split.words.empty()) split.text = line.substr(text_begin, text_end - text_begin);
  split.words.push_back(
      {.text = {}, .column = static_cast<uint32_t>(text_end + 1), .length = 1, .quoted = false, .is_end = true});
  return split;
}

}  // namespace plcxx::prove::properties
