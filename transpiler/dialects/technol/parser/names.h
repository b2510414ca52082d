// The names of a program as its documentation keeps them, so that they can be found without a syntax tree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "transpiler/dialects/technol/machine/symbols.h"
#include "transpiler/ir/name_index.h"

namespace plcxx::technol {

constexpr char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// What a documented address says of its symbol: "IN+3.5", "DATA+12:16", "=5" of a constant, "=4:16" of a field, else
/// the name of a mechanism.
struct NamedThing {
  SymbolKind kind = SymbolKind::kMechanism;
  Area area = Area::kNone;
  int64_t offset = 0;  // kCell, kBit: in the area; kConstant, kField: the value
  uint8_t bit = 0;
  uint8_t width = 0;  // 0: it has none of its own
};

/// The documented address of a symbol; empty: labels, structures, macros.
std::string AddressOfSymbol(const Symbol& symbol);
NamedThing ReadAddress(std::string_view address);
/// Of a bit or cell that is spelled as AddressOfSymbol spells it; none for every other text.
std::optional<NamedThing> ReadDocumentedAddress(std::string_view text);
/// By the documentation of the program, then by the control's own names. Spelled without regard to case, unless the
/// program has another name that differs by case only.
std::optional<NamedThing> FindName(const ir::NameIndex& names, std::string_view name);

}  // namespace plcxx::technol
