#include "transpiler/source/decode.h"

#include <unicode/ucnv.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "transpiler/source/characters.h"

namespace plcxx::source {
namespace {

constexpr char16_t kReplacement = 0xFFFD;
constexpr uint64_t kNotAscii = 0x8080808080808080u;  // in each of eight bytes

std::string ToUtf8(char16_t unit) {
  const auto byte = [](unsigned value) { return static_cast<char>(value); };
  const unsigned value = unit;
  if (value < 0x80) return {byte(value)};
  if (value < 0x800) return {byte(0xC0 | value >> 6), byte(0x80 | (value & 0x3F))};
  return {byte(0xE0 | value >> 12), byte(0x80 | (value >> 6 & 0x3F)), byte(0x80 | (value & 0x3F))};
}

using UpperTable = std::array<char16_t, 128>;

UpperTable ReadUpperHalf(const char* converter_name) {
  UpperTable table;
  table.fill(kReplacement);
  UErrorCode error = U_ZERO_ERROR;
  UConverter* converter = ucnv_open(converter_name, &error);
  // Without ICU's data nothing can be decoded, but nothing may fail either: all becomes U+FFFD.
  if (U_FAILURE(error)) return table;
  for (unsigned i = 0; i < table.size(); ++i) {
    const char byte = static_cast<char>(0x80 + i);
    char16_t units[4] = {};
    error = U_ZERO_ERROR;
    const int32_t length = ucnv_toUChars(converter, units, 4, &byte, 1, &error);
    // ICU passes an undefined byte (98H of CP1251) through as a C1 control, which no text contains.
    if (U_SUCCESS(error) && length == 1 && units[0] >= 0xA0) table[i] = units[0];
  }
  ucnv_close(converter);
  return table;
}

struct Letter {
  uint8_t byte;
  char16_t letter;
};

/// Where Mazovia is not code page 437 (specification of prostep, appendix B).
constexpr Letter kMazoviaLetters[] = {
    {0x86, u'ą'}, {0x8D, u'ć'}, {0x8F, u'Ą'}, {0x90, u'Ę'}, {0x91, u'ę'}, {0x92, u'ł'},
    {0x95, u'Ć'}, {0x98, u'Ś'}, {0x9C, u'Ł'}, {0x9E, u'ś'}, {0xA0, u'Ź'}, {0xA1, u'Ż'},
    {0xA2, u'ó'}, {0xA3, u'Ó'}, {0xA4, u'ń'}, {0xA5, u'Ń'}, {0xA6, u'ź'}, {0xA7, u'ż'},
};

/// Where KEYBCS2 is not code page 437.
constexpr Letter kKamenickyLetters[] = {
    {0x80, u'Č'}, {0x83, u'ď'}, {0x85, u'Ď'}, {0x86, u'Ť'}, {0x87, u'č'}, {0x88, u'ě'}, {0x89, u'Ě'}, {0x8A, u'Ĺ'},
    {0x8B, u'Í'}, {0x8C, u'ľ'}, {0x8D, u'ĺ'}, {0x8F, u'Á'}, {0x91, u'ž'}, {0x92, u'Ž'}, {0x95, u'Ó'}, {0x96, u'ů'},
    {0x97, u'Ú'}, {0x98, u'ý'}, {0x9B, u'Š'}, {0x9C, u'Ľ'}, {0x9D, u'Ý'}, {0x9E, u'Ř'}, {0x9F, u'ť'}, {0xA4, u'ň'},
    {0xA5, u'Ň'}, {0xA6, u'Ů'}, {0xA7, u'Ô'}, {0xA8, u'š'}, {0xA9, u'ř'}, {0xAA, u'ŕ'}, {0xAB, u'Ŕ'}, {0xAD, u'§'},
};

/// ICU's table is older than this one.
constexpr Letter kCp852Sign[] = {{0xAA, u'¬'}};

UpperTable Over(const char* converter_name, std::span<const Letter> letters) {
  UpperTable table = ReadUpperHalf(converter_name);
  for (const Letter& row : letters) table[row.byte - 0x80u] = row.letter;
  return table;
}

}  // namespace

size_t SkipAscii(std::string_view bytes, size_t at) {
  for (; at + 8 <= bytes.size(); at += 8) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    if ((word & kNotAscii) != 0) break;
  }
  while (at < bytes.size() && static_cast<unsigned char>(bytes[at]) < 0x80) ++at;
  return at;
}

bool IsAscii(std::string_view bytes) { return SkipAscii(bytes, 0) == bytes.size(); }

