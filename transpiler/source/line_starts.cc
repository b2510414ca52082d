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

std::vector<uint32_t> FindLineStarts(std::string_view text) {
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
    at += text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n' ? 2 : 1;
    starts.push_back(static_cast<uint32_t>(at));
  }
  return starts;
}

}  // namespace plcxx::source
