// Bytes of a file to UTF-8. Nothing here fails: what an encoding does not define becomes U+FFFD.
//
// In: the bytes of the text, without BOM and without what follows 1AH. Out: UTF-8 and where it was replaced.
// Not its job: to find out which encoding it is (detect.h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::source {

/// What stands for bytes that mean nothing: U+FFFD in UTF-8.
inline constexpr std::string_view kReplacementUtf8 = "\xEF\xBF\xBD";

bool IsAscii(std::string_view bytes);

/// The length of the character that begins at bytes[at]; 0 where the bytes are not well-formed UTF-8 (overlong forms,
/// surrogates, values above 10FFFF and characters cut off by the end of the text are not).
size_t Utf8Length(std::string_view bytes, size_t at);
bool IsValidUtf8(std::string_view bytes);

struct Decoded {
  std::string text;
  std::vector<uint32_t> replaced;  // offsets into text of the U+FFFD that stand for one byte each
};

/// By whichever of the following fits.
Decoded Decode(std::string_view bytes, Encoding encoding);

/// Every byte that does not belong to a well-formed character becomes one U+FFFD.
Decoded DecodeUtf8(std::string_view bytes);
/// `encoding` is one of the 8-bit encodings: every byte becomes one character.
Decoded DecodeEightBit(std::string_view bytes, Encoding encoding);
/// Every byte that does not belong to a character of GB18030 becomes one U+FFFD; an ASCII byte is never swallowed.
Decoded DecodeGb18030(std::string_view bytes);

/// The bytes of an 8-bit encoding for a text; '?' for what it cannot hold.
std::string EncodeEightBit(std::string_view utf8, Encoding encoding);
/// The bytes of GB18030 for a text; '?' for what it cannot hold and for U+FFFD.
std::string EncodeGb18030(std::string_view utf8);
/// How many bytes of GB18030 a text took that DecodeGb18030 gave; a U+FFFD stood for one.
size_t Gb18030Length(std::string_view utf8);

/// The first byte at or after `at` that is not ASCII; the size where there is none.
size_t SkipAscii(std::string_view bytes, size_t at);

/// What the bytes 80H to FFH mean in an 8-bit encoding, as code points of the basic plane.
const std::array<char16_t, 128>& UpperHalf(Encoding encoding);

}  // namespace plcxx::source
