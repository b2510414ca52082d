#include "transpiler/dialects/classicladder/control/locate.h"

#include "transpiler/dialects/classicladder/machine/places.h"
#include "transpiler/dialects/common/dollar_hex.h"

namespace plcxx::classicladder {
namespace {

std::optional<Address> AddressOf(const ir::NameIndex& names, std::string_view text) {
  if (const auto address = AddressByName(text)) return address;
  const ir::Documentation* const entry = text.empty() ? nullptr : names.WithSymbols(text);
  return entry == nullptr ? std::nullopt : AddressByName(entry->address);
}

}  // namespace

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text) {
  const auto address = AddressOf(names, text);
  if (!address) return std::nullopt;
  const Sizes sizes = SizesOf(names.program());
  const auto resolved = Resolve(*address, sizes);
  if (!resolved || *resolved != *address) return std::nullopt;  // beyond its kind
  const VariableInfo& info = Info(address->kind);
  dialects::Location location;
  location.place = PlaceAt(info.group, info.part, IndexOf(*address, sizes));
  location.place.name = NameOf(*address);
  location.has_sign = location.place.type == ir::Type::kI32;
  return location;
}

std::optional<uint64_t> ParseValue(std::string_view text) { return dialects::DollarHex(text); }

}  // namespace plcxx::classicladder
