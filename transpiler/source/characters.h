// What the characters of a text are, beyond ASCII: letters, digits, columns of a monospace display.
//
// Not its job: encodings (decode.h), what a terminal can be shown (diagnostics/terminal_text.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "transpiler/support/hex.h"

namespace plcxx::source {

struct CodePoint {
  char32_t value = 0;
  uint32_t length = 1;  // in bytes
};
/// The first character of `text`, which is not empty; a byte that is not UTF-8 stands for itself.
CodePoint FirstCodePoint(std::string_view text);
size_t CountCodePoints(std::string_view text);
/// "U+0410": as messages name a character that may have no picture.
inline std::string CodePointName(char32_t c) { return "U+" + support::HexDigits(c, 4, support::HexLetters::kCapital); }

/// Unicode category L.
bool IsLetter(char32_t c);
/// Unicode category M: marks that belong to the letter before.
bool IsMark(char32_t c);
/// Unicode category N.
bool IsNumber(char32_t c);

/// A text of any script in ASCII letters, as far as they say it: "пила" is "pila"; '_' for what has no letters.
std::string InLatinLetters(std::string_view text);

/// Columns of a monospace display: 2 for East Asian wide and fullwidth characters (UAX #11), 0 for combining marks.
uint32_t DisplayWidth(char32_t c);

}  // namespace plcxx::source
