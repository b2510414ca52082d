// Text of unknown origin made safe for a terminal and measured in its columns.
//
// A source may hold escape sequences, controls and invisible or direction-changing characters; none of them reaches the
// terminal, each is shown by its number instead.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::diag {

/// One character as it is shown.
struct Cell {
  std::string text;
  uint32_t width = 1;  // columns: 2 for wide characters, 0 for marks that sit on the character before
  size_t begin = 0;    // the byte of the source text at which it starts
};

/// `text` is (mostly) UTF-8; bytes that are not are shown by their value. A tab becomes blanks up to the next column
/// that is a multiple of 8.
std::vector<Cell> CellsOf(std::string_view text);

/// The same as one string, for messages and paths.
std::string Escaped(std::string_view text);

/// The same for a text of several lines: the line feeds stay.
std::string EscapedLines(std::string_view text);

/// JSON in which the same characters are written as \uXXXX: they can stand inside of strings only.
std::string JsonForTerminals(std::string_view json);

}  // namespace plcxx::diag
