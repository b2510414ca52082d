// The predefined cells, bits and fields of the control (signals.csv), and the tables of signals of option signals,
// which have the same columns.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/dialects/technol/machine/symbols.h"
#include "transpiler/support/embedded_file.h"

namespace plcxx::technol {

using support::EmbeddedFile;

extern const EmbeddedFile kSignalTable[];
extern const unsigned kSignalTableCount;

struct Signal {
  Area area = Area::kNone;
  uint32_t byte = 0;
  uint8_t bit = 0;
  uint32_t width = 0;  // in bits: 1, or a multiple of 8
  Direction direction = Direction::kInternal;
  std::string name;
  std::string meaning;
};

/// The control's own, in the order of the table. Parsed at the first use.
std::span<const Signal> Signals();
/// One row, without the line's end; none when it is malformed or leaves its area.
std::optional<Signal> ReadSignal(std::string_view row);
/// The heads of the columns.
bool IsSignalHead(std::string_view row);

/// The width of one element of a predefined field: 16 of TCH_REZ, which has three words.
uint8_t FieldWidth(const Signal& signal);
/// Is it a field of a predefined structure (5.4, 5.5)? Not of a signal file.
bool IsField(const Signal& signal);

}  // namespace plcxx::technol
