// Technology tables (.TCH) of TECHNOL controls, for hosts with files: the text of a file to the 1632 bytes of
// TAB_TECHNOL and back.
//
// Implements TECHNOL 5.4 and 9.8 as the compiler does, with one difference: the first fault ends the reading. Nothing
// is written into an image when there is a fault. Hosts without files take the table that was compiled in.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace plcxx {

constexpr size_t kTechnologyTableBytes = 1632;
constexpr size_t kTechnologyTableNameBytes = 16;  // with the zero at its end

/// The number of the fault (1 is TT001, "no $TCH") and its line, from 1 on; number 0: no fault.
struct TechnologyTableFault {
  uint8_t number;
  uint32_t line;
};

namespace technology_tables {

constexpr size_t kFirstItem = 32;
constexpr uint32_t kMostColumns = 20;
constexpr uint32_t kMostRows = 400;
constexpr uint32_t kMostItems = 400;

constexpr bool IsBlank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\r' || c == '\n';
}
constexpr bool IsDigit(char c) noexcept { return c >= '0' && c <= '9'; }
constexpr bool IsSign(char c) noexcept { return c == '+' || c == '-'; }

struct Word {
  const char* text;
  size_t size;  // 0: the text has ended
  uint32_t line;
};

constexpr bool IsNumber(const Word& word) noexcept {
  for (size_t i = 0; i < word.size; ++i) {
    if (!IsDigit(word.text[i])) return false;
  }
  return word.size > 0;
}

/// One to three digits and a ':'.
constexpr bool IsRowNumber(const Word& word) noexcept {
  return word.size >= 2 && word.size <= 4 && word.text[word.size - 1] == ':' &&
         IsNumber({word.text, word.size - 1, word.line});
}

constexpr uint32_t ValueOf(const Word& word) noexcept {
  constexpr uint32_t kTooLarge = 100000;
  uint32_t value = 0;
  for (size_t i = 0; i < word.size && IsDigit(word.text[i]); ++i) {
    value = value * 10 + static_cast<uint32_t>(word.text[i] - '0');
    if (value > kTooLarge) value = kTooLarge;
  }
  return value;
}

/// A sign or none, digits, a point or none, digits.
constexpr bool IsItem(const char* text, size_t size) noexcept {
  size_t at = size > 0 && IsSign(text[0]) ? 1 : 0;
  size_t digits = 0;
  bool point = false;
  for (; at < size; ++at) {
    if (IsDigit(text[at])) {
      ++digits;
    } else if (text[at] == '.' && !point) {
      point = true;
    } else {
      return false;
    }
  }
  return digits > 0;
}

/// The number of the fault of an item; 0: `value` is its packed BCD with the sign in bit 31.
constexpr uint8_t ReadItem(const Word& word, uint32_t& value) noexcept {
  if (!IsItem(word.text, word.size)) {
    for (size_t i = 1; i < word.size; ++i) {
      if (IsSign(word.text[i])) return IsItem(word.text, i) ? 11 : 10;
    }
    return 10;
  }
  size_t at = IsSign(word.text[0]) ? 1 : 0;
  size_t integers = 0, decimals = 0;
  value = 0;
  for (; at < word.size && word.text[at] != '.'; ++at, ++integers) {
    value = value << 4 | static_cast<uint32_t>(word.text[at] - '0');
  }
  for (++at; at < word.size; ++at, ++decimals) value = value << 4 | static_cast<uint32_t>(word.text[at] - '0');
  if (integers > 5 || decimals > 3) return 12;
  for (; decimals < 3; ++decimals) value <<= 4;
  if ((value & 0x80000000u) != 0) return 12;
  if (word.text[0] == '-' && value != 0) value |= 0x80000000u;
  return 0;
}

/// The words of a text, one after the other.
struct Scanner {
  const char* text;
  size_t size;
  size_t at;
  uint32_t line;
  uint32_t last_line;  // the last one that is not blank

  constexpr void Advance() noexcept {
    const char c = text[at++];
    if (c == '\n' || (c == '\r' && !(at < size && text[at] == '\n'))) ++line;
    if (!IsBlank(c)) last_line = line;
  }
  constexpr Word Next() noexcept {
    while (at < size) {
      const char c = text[at];
      if (IsBlank(c)) {
        Advance();
      } else if (c == ';' || c == '"') {
        Advance();
        while (at < size && text[at] != '\r' && text[at] != '\n' && !(c == '"' && text[at] == '"')) Advance();
        if (at < size && text[at] == '"') Advance();
      } else {
        Word word = {text + at, 0, line};
        while (at < size && !IsBlank(text[at]) && text[at] != ';' && text[at] != '"') {
          ++word.size;
          Advance();
          if (word.text[word.size - 1] == ':') break;
        }
        return word;
      }
    }
    return {nullptr, 0, last_line};
  }
};

