#include "transpiler/dialects/prostep/lowering/cells.h"

#include "transpiler/support/check.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

/// Above all addresses of a space, types and bits: one number for each place.
uint32_t KeyOf(Space space, uint32_t address, Type type, uint8_t bit) {
  return static_cast<uint32_t>(space) << 24 | address << 8 | static_cast<uint32_t>(type) << 4 | bit;
}

}  // namespace

ir::PlaceId Cells::Bit(const Operand& operand) {
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

ir::PlaceId Cells::At(Space space, uint32_t address, Type type) {
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

ir::PlaceId Cells::Latch(uint32_t port) {
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

ValueId Cells::Load(Space space, uint32_t address, Type type) {
  if (ir::Bytes(type) <= memory_.At(space, address).left) return builder_.Load(At(space, address, type));
  if (type == Type::kI16) {
    const ValueId low = Load(space, address, Type::kI8), high = Load(space, address + 1, Type::kI8);
    return Pure(OpKind::kPair16, {low, high});
  }
  PLCXX_CHECK(type == Type::kI32);
  const ValueId low = Pure(OpKind::kWiden16To32, {Load(space, address, Type::kI16)});
  const ValueId high = Pure(OpKind::kWiden16To32, {Load(space, address + 2, Type::kI16)});
  return Pure(OpKind::kOr32, {low, Pure(OpKind::kMul32, {high, Number(0x10000)})});
}

void Cells::Store(Space space, uint32_t address, Type type, ValueId value) {
  if (ir::Bytes(type) <= memory_.At(space, address).left) return builder_.Store(At(space, address, type), value);
  if (type == Type::kI16) {
    Store(space, address, Type::kI8, Pure(OpKind::kLowByte16, {value}));
    return Store(space, address + 1, Type::kI8, Pure(OpKind::kHighByte16, {value}));
  }
  PLCXX_CHECK(type == Type::kI32);
  Store(space, address, Type::kI16, Pure(OpKind::kLowHalf32, {value}));
  Store(space, address + 2, Type::kI16, Pure(OpKind::kHighHalf32, {value}));
}

}  // namespace plcxx::prostep
