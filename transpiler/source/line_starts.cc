#include "transpiler/source/line_starts.h"

#include <cstring>

namespace plcxx::source {
namespace {

constexpr uint64_t kOnes = 0x0101010101010101u;
constexpr uint64_t kHighBits = 0x8080808080808080u;

/// Not zero when one of the eight bytes is `byte` (the classic test for a zero byte, after the XOR).
constexpr uint64_t Holds(uint64_t word, uint64_t byte) {
  const uint64_t zero_where_equal = word ^ (kOnes * byte);
  return (zero_where_equal - kOnes) & ~zero_where_equal & kHighBits;
}

}  // namespace

size_t LineEndLength(std::string_view text, size_t at, LineEnds ends) {
  if (at >= text.size()) return 0;
  const char next = at + 1 < text.size() ? text[at + 1] : '\0';
  if (text[at] == '\n') return ends == LineEnds::kEveryCrAndLf && next == '\r' ? 2 : 1;
  if (text[at] != '\r') return 0;
  if (next == '\n') return 2;
  return ends == LineEnds::kLfOrCrLf ? 0 : 1;
}

std::string_view WithoutLineEnd(std::string_view line, LineEnds ends) {
  for (size_t length = 2; length > 0; --length) {
    if (line.size() < length) continue;
    const size_t text = line.size() - length;
    if (LineEndLength(line, text, ends) == length) return line.substr(0, text);
  }
  return line;
}

std::vector<uint32_t> FindLineStarts(std::string_view text, LineEnds ends) {
  std::vector<uint32_t> starts;
  starts.reserve(text.size() / 24 + 2);
  starts.push_back(0);
  size_t at = 0;
  while (at < text.size()) {
    // Eight bytes at a step as long as no line ends in them.
    while (at + 8 <= text.size()) {
      uint64_t word = 0;
      std::memcpy(&word, text.data() + at, 8);
      if ((Holds(word, '\n') | Holds(word, '\r')) != 0) break;
      at += 8;
    }
    while (at < text.size() && text[at] != '\n' && text[at] != '\r') ++at;
    if (at == text.size()) break;
    const size_t length = LineEndLength(text, at, ends);
    if (length == 0) {
      ++at;
      continue;
    }
    at += length;
    starts.push_back(static_cast<uint32_t>(at));
  }
  return starts;
}

}  // namespace plcxx::source
