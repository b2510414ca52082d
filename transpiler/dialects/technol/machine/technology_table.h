// Technology tables: a .TCH file to the image of TAB_TECHNOL and back (specification 5.4, 9.8).
//
// In: the text of a file, every fault of which is reported (TT001 to TT016). Out: its items, as packed BCD.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/source/source.h"

namespace plcxx::technol {

constexpr uint32_t kTableImageBytes = 1632;
using TableImage = std::array<uint8_t, kTableImageBytes>;

struct TechnologyTable {
  uint16_t version = 1;
  uint16_t columns = 1;         // 1 to 20
  uint16_t rows = 1;            // 1 to 400
  std::vector<uint32_t> items;  // row by row; eight digits, bit 31 is the sign (5.4)
  std::string name;             // in capitals, at most 15 characters, without directories
  std::string preamble;         // everything before $TCH, as the bytes of the file
  source::FileId file;
};

/// None when the table has a fault (reported).
std::optional<TechnologyTable> ReadTable(const source::SourceManager& sources, source::FileId file,
                                         const Settings& settings, diag::Engine& diagnostics);

/// TAB_TECHNOL as the loader leaves it (9.8.3).
TableImage ImageOf(const TechnologyTable& table);
/// TAB_TECHNOL without any table: zeros, TCH_VOLBA 0FFFFh (D11).
TableImage EmptyImage();
/// The table written back (9.8.4) from what TAB_TECHNOL holds now; `preamble` as it was read. A header that is no
/// table's (the program may write it) gives the rows and columns that fit into the area.
std::string WriteTable(const TableImage& image, std::string_view preamble);
/// "-5.100": the value of an item.
std::string ItemText(uint32_t item);
/// Row, column, value and bytes, one item per line.
std::string Listing(const TechnologyTable& table);

}  // namespace plcxx::technol
