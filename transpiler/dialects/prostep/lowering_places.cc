// Operands as places of the memory map (specification section 5).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

struct ScalarRow {
  ScalarPlace scalar;
  SpaceKey space;
  std::string_view name;
  Type type;
  uint32_t offset;
};
constexpr ScalarRow kScalars[] = {
    {ScalarPlace::kNow, SpaceKey::kSystem, "now", Type::kI32, 0},
    {ScalarPlace::kOfSecond, SpaceKey::kSystem, "ms_of_second", Type::kI32, 4},
    {ScalarPlace::kSlowDone, SpaceKey::kSystem, "slow_done", Type::kI32, 8},
    {ScalarPlace::kSlowRounds, SpaceKey::kSystem, "slow_rounds", Type::kI32, 12},
    {ScalarPlace::kRounds, SpaceKey::kSystem, "rounds_left", Type::kI32, 16},
    {ScalarPlace::kNextSlice, SpaceKey::kSystem, "next_slice", Type::kI8, 20},
    {ScalarPlace::kS, SpaceKey::kRegisters, "s", Type::kBit, 0},
    {ScalarPlace::kAx, SpaceKey::kRegisters, "ax", Type::kI16, 2},
    {ScalarPlace::kFirst, SpaceKey::kRegisters, "first", Type::kBit, 4},
    {ScalarPlace::kNcValue, SpaceKey::kRegisters, "nc_value", Type::kI32, 8},
    {ScalarPlace::kPortWord, SpaceKey::kRegisters, "port_word", Type::kI16, 12},
};

/// Above all addresses of a space, types and bits: one number for each place.
uint32_t KeyOf(Space space, uint32_t address, Type type, uint8_t bit) {
  return static_cast<uint32_t>(space) << 24 | address << 8 | static_cast<uint32_t>(type) << 4 | bit;
}

}  // namespace

ir::PlaceId Lowering::PlaceOf(ScalarPlace scalar) {
  ir::PlaceId& id = scalars_[static_cast<size_t>(scalar)];
  if (!id.valid()) {
    const ScalarRow& row = kScalars[static_cast<size_t>(scalar)];
    PLCXX_CHECK(row.scalar == scalar);
    id = program_.places.Add({.name = std::string(row.name),
                              .type = row.type,
                              .space = memory_[row.space],
                              .offset = row.offset,
                              .bit = row.type == Type::kBit ? uint8_t{0} : ir::kNoBit});
  }
  return id;
}

ir::PlaceId Lowering::BitPlace(const Operand& operand) {
  const Space space = operand.space();
  const auto [found, is_new] = places_.try_emplace(KeyOf(space, operand.number, Type::kBit, operand.bit));
  if (is_new) {
    const Cell cell =
        space == Space::kP ? Cell{memory_[SpaceKey::kLatches], operand.number, 1} : memory_.At(space, operand.number);
    found->second = program_.places.Add({.name = NameText(space, operand.number, Type::kBit, operand.bit),
                                         .address = ToText(operand),
                                         .type = Type::kBit,
                                         .space = cell.space,
                                         .offset = cell.offset,
                                         .bit = operand.bit});
  }
  return found->second;
}

ir::PlaceId Lowering::PlaceAt(Space space, uint32_t address, Type type) {
  const auto [found, is_new] = places_.try_emplace(KeyOf(space, address, type, 0));
  if (is_new) {
    const Cell cell = memory_.At(space, address);
    found->second = program_.places.Add({.name = NameText(space, address, type, 0),
                                         .address = AddressText(space, address, type, 0),
                                         .type = type,
                                         .space = cell.space,
                                         .offset = cell.offset});
  }
  return found->second;
}

ir::PlaceId Lowering::LatchPlace(uint32_t port) {
  const auto [found, is_new] = places_.try_emplace(KeyOf(Space::kP, port, Type::kI8, 0));
  if (is_new) {
    found->second = program_.places.Add({.name = NameText(Space::kP, port, Type::kI8, 0),
                                         .address = AddressText(Space::kP, port, Type::kI8, 0),
                                         .type = Type::kI8,
                                         .space = memory_[SpaceKey::kLatches],
                                         .offset = port});
  }
  return found->second;
}

