#include "transpiler/diagnostics/terminal_text.h"

#include <unicode/uchar.h>
#include <unicode/utf16.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "transpiler/source/characters.h"
#include "transpiler/source/decode.h"

namespace plcxx::diag {
namespace {

constexpr uint32_t kTabStop = 8;

/// Characters that do something instead of showing something: controls, formatting, line and paragraph separators.
bool ActsOnTerminal(UChar32 c) {
  if (c < 0x20 || c == 0x7F) return true;
  if (c < 0x7F) return false;
  return (U_GET_GC_MASK(c) & (U_GC_CC_MASK | U_GC_CF_MASK | U_GC_CS_MASK | U_GC_ZL_MASK | U_GC_ZP_MASK)) != 0;
}

std::string Numbered(const char* format, UChar32 value) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, format, static_cast<unsigned>(value));
  return buffer;
}

Cell Shown(std::string text, size_t begin) {
  const auto width = static_cast<uint32_t>(text.size());
  return {std::move(text), width, begin};
}

}  // namespace

std::vector<Cell> CellsOf(std::string_view text) {
  std::vector<Cell> cells;
  cells.reserve(text.size());
  uint32_t column = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t begin = at;
    const size_t length = source::Utf8Length(text, at);
    at += std::max<size_t>(length, 1);
    const UChar32 c = length == 0 ? 0 : static_cast<UChar32>(source::FirstCodePoint(text.substr(begin)).value);
    if (length == 0) {
      cells.push_back(Shown(Numbered("<%02X>", static_cast<unsigned char>(text[begin])), begin));
    } else if (c == '\t') {
      cells.push_back(Shown(std::string(kTabStop - column % kTabStop, ' '), begin));
    } else if (ActsOnTerminal(c)) {
      cells.push_back(Shown(Numbered("<U+%04X>", c), begin));
    } else {
      cells.push_back(
          {std::string(text.substr(begin, at - begin)), source::DisplayWidth(static_cast<char32_t>(c)), begin});
    }
    column += cells.back().width;
  }
  return cells;
}

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const Cell& cell : CellsOf(text)) escaped += cell.text;
  return escaped;
}

std::string JsonForTerminals(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (size_t at = 0; at < json.size();) {
    const size_t length = std::max<size_t>(source::Utf8Length(json, at), 1);
    const std::string_view character = json.substr(at, length);
    at += length;
    const auto c = static_cast<UChar32>(source::FirstCodePoint(character).value);
    if (c <= 0x7E || !ActsOnTerminal(c)) {
      safe += character;
    } else if (c <= 0xFFFF) {
      safe += Numbered("\\u%04X", c);
    } else {
      safe += Numbered("\\u%04X", U16_LEAD(c)) + Numbered("\\u%04X", U16_TRAIL(c));
    }
  }
  return safe;
}

std::string EscapedLines(std::string_view text) {
  std::string escaped;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    escaped += Escaped(text.substr(begin, end - begin));
    if (end < text.size()) escaped += '\n';
    begin = end + 1;
  }
  return escaped;
}

}  // namespace plcxx::diag
