#include "transpiler/source/characters.h"

#include <unicode/uchar.h>

#include "transpiler/source/decode.h"

namespace plcxx::source {

CodePoint FirstCodePoint(std::string_view text) {
  constexpr unsigned char kFirstByteMask[] = {0x7F, 0x1F, 0x0F, 0x07};
  const size_t length = Utf8Length(text, 0);
  const auto first = static_cast<unsigned char>(text[0]);
  if (length == 0) return {first, 1};
  CodePoint point{static_cast<char32_t>(first & kFirstByteMask[length - 1]), static_cast<uint32_t>(length)};
  for (const char c : text.substr(1, length - 1)) {
    point.value = point.value << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  }
  return point;
}

size_t CountCodePoints(std::string_view text) {
  size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(FirstCodePoint(text).length);
    ++count;
  }
  return count;
}

bool IsLetter(char32_t c) { return (U_GET_GC_MASK(static_cast<UChar32>(c)) & U_GC_L_MASK) != 0; }
bool IsMark(char32_t c) { return (U_GET_GC_MASK(static_cast<UChar32>(c)) & U_GC_M_MASK) != 0; }
bool IsNumber(char32_t c) { return (U_GET_GC_MASK(static_cast<UChar32>(c)) & U_GC_N_MASK) != 0; }

uint32_t DisplayWidth(char32_t c) {
  // ASCII without a look into ICU's tables: it is nearly all there is.
  if (c < 0x7F) return 1;
  if ((U_GET_GC_MASK(static_cast<UChar32>(c)) & (U_GC_MN_MASK | U_GC_ME_MASK)) != 0) return 0;
  const int32_t width = u_getIntPropertyValue(static_cast<UChar32>(c), UCHAR_EAST_ASIAN_WIDTH);
  return width == U_EA_WIDE || width == U_EA_FULLWIDTH ? 2 : 1;
}

}  // namespace plcxx::source
