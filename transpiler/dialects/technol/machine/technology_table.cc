#include "transpiler/dialects/technol/machine/technology_table.h"

#include <algorithm>
#include <cstdio>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/support/hex.h"

namespace plcxx::technol {
namespace {

// Offsets of 5.4.
constexpr uint32_t kVersion = 0;
constexpr uint32_t kColumnsAt = 2;
constexpr uint32_t kRowsAt = 4;
constexpr uint32_t kChoice = 6;
constexpr uint32_t kActive = 8;
constexpr uint32_t kName = 16;
constexpr uint32_t kItemBytes = 4;
constexpr uint32_t kItemsPerLine = 6;
constexpr size_t kItemColumns = 11;
constexpr uint32_t kThreeDigitRows = 100;  // more rows than these have numbers of three digits

void PutWord(TableImage& image, uint32_t offset, uint32_t value) {
  image[offset] = static_cast<uint8_t>(value);
  image[offset + 1] = static_cast<uint8_t>(value >> 8);
}
uint32_t WordAt(const TableImage& image, uint32_t offset) { return image[offset] | uint32_t{image[offset + 1]} << 8; }

uint32_t ItemAt(const TableImage& image, uint32_t index) {
  const uint32_t offset = kTableFirstItem + index * kItemBytes;
  return WordAt(image, offset) | WordAt(image, offset + 2) << 16;
}

std::string LineEndOf(std::string_view preamble) {
  const size_t last = preamble.find_last_of("\r\n");
  if (last == std::string_view::npos) return "\r\n";
  if (preamble[last] == '\r') return "\r";
  return last > 0 && preamble[last - 1] == '\r' ? "\r\n" : "\n";
}

std::string RowText(uint32_t row, uint32_t rows) {
  char text[16];
  std::snprintf(text, sizeof text, rows > kThreeDigitRows ? "%03u:" : "%02u:", row);
  return text;
}

}  // namespace

TableImage EmptyImage() {
  TableImage image{};
  PutWord(image, kChoice, 0xFFFF);
  return image;
}

TableImage ImageOf(const TechnologyTable& table) {
  TableImage image = EmptyImage();
  PutWord(image, kVersion, table.version);
  PutWord(image, kColumnsAt, table.columns);
  PutWord(image, kRowsAt, table.rows);
  image[kActive] = 1;
  std::copy_n(table.name.begin(), std::min<size_t>(table.name.size(), kTableNameBytes - 1), image.begin() + kName);
  for (uint32_t i = 0; i < std::min<size_t>(table.items.size(), kTableItems); ++i) {
    PutWord(image, kTableFirstItem + i * kItemBytes, table.items[i]);
    PutWord(image, kTableFirstItem + i * kItemBytes + 2, table.items[i] >> 16);
  }
  return image;
}

std::string ItemText(uint32_t item) {
  constexpr uint32_t kMagnitude = 0x7FFFFFFF;
  std::string text = support::HexDigits(item & kMagnitude, 4, support::HexLetters::kCapital);
  text.insert(text.size() - 3, ".");
  return item > 0x80000000U ? "-" + text : text;
}

std::string WriteTable(const TableImage& image, std::string_view preamble) {
  const uint32_t columns = std::min(WordAt(image, kColumnsAt), kTableColumns);
  const uint32_t rows = columns == 0 ? 0 : std::min(WordAt(image, kRowsAt), kTableItems / columns);
  const std::string end = LineEndOf(preamble);
  std::string text(preamble);
  text +=
      "$TCH " + std::to_string(WordAt(image, kVersion)) + " " + std::to_string(columns) + " " + std::to_string(rows);
  text += end;
  for (uint32_t row = 0; row < rows; ++row) {
    const std::string number = RowText(row, rows);
    text += number;
    for (uint32_t column = 0; column < columns; ++column) {
      if (column > 0 && column % kItemsPerLine == 0) text += end + std::string(number.size(), ' ');
      const std::string item = ItemText(ItemAt(image, row * columns + column));
      text += std::string(kItemColumns - std::min(kItemColumns, item.size()), ' ') + item;
    }
    text += end;
  }
  return text;
}

std::string Listing(const TechnologyTable& table) {
  std::string text = table.name + ": version " + std::to_string(table.version) + ", " + std::to_string(table.columns) +
                     " columns, " + std::to_string(table.rows) + " rows\n";
  for (uint32_t i = 0; i < table.items.size(); ++i) {
    const uint32_t item = table.items[i];
    char line[80];
    std::snprintf(line, sizeof line, "row %3u column %2u %11s  %02X %02X %02X %02X\n", i / table.columns,
                  i % table.columns, ItemText(item).c_str(), item & 0xFFU, item >> 8 & 0xFFU, item >> 16 & 0xFFU,
                  item >> 24);
    text += line;
  }
  return text;
}

}  // namespace plcxx::technol
