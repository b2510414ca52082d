// How the NC shows a message with a number in it (specification 8.3, D56).

#include <string>

#include "transpiler/dialects/prostep/control/stub.h"
#include "transpiler/dialects/prostep/machine/memory.h"
#include "transpiler/support/hex.h"

namespace plcxx::prostep {
namespace {

constexpr uint32_t kFieldBytes = 7;
constexpr uint8_t kIsBcd = 0x80, kBcdMinus = 0x40, kIsDouble = 0x20, kShown = 0x01;
constexpr uint32_t kColumnMask = 0x3F;

struct Field {
  uint8_t flags = 0, place = 0, decimals = 0;
  uint32_t value = 0;
};

/// The characters of a text, by the bytes at which they begin; its end is the last one.
size_t ByteOfCharacter(std::string_view text, size_t character) {
  size_t byte = 0;
  while (character > 0 && byte < text.size()) {
    ++byte;
    while (byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xC0) == 0x80) ++byte;
    --character;
  }
  return byte;
}

std::string Digits(const Field& field, bool& negative) {
  const uint32_t bits = (field.flags & kIsDouble) != 0 ? 32 : 16;
  if ((field.flags & kIsBcd) != 0) {
    negative = (field.flags & kBcdMinus) != 0;
    const uint64_t value = bits == 32 ? field.value : field.value & 0xFFFF;
    return value == 0 ? "" : support::HexDigits(value, 1, support::HexLetters::kCapital);
  }
  const uint32_t sign = 1u << (bits - 1);
  negative = (field.value & sign) != 0;
  const uint64_t magnitude = negative ? (uint64_t{1} << bits) - field.value : field.value;
  return magnitude == 0 ? "" : std::to_string(magnitude);
}

/// At least one digit stands before the point.
std::string NumberText(const Field& field) {
  bool negative = false;
  std::string digits = Digits(field, negative);
  if (digits.size() < field.decimals + size_t{1}) digits.insert(0, field.decimals + size_t{1} - digits.size(), '0');
  if (field.decimals > 0) digits.insert(digits.size() - field.decimals, 1, '.');
  return (negative ? "-" : "") + digits;
}

std::string TextOf(const ir::Program& program, uint32_t number) {
  for (const ir::MessageText& text : program.messages) {
    if (text.number == number) return text.text;
  }
  return "message " + std::to_string(number);
}

}  // namespace

std::string MessageText(const ir::Program& program, uint32_t number, const dialects::ImagePort& image) {
  std::string text = TextOf(program, number);
  if (number > kMessagesWithNumber) return text;
  const Memory memory(program);
  const auto byte = [&](Space space, uint32_t address) {
    const Cell cell = memory.At(space, address);
    return image.Get(cell.space, cell.offset);
  };
  const uint32_t address = byte(Space::kF, kFirstNumberByte + number - 1);
  if (address == 0) return text;
  uint8_t bytes[kFieldBytes];
  for (uint32_t i = 0; i < kFieldBytes; ++i) bytes[i] = byte(Space::kD, address + i);
  Field field{.flags = bytes[0], .place = bytes[1], .decimals = bytes[2]};
  const uint32_t width = (field.flags & kIsDouble) != 0 ? 4 : 2;
  for (uint32_t i = 0; i < width; ++i) field.value |= uint32_t{bytes[3 + i]} << 8 * i;
  if ((field.flags & kShown) == 0) return text;

  const std::string shown = NumberText(field);
  const uint32_t line = field.place >> 6, column = field.place & kColumnMask;
  if (line > 0) return text + std::string(line, '\n') + std::string(column, ' ') + shown;
  size_t characters = 0;
  while (ByteOfCharacter(text, characters) < text.size()) ++characters;
  if (characters < column) text.append(column - characters, ' ');
  const size_t begin = ByteOfCharacter(text, column);
  const size_t end = begin + ByteOfCharacter(std::string_view(text).substr(begin), shown.size());
  return text.replace(begin, end - begin, shown);
}

}  // namespace plcxx::prostep
