#include "transpiler/sim/last_writes.h"

namespace plcxx::sim {
namespace {

// A cell's key: 31 bits of owner and a mark for instances, 27 bits of byte, then the bit or 8 for the whole byte.
constexpr uint64_t kWhole = 8;
constexpr uint64_t MemoryCell(ir::SpaceId space, uint32_t offset, uint64_t bit) {
  return (uint64_t{space.index} << 36) | (uint64_t{offset} << 4) | bit;
}
constexpr uint64_t FieldCell(ir::StateId state, uint8_t field) {
  return (uint64_t{1} << 63) | (uint64_t{state.index} << 8) | field;
}

}  // namespace

void LastWrites::Note(Cell cell, const LastWrite& write) {
  std::vector<LastWrite>& writes = cells_[cell];
  if (!writes.empty()) {
    LastWrite& newest = writes.front();
    if (newest.writer == write.writer && newest.statement == write.statement && newest.value == write.value &&
        newest.accessed == write.accessed) {
      newest.last_ms = write.last_ms;
      return;
    }
  }
  if (writes.size() == kKept) writes.pop_back();
  writes.insert(writes.begin(), write);
}

void LastWrites::NoteByte(ir::SpaceId space, uint32_t offset, uint8_t mask, uint8_t byte, LastWrite write) {
  for (uint8_t bit = 0; bit < 8; ++bit) {
    if ((mask >> bit & 1) == 0) continue;
    write.value = byte >> bit & 1;
    Note(MemoryCell(space, offset, bit), write);
  }
  write.value = byte;
  Note(MemoryCell(space, offset, kWhole), write);
}

void LastWrites::NoteField(ir::StateId state, uint8_t field, LastWrite write) { Note(FieldCell(state, field), write); }

std::vector<LastWrite> LastWrites::Of(const ir::Place& place) const {
  const Cell cell = place.is_field()
                        ? FieldCell(place.state, place.field)
                        : MemoryCell(place.space, place.offset, place.type == ir::Type::kBit ? place.bit : kWhole);
  const auto found = cells_.find(cell);
  if (found == cells_.end()) return {};
  std::vector<LastWrite> writes = found->second;
  for (LastWrite& write : writes) {
    const uint32_t bytes = place.is_field() ? 1 : ir::Bytes(place.type);
    if (bytes > 1 && write.offset == place.offset && write.bytes == bytes) write.value = write.accessed;
  }
  return writes;
}

}  // namespace plcxx::sim
