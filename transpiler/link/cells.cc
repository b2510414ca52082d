#include "transpiler/link/cells.h"

#include <algorithm>

namespace plcxx::debug_link {
namespace {

using emit::layout::ByteStorage;
using emit::layout::Layout;
using emit::layout::Storage;

/// A byte of a space, or one bit of it; nothing where it is nowhere.
void AddByte(const ByteStorage& stored, uint8_t first, uint8_t bits, uint8_t at, std::vector<Cell>& cells) {
  if (stored.whole.storage != Storage::kNone) {
    cells.push_back({.offset = stored.whole.offset, .bit = first, .bits = bits, .at = at});
    return;
  }
  for (uint8_t i = 0; i < bits; ++i) {
    const emit::layout::PlaceStorage& bit = stored.bits[first + i];
    if (bit.storage == Storage::kNone) continue;
    cells.push_back({.offset = bit.offset, .bit = 0, .bits = 1, .at = static_cast<uint8_t>(at + i)});
  }
}

std::vector<Cell> CellsOfField(const ir::Program& program, const Layout& layout, const ir::Place& place) {
  const ir::StateKind kind = program.states[place.state].kind;
  const uint32_t offset = layout.states[place.state.index].offset + emit::layout::FieldOffset(kind, place.field);
  if (place.type == ir::Type::kBit) return {{.offset = offset, .bit = 0, .bits = 1, .at = 0}};
  std::vector<Cell> cells;
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
    cells.push_back({.offset = offset + i, .bit = 0, .bits = 8, .at = static_cast<uint8_t>(8 * i)});
  }
  return cells;
}

}  // namespace

std::vector<Cell> CellsOf(const ir::Program& program, const Layout& layout, const ir::Place& place) {
  if (place.is_field()) return CellsOfField(program, layout, place);
  std::vector<Cell> cells;
  const std::vector<ByteStorage>& bytes = layout.bytes[place.space.index];
  if (place.type == ir::Type::kBit) {
    if (place.offset < bytes.size()) AddByte(bytes[place.offset], place.bit, 1, 0, cells);
    return cells;
  }
  const uint32_t size = ir::Bytes(place.type);
  const bool is_big = program.spaces[place.space].order == ir::ByteOrder::kBig;
  for (uint32_t i = 0; i < size; ++i) {
    const uint32_t offset = place.offset + (is_big ? size - 1 - i : i);
    if (offset < bytes.size()) AddByte(bytes[offset], 0, 8, static_cast<uint8_t>(8 * i), cells);
  }
  return cells;
}

std::vector<Run> RunsOf(const std::vector<Cell>& cells, uint32_t most) {
  std::vector<uint32_t> offsets;
  for (const Cell& cell : cells) offsets.push_back(cell.offset);
  std::ranges::sort(offsets);
  std::vector<Run> runs;
  for (const uint32_t offset : offsets) {
    if (!runs.empty() && offset < runs.back().offset + runs.back().bytes) continue;
    if (!runs.empty() && offset == runs.back().offset + runs.back().bytes && runs.back().bytes < most) {
      ++runs.back().bytes;
    } else {
      runs.push_back({.offset = offset, .bytes = 1});
    }
  }
  return runs;
}

uint64_t ValueOf(const std::vector<Cell>& cells, const KnownBytes& bytes) {
  uint64_t value = 0;
  for (const Cell& cell : cells) {
    const auto found = bytes.find(cell.offset);
    if (found == bytes.end()) continue;
    const uint64_t part = (found->second >> cell.bit) & ((1u << cell.bits) - 1);
    value |= part << cell.at;
  }
  return value;
}

std::vector<MaskedRun> WritesOf(const std::vector<Cell>& cells, uint64_t value, uint32_t most) {
  std::vector<MaskedRun> writes;
  for (const Run& run : RunsOf(cells, most)) {
    MaskedRun write{.offset = run.offset, .masks = Bytes(run.bytes), .values = Bytes(run.bytes)};
    for (const Cell& cell : cells) {
      if (cell.offset < run.offset || cell.offset - run.offset >= run.bytes) continue;
      const uint32_t mask = (1u << cell.bits) - 1;
      write.masks[cell.offset - run.offset] |= static_cast<uint8_t>(mask << cell.bit);
      write.values[cell.offset - run.offset] |= static_cast<uint8_t>(((value >> cell.at) & mask) << cell.bit);
    }
    writes.push_back(std::move(write));
  }
  return writes;
}

}  // namespace plcxx::debug_link
