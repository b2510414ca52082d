#include "transpiler/dialects/technol/control/locate.h"

#include <algorithm>
#include <string>
#include <vector>

#include "transpiler/dialects/technol/machine/memory.h"
#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/dialects/technol/parser/names.h"

namespace plcxx::technol {
namespace {

constexpr bool IsDecimal(char c) { return c >= '0' && c <= '9'; }
constexpr bool StartsName(char c) { return (Upper(c) >= 'A' && Upper(c) <= 'Z') || c == '_' || c == '?' || c == '@'; }

/// An address as far as it has been read; a constant alone has no area.
struct Read {
  Area area = Area::kNone;
  int64_t offset = 0;
  uint8_t width = 0;
};

class AddressReader {
 public:
  AddressReader(const ir::NameIndex& names, std::string_view text) : names_(names), rest_(text) {}

  /// None when the text is no address, or goes on after it.
  std::optional<Read> Whole() {
    const std::optional<Read> read = Address();
    if (!read || Next() != 0 || read->area == Area::kNone) return std::nullopt;
    return read;
  }
  /// "WORD." in front of the address, as 8, 16 or 32.
  std::optional<uint8_t> TakePrefix() {
    for (const auto& [word, width] : {std::pair("BYTE", 8), std::pair("WORD", 16), std::pair("DWRD", 32)}) {
      const std::string_view before = rest_;
      if (const auto name = TakeName(); name && EqualsWord(*name, word) && Take('.'))
        return static_cast<uint8_t>(width);
      rest_ = before;
    }
    return std::nullopt;
  }

 private:
  static bool EqualsWord(std::string_view text, std::string_view word) {
    if (text.size() != word.size()) return false;
    for (size_t i = 0; i < text.size(); ++i) {
      if (Upper(text[i]) != word[i]) return false;
    }
    return true;
  }
  char Next() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }
  bool Take(char wanted) {
    if (Next() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::optional<std::string_view> TakeName() {
    if (!StartsName(Next())) return std::nullopt;
    size_t end = 1;
    while (end < rest_.size() && (StartsName(rest_[end]) || IsDecimal(rest_[end]))) ++end;
    const std::string_view name = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return name;
  }

  std::optional<Read> Primary() {
    if (Take('(')) {
      const std::optional<Read> inner = Address();
      if (!inner || !Take(')')) return std::nullopt;
      return inner;
    }
    if (IsDecimal(Next())) {
      size_t end = 0;
      while (end < rest_.size() && (StartsName(rest_[end]) || IsDecimal(rest_[end]))) ++end;
      const Number number = ReadNumber(rest_.substr(0, end));
      rest_.remove_prefix(end);
      if (number.fault != NumberFault::kNone) return std::nullopt;
      return Read{.area = Area::kNone, .offset = number.value, .width = 0};
    }
    const auto name = TakeName();
    if (!name) return std::nullopt;
    const auto thing = FindName(names_, *name);
    if (!thing || thing->kind == SymbolKind::kBit || thing->kind == SymbolKind::kMechanism) return std::nullopt;
    const bool constant = thing->kind == SymbolKind::kConstant || thing->kind == SymbolKind::kField;
    return Read{.area = constant ? Area::kNone : thing->area, .offset = thing->offset, .width = thing->width};
  }

  std::optional<Read> Term() {
    std::optional<Read> read = Primary();
    while (read && read->area == Area::kNone && (Next() == '*' || Next() == '/')) {
      const bool divides = Take('/');
      if (!divides) Take('*');
      const std::optional<Read> right = Primary();
      if (!right || right->area != Area::kNone || (divides && right->offset == 0)) return std::nullopt;
      read->offset = divides ? read->offset / right->offset : read->offset * right->offset;
    }
    return read;
  }

  std::optional<Read> Address() {
    std::optional<Read> read = Term();
    while (read) {
      const char next = Next();
      if (next != '.' && next != '[' && next != '+' && next != '-') break;
      Take(next);
      const std::optional<Read> more = next == '[' ? Address() : Term();
      if (!more || (more->area != Area::kNone && (read->area != Area::kNone || next != '+'))) return std::nullopt;
      if (next == '[' && !Take(']')) return std::nullopt;
      if (more->area != Area::kNone) read->area = more->area;
      read->offset += next == '-' ? -more->offset : more->offset;
      if (next == '.') read->width = more->width;
    }
    return read;
  }

  const ir::NameIndex& names_;
  std::string_view rest_;
};

/// The activation bit: the place with the very name, else one that differs by case only.
std::optional<ir::Place> MechanismPlace(const ir::NameIndex& names, std::string_view name) {
  const ir::SpaceId space = Memory(names.program())[SpaceKey::kMechanisms];
  if (!space.valid()) return std::nullopt;
  const auto is_mechanism = [space](const ir::Place* place) { return !place->is_field() && place->space == space; };
  std::vector<const ir::Place*> found = names.Places(name);
  if (std::ranges::none_of(found, is_mechanism)) found = names.PlacesOfAnyCase(name);
  const auto first = std::ranges::find_if(found, is_mechanism);
  return first == found.end() ? std::nullopt : std::optional(**first);
}

/// Bits and cells; none where it is not wholly inside its area.
std::optional<ir::Place> MemoryPlace(const ir::Program& program, std::string_view text, Area area, int64_t offset,
                                     uint32_t width, uint8_t bit) {
  const ir::SpaceId space = Memory(program)[area];
  const uint32_t bytes = bit == ir::kNoBit ? width / 8 : 1;
  if (bytes == 0 || !space.valid() || offset < 0 || offset + bytes > program.spaces[space].bytes) return std::nullopt;
  const ir::Type cell = width == 8 ? ir::Type::kI8 : width == 16 ? ir::Type::kI16 : ir::Type::kI32;
  return ir::Place{.name = std::string(text),
                   .type = bit == ir::kNoBit ? cell : ir::Type::kBit,
                   .space = space,
                   .offset = static_cast<uint32_t>(offset),
                   .bit = bit};
}

std::optional<ir::Place> PlaceOf(const ir::NameIndex& names, std::string_view text) {
  const ir::Program& program = names.program();
  auto thing = ReadDocumentedAddress(text);  // no name has its '+'
  if (!thing) thing = FindName(names, text);
  if (thing && thing->kind == SymbolKind::kMechanism) return MechanismPlace(names, text);
  if (thing && thing->kind == SymbolKind::kBit) {
    return MemoryPlace(program, text, thing->area, thing->offset, 1, thing->bit);
  }
  if (thing && thing->kind == SymbolKind::kCell) {
    return MemoryPlace(program, text, thing->area, thing->offset, thing->width, ir::kNoBit);
  }
  AddressReader reader(names, text);
  const std::optional<uint8_t> prefix = reader.TakePrefix();
  const std::optional<Read> read = reader.Whole();
  if (!read) return std::nullopt;
  return MemoryPlace(program, text, read->area, read->offset, prefix.value_or(read->width), ir::kNoBit);
}

}  // namespace

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text) {
  std::optional<ir::Place> place = PlaceOf(names, text);
  if (!place) return std::nullopt;
  dialects::Location location;
  location.place = *std::move(place);
  return location;
}

std::optional<uint64_t> ParseValue(std::string_view text) {
  if (text.size() == 3 && text.front() == '\'' && text.back() == '\'') return static_cast<unsigned char>(text[1]);
  if (text.empty() || !IsDecimal(text.front())) return std::nullopt;
  const Number number = ReadNumber(text);
  if (number.fault != NumberFault::kNone) return std::nullopt;
  return static_cast<uint64_t>(number.value);
}

}  // namespace plcxx::technol
