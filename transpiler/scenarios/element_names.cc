#include "transpiler/scenarios/element_names.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace plcxx::scenarios {
namespace {

using execute::Cell;

/// The element of an array or structure that a name of the source covers.
std::optional<ir::Place> FromSymbols(const ir::Program& program, const Cell& cell) {
  for (const ir::Symbol& symbol : program.symbols) {
    if (symbol.space != cell.space || cell.offset < symbol.offset) continue;
    uint32_t rest = cell.offset - symbol.offset;
    std::string name = symbol.name;
    bool inside = true;
    size_t from = 0;
    for (const ir::Symbol::Index& index : symbol.indices) {
      const uint32_t i = index.stride == 0 ? 0 : std::min(rest / index.stride, index.count - 1);
      rest -= i * index.stride;
      const size_t brackets = name.find("[]", from);
      if (brackets == std::string::npos) inside = false;
      if (!inside) break;
      name.insert(brackets + 1, std::to_string(i));
      from = brackets + 1;
    }
    const bool is_bit = symbol.type == ir::Type::kBit;
    if (!inside || rest >= std::max(1U, ir::Bytes(symbol.type)) || (is_bit && symbol.bit != cell.bit)) continue;
    ir::Place place{.name = name, .type = symbol.type, .space = symbol.space, .offset = cell.offset - rest};
    if (is_bit) place.bit = symbol.bit;
    return place;
  }
  return std::nullopt;
}

/// An element of an area, as the dialect names it.
std::optional<ir::Place> FromDialect(const ir::NameIndex& index, const dialects::Dialect& dialect, const Cell& cell) {
  const std::string& space = index.program().spaces[cell.space].name;
  // An element may have one, two or four bytes.
  const std::string offset = std::to_string(cell.offset);
  std::vector<std::string> names{space + "+" + offset + ":8", space + "B " + offset};
  for (const uint32_t bytes : {4U, 2U, 1U}) {
    names.insert(names.begin(), space + "[" + std::to_string(cell.offset / bytes) + "]");
  }
  for (const std::string& name : names) {
    const std::optional<dialects::Location> location = dialect.locate(index, name);
    if (!location || location->absent || location->cell || location->text_input || !location->bits.empty()) continue;
    ir::Place place = location->place;
    const bool is_inside = place.space == cell.space && !place.is_field() && place.type != ir::Type::kBit &&
                           place.offset <= cell.offset && cell.offset - place.offset < ir::Bytes(place.type);
    if (!is_inside) continue;
    place.name = name;
    place.address.clear();
    return place;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ir::Place> NamedElement(const ir::NameIndex& index, const dialects::Dialect& dialect, const Cell& cell) {
  if (std::optional<ir::Place> symbol = FromSymbols(index.program(), cell)) return symbol;
  return FromDialect(index, dialect, cell);
}

}  // namespace plcxx::scenarios