size_t Utf8Length(std::string_view bytes, size_t at) {
  const auto byte = [&](size_t i) -> unsigned {
    return at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u;
  };
  const auto continues = [&](size_t i) { return (byte(i) & 0xC0) == 0x80; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return continues(1) ? 2 : 0;
  if (first < 0xF0) {
    const unsigned low = first == 0xE0 ? 0xA0 : 0x80;
    const unsigned high = first == 0xED ? 0x9F : 0xBF;
    return byte(1) >= low && byte(1) <= high && continues(2) ? 3 : 0;
  }
  if (first > 0xF4) return 0;
  const unsigned low = first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xF4 ? 0x8F : 0xBF;
  return byte(1) >= low && byte(1) <= high && continues(2) && continues(3) ? 4 : 0;
}

bool IsValidUtf8(std::string_view bytes) {
  for (size_t at = SkipAscii(bytes, 0); at < bytes.size(); at = SkipAscii(bytes, at)) {
    const size_t length = Utf8Length(bytes, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

Decoded DecodeUtf8(std::string_view bytes) {
  Decoded decoded;
  decoded.text.reserve(bytes.size());
  for (size_t at = 0; at < bytes.size();) {
    const size_t ascii_end = SkipAscii(bytes, at);
    decoded.text.append(bytes, at, ascii_end - at);
    at = ascii_end;
    if (at == bytes.size()) break;
    if (const size_t length = Utf8Length(bytes, at); length != 0) {
      decoded.text.append(bytes, at, length);
      at += length;
    } else {
      decoded.replaced.push_back(static_cast<uint32_t>(decoded.text.size()));
      decoded.text += kReplacementUtf8;
      ++at;
    }
  }
  return decoded;
}

Decoded DecodeEightBit(std::string_view bytes, Encoding encoding) {
  const std::array<char16_t, 128>& upper = UpperHalf(encoding);
  std::array<std::string, 128> utf8;
  for (size_t i = 0; i < upper.size(); ++i) utf8[i] = ToUtf8(upper[i]);

  Decoded decoded;
  decoded.text.reserve(bytes.size() + bytes.size() / 2);
  for (size_t at = 0; at < bytes.size(); ++at) {
    const size_t ascii_end = SkipAscii(bytes, at);
    decoded.text.append(bytes, at, ascii_end - at);
    at = ascii_end;
    if (at == bytes.size()) break;
    const size_t index = static_cast<unsigned char>(bytes[at]) - 0x80u;
    if (upper[index] == kReplacement) decoded.replaced.push_back(static_cast<uint32_t>(decoded.text.size()));
    decoded.text += utf8[index];
  }
  return decoded;
}

std::string EncodeEightBit(std::string_view utf8, Encoding encoding) {
  const std::array<char16_t, 128>& upper = UpperHalf(encoding);
  std::string bytes;
  for (size_t at = 0; at < utf8.size();) {
    const CodePoint character = FirstCodePoint(utf8.substr(at));
    at += character.length;
    if (character.value < 0x80) {
      bytes += static_cast<char>(character.value);
      continue;
    }
    const auto found = std::ranges::find(upper, character.value);
    const bool known = found != upper.end() && *found != kReplacement;
    bytes += known ? static_cast<char>(0x80 + (found - upper.begin())) : '?';
  }
  return bytes;
}

const std::array<char16_t, 128>& UpperHalf(Encoding encoding) {
  // Only the upper half is ICU's: its CP866 is IBM's, which exchanges the controls 1AH, 1CH and 7FH.
  // Function-local statics: a converter is opened when a file needs it, never for ASCII and UTF-8.
  switch (encoding) {
    case Encoding::kCp866: {
      static const UpperTable table = ReadUpperHalf("ibm-866_P100-1995");
      return table;
    }
    case Encoding::kCp1251: {
      static const UpperTable table = ReadUpperHalf("windows-1251");
      return table;
    }
    case Encoding::kKoi8R: {
      static const UpperTable table = ReadUpperHalf("KOI8-R");
      return table;
    }
    case Encoding::kMazovia: {
      static const UpperTable table = Over("ibm-437_P100-1995", kMazoviaLetters);
      return table;
    }
    case Encoding::kKamenicky: {
      static const UpperTable table = Over("ibm-437_P100-1995", kKamenickyLetters);
      return table;
    }
    case Encoding::kCp852: {
      static const UpperTable table = Over("ibm-852_P100-1995", kCp852Sign);
      return table;
    }
    case Encoding::kCp1250: {
      static const UpperTable table = ReadUpperHalf("windows-1250");
      return table;
    }
    case Encoding::kGb18030:
    case Encoding::kUtf8:
      break;
  }
  PLCXX_UNREACHABLE();
}

Decoded Decode(std::string_view bytes, Encoding encoding) {
  if (encoding == Encoding::kUtf8) return DecodeUtf8(bytes);
  if (encoding == Encoding::kGb18030) return DecodeGb18030(bytes);
  return DecodeEightBit(bytes, encoding);
}

}  // namespace plcxx::source
