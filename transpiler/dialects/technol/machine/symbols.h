// The names of a technol program and what they mean (specification sections 5 and 9), resolved by the parser.
//
// Every name has exactly one symbol; predefined ones (signals.h) come first. Memory is an area and a byte offset in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::technol {

using SymbolId = support::Id<struct SymbolTag>;
using LabelId = support::Id<struct LabelTag>;
using UnitId = support::Id<struct UnitTag>;

struct Span {
  uint32_t first = 0;
  uint32_t count = 0;
};

enum class SymbolKind : uint8_t {
  kCell,       // memory: area, offset, bytes, width
  kBit,        // a bit of memory: area, offset, bit
  kMechanism,  // a bit without address: unit
  kConstant,   // EQUI, EQU, =: value
  kField,      // value: its offset; width, bytes: of the field
  kStructure,  // bytes
  kLabel,      // label
  kMacro,
};

enum class SymbolOrigin : uint8_t {
  kSource,
  kControl,  // predefined
  kSignals,  // of the file of option signals
};

/// Who writes a predefined cell or bit.
enum class Direction : uint8_t { kMachineIn, kMachineOut, kNcToPlc, kPlcToNc, kInternal };

struct Symbol {
  SymbolKind kind = SymbolKind::kCell;
  SymbolOrigin origin = SymbolOrigin::kSource;
  Direction direction = Direction::kInternal;
  uint8_t width = 0;    // kCell, kField: 8, 16, 32; 0: an access needs a prefix (TE041)
  uint8_t bit = 0;      // kBit
  bool faulty = false;  // its definition was reported: nothing more is said about it
  Area area = Area::kNone;
  uint32_t offset = 0;  // kCell, kBit: of its byte in the area
  uint32_t bytes = 0;   // extent of cells, fields and structures
  int64_t value = 0;    // kConstant (of '=' the last one), kField
  LabelId label;
  UnitId unit;
  std::string name;     // as first spelled
  std::string meaning;  // of predefined ones
  source::Range range;  // of the name where it is defined; empty when predefined
  uint32_t uses = 0;    // by the program's statements and declarations
  SymbolId byte;        // kBit of a DFM: the cell that carries it
  Span comments;        // into Program::comments: above its line and on it
};

/// In the order of the program, predefined ones first.
using Symbols = support::Store<SymbolId, Symbol>;

}  // namespace plcxx::technol