/// Reads rows; what is faulty ends the reading.
struct Reader {
  Scanner scanner;
  Word word, behind;
  uint32_t columns, rows;

  constexpr void Take() noexcept {
    word = behind;
    behind = scanner.Next();
  }
  constexpr bool AtEnd() const noexcept { return word.size == 0; }
  /// Where something is missing at the end of the text: its last line.
  constexpr uint32_t Line() const noexcept { return AtEnd() ? scanner.last_line : word.line; }
  constexpr bool IsColonAstray() const noexcept {
    const bool torn = IsNumber(word) && behind.size == 1 && behind.text[0] == ':';
    return torn || (word.text[word.size - 1] == ':' && !IsRowNumber(word));
  }

  constexpr TechnologyTableFault ReadHeader(uint32_t keyword_line, bool glued) noexcept {
    if (glued || AtEnd()) return {2, AtEnd() ? keyword_line : word.line};
    if (!IsNumber(word) || ValueOf(word) != 1) return {2, word.line};
    uint32_t line = word.line;
    Take();
    if (AtEnd()) return {3, line};
    columns = ValueOf(word);
    if (!IsNumber(word) || columns < 1 || columns > kMostColumns) return {3, word.line};
    line = word.line;
    Take();
    if (AtEnd()) return {4, line};
    rows = ValueOf(word);
    if (!IsNumber(word) || rows < 1 || rows > kMostRows) return {4, word.line};
    Take();
    if (columns * rows > kMostItems) return {5, keyword_line};
    return {0, 0};
  }

  constexpr TechnologyTableFault ReadAll(uint32_t keyword_line, bool glued, uint8_t* image) noexcept {
    Take();
    Take();
    const TechnologyTableFault fault = ReadHeader(keyword_line, glued);
    return fault.number != 0 ? fault : ReadRows(image);
  }

  constexpr TechnologyTableFault ReadRows(uint8_t* image) noexcept {
    for (uint32_t row = 0; row < rows; ++row) {
      if (AtEnd()) return {13, Line()};
      if (!IsRowNumber(word)) return {6, word.line};
      if (ValueOf(word) != row) return {7, word.line};
      Take();
      for (uint32_t column = 0; column < columns; ++column) {
        if (AtEnd() || IsRowNumber(word)) return {8, Line()};
        if (IsColonAstray()) return {6, word.line};
        uint32_t value = 0;
        const uint8_t fault = ReadItem(word, value);
        if (fault != 0) return {fault, word.line};
        for (size_t i = 0; image != nullptr && i < 4; ++i) {
          image[kFirstItem + (row * columns + column) * 4 + i] = static_cast<uint8_t>(value >> (8 * i));
        }
        Take();
      }
      if (AtEnd() || IsRowNumber(word)) continue;
      if (IsColonAstray()) return {6, word.line};
      if (IsItem(word.text, word.size)) return {9, word.line};
      return {static_cast<uint8_t>(row + 1 == rows ? 14 : 6), word.line};
    }
    if (AtEnd()) return {0, 0};
    return {static_cast<uint8_t>(IsColonAstray() ? 6 : 14), word.line};
  }
};

/// Collects a text; counts what does not fit.
struct Writer {
  char* out;
  size_t capacity;
  size_t size;

  constexpr void Put(char c) noexcept {
    if (size < capacity) out[size] = c;
    ++size;
  }
  constexpr void Put(const char* text, size_t count) noexcept {
    for (size_t i = 0; i < count; ++i) Put(text[i]);
  }
  constexpr void PutNumber(uint32_t value, uint32_t least_digits) noexcept {
    uint32_t power = 1, digits = 1;
    while (value / power >= 10 || digits < least_digits) power *= 10, ++digits;
    for (; power > 0; power /= 10) Put(static_cast<char>('0' + value / power % 10));
  }
  /// Right-aligned in 11 columns.
  constexpr void PutItem(uint32_t item) noexcept {
    const uint32_t magnitude = item & 0x7FFFFFFFu;
    uint32_t digits = 4;
    while (digits < 8 && (magnitude >> (4 * digits)) != 0) ++digits;
    const bool negative = item != magnitude && magnitude != 0;
    for (uint32_t i = digits + 1 + (negative ? 1 : 0); i < 11; ++i) Put(' ');
    if (negative) Put('-');
    for (uint32_t i = digits; i-- > 0;) {
      const uint32_t digit = magnitude >> (4 * i) & 0xFu;
      Put(static_cast<char>(digit < 10 ? '0' + digit : 'A' + digit - 10));
      if (i == 3) Put('.');
    }
  }
};

constexpr uint32_t WordAt(const uint8_t* image, size_t offset) noexcept {
  return image[offset] | static_cast<uint32_t>(image[offset + 1]) << 8;
}

}  // namespace technology_tables

