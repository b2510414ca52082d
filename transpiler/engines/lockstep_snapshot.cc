#include "transpiler/engines/lockstep_snapshot.h"

#include "transpiler/ir/place_names.h"
#include "transpiler/support/check.h"

namespace plcxx::engines {
namespace {

/// Does the place hold one of `bits` of the byte `offset` of the space?
bool Holds(const ir::Place& place, ir::SpaceId space, uint32_t offset, uint8_t bits) {
  if (place.is_field() || place.indexed || place.space != space) return false;
  if (place.type == ir::Type::kBit) return place.offset == offset && (bits >> place.bit & 1) != 0;
  return place.offset <= offset && offset < place.offset + ir::Bytes(place.type);
}

bool Narrower(const ir::Place& a, const ir::Place& b) {
  if ((a.type == ir::Type::kBit) != (b.type == ir::Type::kBit)) return a.type == ir::Type::kBit;
  return ir::Bytes(a.type) < ir::Bytes(b.type);
}

SnapshotCell MemoryCell(const ir::Program& program, ir::SpaceId space, size_t base, uint32_t offset, uint8_t bits) {
  const ir::Place* found = nullptr;
  for (const ir::Place& place : program.places) {
    if (Holds(place, space, offset, bits) && (found == nullptr || Narrower(place, *found))) found = &place;
  }
  const bool big_endian = program.spaces[space].order == ir::ByteOrder::kBig;
  if (found != nullptr) {
    const uint8_t bit = found->type == ir::Type::kBit ? found->bit : uint8_t{0};
    return {ir::SourceName(*found), *found, found->type, base + found->offset, bit, big_endian};
  }
  ir::Place byte;
  byte.name = program.spaces[space].name + " byte " + std::to_string(offset);
  byte.type = ir::Type::kI8;
  byte.space = space;
  byte.offset = offset;
  return {byte.name, byte, byte.type, base + offset, 0, big_endian};
}

SnapshotCell FieldCell(const ir::Program& program, ir::StateId state, uint8_t field, size_t base, size_t at) {
  const ir::StateInstance& instance = program.states[state];
  const ir::FieldInfo& info = ir::Info(instance.kind).fields[field];
  if (info.count > 1) {
    const size_t size = ir::Bytes(info.type);
    const size_t element = (at - base) / size;
    const std::string name = instance.name + "." + std::string(info.name) + "[" + std::to_string(element) + "]";
    return {name, std::nullopt, info.type, base + element * size, 0, false};
  }
  for (const ir::Place& place : program.places) {
    if (place.is_field() && place.state == state && place.field == field)
      return {ir::SourceName(place), place, info.type, base, 0, false};
  }
  return {instance.name + "." + std::string(info.name), std::nullopt, info.type, base, 0, false};
}

}  // namespace

SnapshotCell CellAt(const ir::Program& program, size_t at, uint8_t bits) {
  size_t base = 0;
  for (uint32_t s = 0; s < program.spaces.size(); ++s) {
    const ir::Space& space = program.spaces[ir::SpaceId(s)];
    if (!space.host_visible) continue;
    if (at < base + space.bytes)
      return MemoryCell(program, ir::SpaceId(s), base, static_cast<uint32_t>(at - base), bits);
    base += space.bytes;
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const auto fields = ir::Info(program.states[ir::StateId(i)].kind).fields;
    for (uint8_t f = 0, count = static_cast<uint8_t>(fields.size()); f < count; ++f) {
      const size_t size = size_t{ir::Bytes(fields[f].type)} * fields[f].count;
      if (at < base + size) return FieldCell(program, ir::StateId(i), f, base, at);
      base += size;
    }
  }
  PLCXX_UNREACHABLE();
}

uint64_t CellValue(const SnapshotCell& cell, const std::vector<uint8_t>& snapshot) {
  if (cell.type == ir::Type::kBit) return snapshot[cell.at] >> cell.bit & 1;
  const uint32_t bytes = ir::Bytes(cell.type);
  uint64_t value = 0;
  for (uint32_t i = 0; i < bytes; ++i) {
    const uint32_t significance = cell.big_endian ? bytes - 1 - i : i;
    value |= static_cast<uint64_t>(snapshot[cell.at + i]) << (8 * significance);
  }
  return value;
}

}  // namespace plcxx::engines
