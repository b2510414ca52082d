#include "transpiler/dialects/prostep/control/locate.h"

#include <charconv>
#include <string>

#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/dialects/prostep/machine/memory.h"
#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {
namespace {

using dialects::Location;

/// The number at the beginning of the text, which is taken away.
std::optional<uint32_t> TakeNumber(std::string_view& text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

ir::Type TypeOf(Shape shape) {
  switch (shape) {
    case Shape::kBit:
      return ir::Type::kBit;
    case Shape::kByte:
      return ir::Type::kI8;
    case Shape::kWord:
      return ir::Type::kI16;
    case Shape::kDouble:
      return ir::Type::kI32;
    case Shape::kCounter:
    case Shape::kTimer:
    case Shape::kConstant:
    case Shape::kModule:
    case Shape::kFunction:
      return ir::Type::kNone;
  }
  PLCXX_UNREACHABLE();
}

std::optional<Location> Instance(const ir::NameIndex& names, ir::StateKind kind, std::string_view field, ir::Type type,
                                 std::string name, uint32_t number, uint32_t count) {
  if (number >= count) return std::nullopt;
  Location location;
  location.place.type = type;
  location.place.field = ir::FieldIndex(kind, field);
  location.place.state = names.State(kind, name);
  location.absent = !location.place.state.valid();
  location.place.name = std::move(name);
  return location;
}

std::optional<Location> Port(Shape shape, uint32_t number, uint8_t bit, std::string name) {
  if (!IsPort(Access::kRead, shape, number) && !IsPort(Access::kWrite, shape, number)) return std::nullopt;
  Location location;
  location.place.type = TypeOf(shape);
  location.place.name = std::move(name);
  const auto bytes = static_cast<uint8_t>(shape == Shape::kWord ? 2 : 1);
  location.cell = ToNumber({.number = number, .bit = bit, .bytes = bytes});
  return location;
}

}  // namespace

std::optional<Location> Locate(const ir::NameIndex& names, std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (c == ' ' || c == '\t') continue;
    name.push_back(c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
  }
  std::string_view rest = name;
  size_t letters = 0;
  while (letters < rest.size() && rest[letters] >= 'A' && rest[letters] <= 'Z') ++letters;
  const OperandClass kind = ClassByName(rest.substr(0, letters));
  rest.remove_prefix(letters);
  if (kind == OperandClass::kNone || rest.empty() || !IsDigit(rest.front())) return std::nullopt;
  const std::optional<uint32_t> number = TakeNumber(rest);
  if (!number) return std::nullopt;
  const Shape shape = ShapeOf(kind);
  uint8_t bit = ir::kNoBit;
  if (shape == Shape::kBit) {
    if (rest.size() != 2 || rest[0] != '.' || rest[1] < '0' || rest[1] > '7') return std::nullopt;
    bit = static_cast<uint8_t>(rest[1] - '0');
  } else if (!rest.empty()) {
    return std::nullopt;
  }
  if (shape == Shape::kTimer) {
    return Instance(names, ir::StateKind::kTimeWordTimer, "output", ir::Type::kBit, name, *number, kTimers);
  }
  if (shape == Shape::kCounter) {
    return Instance(names, ir::StateKind::kDecadeCounter, "value", ir::Type::kI16, name, *number, kCounters);
  }
  const ir::Type type = TypeOf(shape);
  const Space space = SpaceOf(kind);
  if (type == ir::Type::kNone || space == Space::kNone) return std::nullopt;
  if (space == Space::kP) return Port(shape, *number, bit, std::move(name));
  if (*number + ir::Bytes(type) > BytesOf(space)) return std::nullopt;
  const Cell cell = Memory(names.program()).At(space, *number);
  Location location;
  if (cell.left < ir::Bytes(type)) {  // half retentive
    location.place.name = std::move(name);
    location.place.type = type;
    location.cell = ToNumber({.is_data = true, .number = *number, .bytes = static_cast<uint8_t>(ir::Bytes(type))});
    return location;
  }
  location.place = {.name = std::move(name), .type = type, .space = cell.space, .offset = cell.offset, .bit = bit};
  return location;
}

}  // namespace plcxx::prostep