/// A value that lies across the border of two parts of D is put together from its halves.
ValueId Lowering::LoadAt(Space space, uint32_t address, Type type) {
  if (ir::Bytes(type) <= memory_.At(space, address).left) return builder_.Load(PlaceAt(space, address, type));
  if (type == Type::kI16) {
    const ValueId low = LoadAt(space, address, Type::kI8), high = LoadAt(space, address + 1, Type::kI8);
    return builder_.Pure(OpKind::kPair16, {low, high});
  }
  PLCXX_CHECK(type == Type::kI32);
  const ValueId low = builder_.Pure(OpKind::kWiden16To32, {LoadAt(space, address, Type::kI16)});
  const ValueId high = builder_.Pure(OpKind::kWiden16To32, {LoadAt(space, address + 2, Type::kI16)});
  return builder_.Pure(OpKind::kOr32, {low, builder_.Pure(OpKind::kMul32, {high, Number(0x10000)})});
}

void Lowering::StoreAt(Space space, uint32_t address, Type type, ValueId value) {
  if (ir::Bytes(type) <= memory_.At(space, address).left) return builder_.Store(PlaceAt(space, address, type), value);
  if (type == Type::kI16) {
    StoreAt(space, address, Type::kI8, builder_.Pure(OpKind::kLowByte16, {value}));
    return StoreAt(space, address + 1, Type::kI8, builder_.Pure(OpKind::kHighByte16, {value}));
  }
  PLCXX_CHECK(type == Type::kI32);
  StoreAt(space, address, Type::kI16, builder_.Pure(OpKind::kLowHalf32, {value}));
  StoreAt(space, address + 2, Type::kI16, builder_.Pure(OpKind::kHighHalf32, {value}));
}

ir::PlaceId Lowering::IndexedPlace(ir::SpaceId space, Type type, std::string name, uint32_t low, uint32_t high) {
  const auto [found, is_new] = indexed_.try_emplace(name);
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

/// The parts of D that byte `behind` of an access of `bytes` bytes may lie in: visit(indexed place, address of its
/// first byte). The parts at the ends of D are clipped, so that both bytes of a word are inside or both are not.
template <class Visit>
void Lowering::ForEachPart(uint32_t behind, uint32_t bytes, Visit&& visit) {
  for (const Memory::Part& part : memory_.DataParts()) {
    if (!part.space.valid()) continue;
    const bool is_last = part.first + part.bytes == BytesOf(Space::kD);
    const uint32_t low = part.first == 0 ? behind : 0;
    const uint32_t high = part.bytes - (is_last ? bytes - 1 - behind : 0);
    if (low >= high) continue;  // one byte at an end of D: no access lies in it with this byte
    std::string name = "DB_from_" + std::to_string(part.first);
    if (bytes > 1) name += behind == 0 ? "_low" : "_high";
    visit(IndexedPlace(part.space, Type::kI8, std::move(name), low, high), part.first);
  }
}

ValueId Lowering::Moved(ValueId address, uint32_t by) {
  return by == 0 ? address : builder_.Pure(OpKind::kAdd32, {address, Number(by)});
}

ValueId Lowering::LoadIndexed(Space space, ValueId address, Type type) {
  const uint32_t bytes = ir::Bytes(type);
  if (space != Space::kD) {
    const std::string name = NameText(space, 0, type, 0) + "_any";
    return builder_.Load(IndexedPlace(memory_.At(space, 0).space, type, name, 0, BytesOf(space)), address);
  }
  ValueId word;
  for (uint32_t behind = 0; behind < bytes; ++behind) {
    ValueId byte;
    ForEachPart(behind, bytes, [&](ir::PlaceId place, uint32_t first) {
      const ValueId value = builder_.Load(place, Moved(address, behind - first));
      byte = byte.valid() ? builder_.Pure(OpKind::kOr8, {byte, value}) : value;  // outside its part it is 0
    });
    word = behind == 0 ? byte : builder_.Pure(OpKind::kPair16, {word, byte});
  }
  return word;
}

void Lowering::StoreIndexed(Space space, ValueId address, Type type, ValueId value) {
  const uint32_t bytes = ir::Bytes(type);
  if (space != Space::kD) {
    const std::string name = NameText(space, 0, type, 0) + "_any";
    return builder_.Store(IndexedPlace(memory_.At(space, 0).space, type, name, 0, BytesOf(space)), value, address);
  }
  for (uint32_t behind = 0; behind < bytes; ++behind) {
    ValueId byte = value;
    if (bytes > 1) byte = builder_.Pure(behind == 0 ? OpKind::kLowByte16 : OpKind::kHighByte16, {value});
    ForEachPart(behind, bytes, [&](ir::PlaceId place, uint32_t first) {
      builder_.Store(place, byte, Moved(address, behind - first));
    });
  }
}

}  // namespace plcxx::prostep
