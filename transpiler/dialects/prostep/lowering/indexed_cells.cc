#include "transpiler/dialects/prostep/lowering/indexed_cells.h"

#include <utility>

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

ir::PlaceId IndexedCells::PlaceOf(ir::SpaceId space, Type type, std::string name, uint32_t low, uint32_t high) {
  const auto [found, is_new] = places_.try_emplace(name);
  if (is_new) {
    found->second = program_.places.Add({.name = std::move(name),
                                         .address = {},
                                         .type = type,
                                         .space = space,
                                         .offset = 0,
                                         .indexed = true,
                                         .stride = 1,
                                         .low = low,
                                         .high = high});
  }
  return found->second;
}

/// The parts of D that byte `number` of an access of `bytes` bytes may lie in: visit(indexed place, address of its
/// first byte). The parts at the ends of D are clipped, so that both bytes of a word are inside or both are not.
template <class Visit>
void IndexedCells::ForEachPart(uint32_t number, uint32_t bytes, Visit&& visit) {
  for (const Memory::Part& part : memory_.DataParts()) {
    if (!part.space.valid()) continue;
    const bool is_last = part.first + part.bytes == BytesOf(Space::kD);
    const uint32_t low = part.first == 0 ? number : 0;
    const uint32_t high = part.bytes - (is_last ? bytes - 1 - number : 0);
    if (low >= high) continue;  // one byte at an end of D: no access lies in it with this byte
    std::string name = "DB_from_" + std::to_string(part.first);
    if (bytes > 1) name += number == 0 ? "_low" : "_high";
    visit(PlaceOf(part.space, Type::kI8, std::move(name), low, high), part.first);
  }
}

ValueId IndexedCells::Moved(ValueId address, uint32_t by) {
  return by == 0 ? address : Pure(OpKind::kAdd32, {address, Number(by)});
}

ValueId IndexedCells::Load(Space space, ValueId address, Type type) {
  const uint32_t bytes = ir::Bytes(type);
  if (space != Space::kD) {
    const std::string name = NameText(space, 0, type, 0) + "_any";
    return builder_.Load(PlaceOf(memory_.At(space, 0).space, type, name, 0, BytesOf(space)), address);
  }
  ValueId word;
  for (uint32_t number = 0; number < bytes; ++number) {
    ValueId byte;
    ForEachPart(number, bytes, [&](ir::PlaceId place, uint32_t first) {
      const ValueId value = builder_.Load(place, Moved(address, number - first));
      byte = byte.valid() ? Pure(OpKind::kOr8, {byte, value}) : value;  // outside its part it is 0
    });
    word = number == 0 ? byte : Pure(OpKind::kPair16, {word, byte});
  }
  return word;
}

void IndexedCells::Store(Space space, ValueId address, Type type, ValueId value) {
  const uint32_t bytes = ir::Bytes(type);
  if (space != Space::kD) {
    const std::string name = NameText(space, 0, type, 0) + "_any";
    return builder_.Store(PlaceOf(memory_.At(space, 0).space, type, name, 0, BytesOf(space)), value, address);
  }
  for (uint32_t number = 0; number < bytes; ++number) {
    ValueId byte = value;
    if (bytes > 1) byte = Pure(number == 0 ? OpKind::kLowByte16 : OpKind::kHighByte16, {value});
    ForEachPart(number, bytes, [&](ir::PlaceId place, uint32_t first) {
      builder_.Store(place, byte, Moved(address, number - first));
    });
  }
}

}  // namespace plcxx::prostep