/// The bytes in front of "$TCH", which writing back keeps; `size` when there is no "$TCH".
constexpr size_t TechnologyTablePreamble(const char* text, size_t size) noexcept {
  for (size_t i = 0; i + 4 <= size; ++i) {
    if (text[i] == '$' && text[i + 1] == 'T' && text[i + 2] == 'C' && text[i + 3] == 'H') return i;
  }
  return size;
}

/// Reads the text of a file whose name, without directories, is `name` (a string of C) into the 1632 bytes of
/// TAB_TECHNOL: header, items and TCH_AKTIV = 1, for the PLC to take over.
constexpr TechnologyTableFault ReadTechnologyTable(const char* text, size_t size, const char* name,
                                                   uint8_t* image) noexcept {
  using namespace technology_tables;
  size_t name_size = 0;
  while (name[name_size] != '\0') ++name_size;
  if (name_size >= kTechnologyTableNameBytes) return {15, 1};
  for (size_t i = 0; i < size; ++i) {
    if (text[i] == '\x1A') size = i;  // the end of a file of DOS
  }
  bool blank = true;
  for (size_t i = 0; i < size; ++i) blank = blank && IsBlank(text[i]);
  if (blank) return {16, 1};
  const size_t keyword = TechnologyTablePreamble(text, size);
  if (keyword == size) return {1, 1};

  Scanner start = {text, size, 0, 1, 1};
  while (start.at < keyword) start.Advance();
  const uint32_t keyword_line = start.line;
  while (start.at < keyword + 4) start.Advance();
  const bool glued = start.at < size && !IsBlank(text[start.at]) && text[start.at] != ';' && text[start.at] != '"';
  // Once to check, once to write: nothing is written unless all of it is right.
  Reader reader = {start, {}, {}, 0, 0};
  const TechnologyTableFault fault = reader.ReadAll(keyword_line, glued, nullptr);
  if (fault.number != 0) return fault;
  for (size_t i = 0; i < kTechnologyTableBytes; ++i) image[i] = 0;
  reader = {start, {}, {}, 0, 0};
  reader.ReadAll(keyword_line, glued, image);
  image[0] = 1;
  image[2] = static_cast<uint8_t>(reader.columns);
  image[4] = static_cast<uint8_t>(reader.rows);
  image[5] = static_cast<uint8_t>(reader.rows >> 8);
  image[6] = image[7] = 0xFF;  // no row is chosen
  image[8] = 1;
  for (size_t i = 0; i < name_size; ++i) {
    image[16 + i] = static_cast<uint8_t>(name[i] >= 'a' && name[i] <= 'z' ? name[i] - 'a' + 'A' : name[i]);
  }
  return {0, 0};
}

/// Writes the table that the 1632 bytes hold after the preamble of its old file. The result is the size of the text;
/// what does not fit into `capacity` is left out.
constexpr size_t WriteTechnologyTable(const uint8_t* image, const char* preamble, size_t preamble_size, char* out,
                                      size_t capacity) noexcept {
  using namespace technology_tables;
  Writer writer = {out, capacity, 0};
  char end[2] = {'\r', '\n'};
  size_t end_size = 2;
  for (size_t i = preamble_size; i-- > 0;) {
    if (preamble[i] != '\r' && preamble[i] != '\n') continue;
    if (preamble[i] == '\r' || i == 0 || preamble[i - 1] != '\r') {
      end[0] = preamble[i];
      end_size = 1;
    }
    break;
  }
  uint32_t columns = WordAt(image, 2), rows = WordAt(image, 4);
  if (columns > kMostColumns) columns = kMostColumns;
  if (columns == 0 || rows > kMostItems / columns) rows = columns == 0 ? 0 : kMostItems / columns;
  writer.Put(preamble, preamble_size);
  writer.Put("$TCH ", 5);
  writer.PutNumber(WordAt(image, 0), 1);
  writer.Put(' ');
  writer.PutNumber(columns, 1);
  writer.Put(' ');
  writer.PutNumber(rows, 1);
  writer.Put(end, end_size);
  const uint32_t digits = rows > 100 ? 3 : 2;
  for (uint32_t row = 0; row < rows; ++row) {
    writer.PutNumber(row, digits);
    writer.Put(':');
    for (uint32_t column = 0; column < columns; ++column) {
      if (column > 0 && column % 6 == 0) {
        writer.Put(end, end_size);
        writer.Put("    ", digits + 1);
      }
      const size_t offset = kFirstItem + (row * columns + column) * 4;
      writer.PutItem(WordAt(image, offset) | WordAt(image, offset + 2) << 16);
    }
    writer.Put(end, end_size);
  }
  return writer.size;
}

}  // namespace plcxx
