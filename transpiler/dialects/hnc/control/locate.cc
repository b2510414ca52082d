#include "transpiler/dialects/hnc/control/locate.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {
namespace {

using dialects::Location;

std::optional<uint32_t> Number(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

ir::SpaceId SpaceByName(const ir::Program& program, std::string_view name) {
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    if (program.spaces[ir::SpaceId(i)].name == name) return ir::SpaceId(i);
  }
  return {};
}

Location At(const ir::Program& program, const AreaRow& area, uint32_t offset, ir::Type type, std::string_view name) {
  Location location;
  location.place = {.name = std::string(name),
                    .address = {},
                    .type = type,
                    .space = SpaceByName(program, area.name),
                    .offset = offset};
  return location;
}

/// The element type of a view: its width, and whether it has a sign.
struct Element {
  ir::Type type;
  bool has_sign;
};
std::optional<Element> ElementOf(std::string_view suffix, bool words) {
  if (suffix.empty()) return Element{words ? ir::Type::kI16 : ir::Type::kI8, false};
  if (suffix == "_uc") return Element{ir::Type::kI8, false};
  if (suffix == "_c") return Element{ir::Type::kI8, true};
  if (suffix == "_ui") return Element{ir::Type::kI16, false};
  if (suffix == "_i") return Element{ir::Type::kI16, true};
  if (suffix == "_ul") return Element{ir::Type::kI32, false};
  if (suffix == "_l") return Element{ir::Type::kI32, true};
  return std::nullopt;
}

/// "X0.1", "F162.5"
std::optional<Location> AreaBit(const ir::Program& program, std::string_view text) {
  for (const AreaRow& area : Areas()) {
    if (!text.starts_with(area.name)) continue;
    const std::string_view rest = text.substr(area.name.size());
    const size_t dot = rest.find('.');
    if (dot == std::string_view::npos) continue;
    const std::optional<uint32_t> group = Number(rest.substr(0, dot)), bit = Number(rest.substr(dot + 1));
    const bool words = area.basic != "unsigned char";
    if (!group || !bit || *bit >= (words ? 16 : 8) || *group >= area.bytes / (words ? 2 : 1)) continue;
    Location location = At(program, area, *group * (words ? 2 : 1) + *bit / 8, ir::Type::kBit, text);
    location.place.bit = static_cast<uint8_t>(*bit % 8);
    return location;
  }
  return std::nullopt;
}

/// "X[3]", "R_i[1]", "F_l[1]"
std::optional<Location> AreaElement(const ir::Program& program, std::string_view text) {
  const size_t open = text.find('[');
  if (open == std::string_view::npos || text.back() != ']') return std::nullopt;
  const std::optional<uint32_t> number = Number(text.substr(open + 1, text.size() - open - 2));
  const std::string_view name = text.substr(0, open);
  if (!number) return std::nullopt;
  for (const AreaRow& area : Areas()) {
    if (!name.starts_with(area.name)) continue;
    const std::optional<Element> element = ElementOf(name.substr(area.name.size()), area.basic != "unsigned char");
    if (!element) continue;
    const uint32_t bytes = ir::Bytes(element->type);
    // An element of a pointer table is the cell at its word, whatever its type.
    const uint64_t offset = uint64_t{*number} * (area.table ? 2 : bytes);
    if (offset + bytes > area.bytes) return std::nullopt;
    Location location = At(program, area, static_cast<uint32_t>(offset), element->type, text);
    location.has_sign = element->has_sign;
    return location;
  }
  return std::nullopt;
}

std::optional<Location> PlaceNamed(const ir::NameIndex& names, std::string_view name, std::string_view text) {
  for (const ir::Place* const place : names.Places(name)) {
    if (place->indexed || !place->space.valid()) continue;
    if (names.program().spaces[place->space].name != "system") continue;
    Location location;
    location.place = *place;
    location.place.name = text;
    return location;
  }
  return std::nullopt;
}

/// "HW[0]", "MODAL[2]", "FAULT.code"
std::optional<Location> Runtime(const ir::NameIndex& names, std::string_view text) {
  if (text == "FAULT.code") return PlaceNamed(names, "fault_code", text);
  if (text == "FAULT.count") return PlaceNamed(names, "fault_count", text);
  if (text == "FAULT.line") {
    Location location;
    location.place.name = text;
    location.place.type = ir::Type::kI32;
    location.cell = kFaultLineCell;
    return location;
  }
  for (const auto& [prefix, name, sign] :
       {std::tuple("HW[", "handwheel_", true), std::tuple("MODAL[", "modal_", false)}) {
    const std::string_view head = prefix;
    if (!text.starts_with(head) || text.back() != ']') continue;
    const std::optional<uint32_t> number = Number(text.substr(head.size(), text.size() - head.size() - 1));
    if (!number) return std::nullopt;
    std::optional<Location> location = PlaceNamed(names, name + std::to_string(*number), text);
    if (location) location->has_sign = sign;
    return location;
  }
  return std::nullopt;
}

/// "table[3].speed", "plc1.count"
std::optional<Location> Data(const ir::NameIndex& names, std::string_view text) {
  std::string pattern;
  std::vector<uint32_t> indices;
  for (size_t i = 0; i < text.size(); ++i) {
    pattern += text[i];
    if (text[i] != '[') continue;
    const size_t close = text.find(']', i);
    if (close == std::string_view::npos) return std::nullopt;
    const std::optional<uint32_t> number = Number(text.substr(i + 1, close - i - 1));
    if (!number) return std::nullopt;
    indices.push_back(*number);
    pattern += ']';
    i = close;
  }
  std::optional<Location> location;
  for (const ir::Symbol* const found : names.Symbols(pattern)) {
    const ir::Symbol& symbol = *found;
    if (symbol.indices.size() != indices.size()) continue;
    uint32_t offset = symbol.offset;
    for (size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] >= symbol.indices[i].count) return std::nullopt;
      offset += indices[i] * symbol.indices[i].stride;
    }
    const ir::Place place = {.name = std::string(text),
                             .address = {},
                             .type = symbol.type,
                             .space = symbol.space,
                             .offset = offset,
                             .bit = symbol.bit};
    if (!location) {
      location.emplace();
      location->place = place;
      location->has_sign = symbol.has_sign;
    }
    location->bits.push_back(place);
  }
  if (!location) return std::nullopt;
  if (location->bits.size() == 1) {
    location->bits.clear();
  } else {  // a bit-field: a part of the two bytes from that of its lowest bit on
    location->place.type = ir::Type::kI16;
    location->place.bit = ir::kNoBit;
  }
  return location;
}

}  // namespace

std::optional<Location> Locate(const ir::NameIndex& names, std::string_view written) {
  const ir::Program& program = names.program();
  std::string text;
  for (const char c : written) {
    if (c != ' ' && c != '\t') text += c;
  }
  if (text.empty()) return std::nullopt;
  if (std::optional<Location> location = Data(names, text)) return location;
  if (std::optional<Location> location = AreaBit(program, text)) return location;
  if (std::optional<Location> location = AreaElement(program, text)) return location;
  return Runtime(names, text);
}

}  // namespace plcxx::hnc
