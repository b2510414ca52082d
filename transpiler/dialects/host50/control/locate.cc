#include "transpiler/dialects/host50/control/locate.h"

#include "transpiler/dialects/common/dollar_hex.h"
#include "transpiler/dialects/host50/machine/addresses.h"
#include "transpiler/dialects/host50/machine/places.h"

namespace plcxx::host50 {
namespace {

std::optional<Address> AddressFromText(const ir::Program& program, std::string_view text) {
  const std::string spelled = text.starts_with('%') ? std::string(text) : "%" + std::string(text);
  const AddressText read = ReadAddressText(spelled, ChannelsOf(program));
  if (read.fault != AddressFault::kNone) return std::nullopt;
  return read.address;
}

/// By the documentation that lowering wrote: it lists every symbol with its address.
std::optional<Address> AddressOfSymbol(const ir::NameIndex& names, std::string_view symbol) {
  if (symbol.empty()) return std::nullopt;  // entries of addresses without one
  const ir::Documentation* const entry = names.WithSymbols(symbol);
  if (entry == nullptr) return std::nullopt;
  return AddressFromText(names.program(), entry->address);
}

std::string_view SymbolOf(const ir::NameIndex& names, std::string_view address) {
  const ir::Documentation* const entry = names.WithAddress(address);
  return entry == nullptr ? std::string_view() : entry->symbols;
}

std::optional<Address> AddressOf(const ir::NameIndex& names, std::string_view text) {
  const bool quoted = text.starts_with('\'');
  if (!quoted) {
    if (const auto address = AddressFromText(names.program(), text)) return address;
    if (const auto address = AddressOfSymbol(names, text)) return address;
  }
  std::string_view name = text, attribute;
  if (quoted) {
    name.remove_prefix(1);
    const size_t end = name.find('\'');
    if (end == std::string_view::npos) return std::nullopt;
    attribute = name.substr(end + 1);
    name = name.substr(0, end);
    if (attribute.empty()) return AddressOfSymbol(names, name);
  } else {
    const size_t dot = text.rfind('.');
    if (dot == std::string_view::npos) return std::nullopt;
    name = text.substr(0, dot);
    attribute = text.substr(dot);
  }
  if (!attribute.starts_with('.')) return std::nullopt;
  std::optional<Address> address = AddressOfSymbol(names, name);
  if (!address || !FieldOf(*address)) return std::nullopt;
  address->attribute = AttributeByName(attribute.substr(1));
  if (address->attribute == Attribute::kNone) return std::nullopt;
  return address;
}

}  // namespace

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text) {
  const std::optional<Address> address = AddressOf(names, text);
  if (!address) return std::nullopt;
  dialects::Location location;
  if (const auto field = FieldOf(*address)) {
    location.place.type = field->type;
    location.place.field = field->field;
    const Address instance = WithoutAttribute(*address);
    const std::string name = NameInCode(SymbolOf(names, NameOf(instance)), instance, ChannelsOf(names.program()));
    location.place.state = names.State(field->kind, name);
    location.absent = !location.place.state.valid();
  } else {
    location.place = MemoryPlace(*address);
  }
  location.place.name = NameOf(*address);
  location.has_sign = location.place.type == ir::Type::kI32;  // all words are (specification 5)
  return location;
}

std::optional<uint64_t> ParseValue(std::string_view text) { return dialects::DollarHex(text); }

std::string MessageText(const ir::Program& program, uint32_t number, const dialects::ImagePort& /*image*/) {
  for (const ir::MessageText& message : program.messages) {
    if (message.number == number) return message.text;
  }
  return "%Q" + std::to_string(kFirstAlarm + number);
}

}  // namespace plcxx::host50
