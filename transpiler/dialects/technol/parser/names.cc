#include "transpiler/dialects/technol/parser/names.h"

#include <algorithm>
#include <charconv>

#include "transpiler/dialects/technol/machine/memory.h"
#include "transpiler/dialects/technol/machine/signals.h"

namespace plcxx::technol {
namespace {

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    if (Upper(a[i]) != Upper(b[i])) return false;
  }
  return true;
}

int64_t TakeNumber(std::string_view& text) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return value;
}

NamedThing OfSignal(const Signal& signal) {
  NamedThing thing;
  thing.area = signal.area;
  thing.offset = signal.byte;
  if (IsField(signal)) {
    thing.kind = SymbolKind::kField;
    thing.width = FieldWidth(signal);
  } else if (signal.width == 1) {
    thing.kind = SymbolKind::kBit;
    thing.bit = signal.bit;
  } else {
    thing.kind = SymbolKind::kCell;
    thing.width = static_cast<uint8_t>(signal.width <= 32 ? signal.width : 0);
  }
  return thing;
}

}  // namespace

std::string AddressOfSymbol(const Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::kCell:
      return CellAddress(symbol.area, symbol.offset, symbol.width);
    case SymbolKind::kBit:
      return BitAddress(symbol.area, symbol.offset, symbol.bit);
    case SymbolKind::kMechanism:
      return symbol.name;
    case SymbolKind::kConstant:
      return "=" + std::to_string(symbol.value);
    case SymbolKind::kField:
      return "=" + std::to_string(symbol.value) + ":" + std::to_string(symbol.width);
    case SymbolKind::kStructure:
    case SymbolKind::kLabel:
    case SymbolKind::kMacro:
      return {};
  }
  return {};
}

NamedThing ReadAddress(std::string_view address) {
  NamedThing thing;
  if (address.starts_with('=')) {
    address.remove_prefix(1);
    thing.offset = TakeNumber(address);
    thing.kind = address.starts_with(':') ? SymbolKind::kField : SymbolKind::kConstant;
    if (thing.kind == SymbolKind::kConstant) return thing;
    address.remove_prefix(1);
    thing.width = static_cast<uint8_t>(TakeNumber(address));
    return thing;
  }
  const size_t plus = address.find('+');
  if (plus == std::string_view::npos || plus + 1 == address.size()) return thing;
  const std::string_view name = address.substr(0, plus);
  thing.area = name == Name(Area::kUser) ? Area::kUser : AreaByName(name).value_or(Area::kNone);
  address.remove_prefix(plus + 1);
  thing.offset = TakeNumber(address);
  thing.kind = address.starts_with('.') ? SymbolKind::kBit : SymbolKind::kCell;
  if (!address.empty()) address.remove_prefix(1);
  const auto number = static_cast<uint8_t>(TakeNumber(address));
  (thing.kind == SymbolKind::kBit ? thing.bit : thing.width) = number;
  return thing;
}

std::optional<NamedThing> ReadDocumentedAddress(std::string_view text) {
  if (text.find('+') == std::string_view::npos || text.starts_with('=')) return std::nullopt;
  const NamedThing thing = ReadAddress(text);
  if (thing.area == Area::kNone || thing.offset < 0) return std::nullopt;
  const auto offset = static_cast<uint32_t>(thing.offset);
  const std::string spelled = thing.kind == SymbolKind::kBit ? BitAddress(thing.area, offset, thing.bit)
                                                             : CellAddress(thing.area, offset, thing.width);
  if (spelled != text) return std::nullopt;
  return thing;
}

std::optional<NamedThing> FindName(const ir::NameIndex& names, std::string_view name) {
  if (name.empty()) return std::nullopt;
  const ir::Documentation* row = names.WithSymbols(name);
  if (row == nullptr) row = names.WithSymbolsOfAnyCase(name);
  if (row != nullptr) return ReadAddress(row->address);
  for (const Signal& signal : Signals()) {
    if (EqualIgnoringCase(signal.name, name)) return OfSignal(signal);
  }
  return std::nullopt;
}

}  // namespace plcxx::technol
