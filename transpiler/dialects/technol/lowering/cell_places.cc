#include "transpiler/dialects/technol/lowering/cell_places.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::technol {

using ir::Type;

namespace {

std::string_view PrefixOf(uint32_t width) { return width == 8 ? "BYTE" : width == 16 ? "WORD" : "DWRD"; }

}  // namespace

const Symbol* CellPlaces::Find(std::string_view name) const {
  const auto found = std::find_if(tree_.symbols.begin(), tree_.symbols.end(),
                                  [name](const Symbol& symbol) { return symbol.name == name; });
  return found == tree_.symbols.end() ? nullptr : &*found;
}

ir::PlaceId CellPlaces::System(std::string_view name) {
  const Symbol* symbol = Find(name);
  PLCXX_CHECK(symbol != nullptr);
  if (symbol->kind == SymbolKind::kBit) return Bit(symbol->area, symbol->offset, symbol->bit, std::string(name));
  return Cell(symbol->area, symbol->offset, TypeOf(symbol->width), std::string(name));
}

ir::PlaceId CellPlaces::Bit(Area area, uint32_t offset, uint8_t bit, std::string name) {
  const auto [found, is_new] = places_.try_emplace(std::tuple(area, offset, Type::kBit, bit));
  if (is_new) {
    found->second = program_.places.Add({.name = std::move(name),
                                         .address = BitAddress(area, offset, bit),
                                         .type = Type::kBit,
                                         .space = memory_[area],
                                         .offset = offset,
                                         .bit = bit});
  }
  return found->second;
}

ir::PlaceId CellPlaces::Cell(Area area, uint32_t offset, Type type, std::string name) {
  const auto [found, is_new] = places_.try_emplace(std::tuple(area, offset, type, ir::kNoBit));
  if (is_new) {
    found->second = program_.places.Add({.name = std::move(name),
                                         .address = CellAddress(area, offset, 8 * ir::Bytes(type)),
                                         .type = type,
                                         .space = memory_[area],
                                         .offset = offset});
  }
  return found->second;
}

std::string CellPlaces::NameOf(const Operand& operand) const {
  const Address& address = operand.address;
  if (!address.base.valid()) {
    return CellAddress(address.area, static_cast<uint32_t>(address.offset), operand.width);
  }
  const Symbol& base = tree_.symbols[address.base];
  std::string name = base.name;
  int64_t rest = address.offset - base.offset;
  uint8_t width = base.width;
  if (address.field.valid()) {
    const Symbol& field = tree_.symbols[address.field];
    name += "_" + field.name;
    rest -= field.value;
    width = field.width;
  }
  if (rest != 0) name += (rest < 0 ? "_minus_" : "_") + std::to_string(rest < 0 ? -rest : rest);
  return width == operand.width || width == 0 ? name : std::string(PrefixOf(operand.width)) + "_" + name;
}

ir::PlaceId CellPlaces::Of(const Operand& operand) {
  const Address& address = operand.address;
  const auto offset = static_cast<uint32_t>(address.offset);
  if (operand.kind == OperandKind::kBit) {
    return Bit(address.area, offset, operand.bit, tree_.symbols[operand.symbol].name);
  }
  PLCXX_CHECK(operand.kind == OperandKind::kMemory);
  return Cell(address.area, offset, TypeOf(operand.width), NameOf(operand));
}

ir::PlaceId CellPlaces::Indexed(const Operand& operand, uint32_t offset) {
  const Area area = operand.address.area;
  const auto [found, is_new] = indexed_.try_emplace(std::tuple(area, offset, TypeOf(operand.width)));
  if (is_new) {
    found->second = program_.places.Add({.name = NameOf(operand) + "_indexed",
                                         .address = CellAddress(area, offset, operand.width) + "[]",
                                         .type = TypeOf(operand.width),
                                         .space = memory_[area],
                                         .offset = offset,
                                         .indexed = true,
                                         .stride = 1,
                                         .low = 0,
                                         .high = BytesOf(tree_, area)});
  }
  return found->second;
}

}  // namespace plcxx::technol
