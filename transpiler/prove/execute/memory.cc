#include <algorithm>
#include <utility>

#include "transpiler/prove/execute/execute.h"
#include "transpiler/prove/meaning/meaning.h"
#include "transpiler/prove/terms/gather.h"

namespace plcxx::prove {

Memory::Memory(Terms& terms, const ir::Program& program, const Cells& cells, Environment environment)
    : terms_(&terms),
      program_(&program),
      cells_(&cells),
      environment_(std::move(environment)),
      values_(cells.count),
      written_(cells.count),
      stamps_(cells.count) {}

TermId Memory::Read(CellId cell) {
  TermId& value = values_[cell.index];
  if (!value.valid()) value = environment_.initial(cell);
  return value;
}

void Memory::Write(CellId cell, TermId value) {
  if (environment_.cut) value = environment_.cut(cell, value);
  if (!open_stamps_.empty() && stamps_[cell.index] != open_stamps_.back()) {
    undo_.back().push_back({.cell = cell,
                            .before = Read(cell),
                            .was_written = written_[cell.index],
                            .stamp = std::exchange(stamps_[cell.index], open_stamps_.back())});
  }
  values_[cell.index] = value;
  written_[cell.index] = true;
}

void Memory::BeginChanges() {
  undo_.emplace_back();
  open_stamps_.push_back(next_stamp_++);
}

std::vector<Memory::Change> Memory::TakeChanges() {
  std::vector<Change> changes;
  for (const Undo& undo : undo_.back()) {
    changes.push_back({undo.cell, values_[undo.cell.index]});
    values_[undo.cell.index] = undo.before;
    written_[undo.cell.index] = undo.was_written;
    stamps_[undo.cell.index] = undo.stamp;
  }
  undo_.pop_back();
  open_stamps_.pop_back();
  std::ranges::sort(changes, {}, &Change::cell);
  return changes;
}

namespace {

/// The byte of a value (0 = the least significant) that stands at byte `at` of a place of `bytes` bytes.
uint32_t SignificanceOf(const ir::Space& space, uint32_t at, uint32_t bytes) {
  return space.order == ir::ByteOrder::kBig ? bytes - 1 - at : at;
}

CellId FieldCell(const Memory& memory, const ir::Place& place) {
  const ir::StateKind kind = memory.program().states[place.state].kind;
  return CellId(memory.cells().states[place.state.index] + FieldTermIndex(kind, place.field));
}

}  // namespace

TermId Memory::ReadPlace(const ir::Place& place) {
  if (place.is_field()) return Read(FieldCell(*this, place));
  if (place.type == ir::Type::kBit) return Read(cells_->OfBit(place.space, place.offset, place.bit));
  const uint32_t bytes = ir::Bytes(place.type);
  const ir::Space& space = program_->spaces[place.space];
  std::vector<TermId> parts;  // from the least significant bit up
  for (uint32_t significance = 0; significance < bytes; ++significance) {
    const uint32_t at = place.offset + SignificanceOf(space, significance, bytes);
    for (uint8_t bit = 0; bit < 8; ++bit) parts.push_back(Read(cells_->OfBit(place.space, at, bit)));
  }
  return Gather(*terms_, parts);
}

void Memory::WritePlace(const ir::Place& place, TermId value) {
  if (place.is_field()) {
    Write(FieldCell(*this, place), value);
    return;
  }
  if (place.type == ir::Type::kBit) {
    Write(cells_->OfBit(place.space, place.offset, place.bit), value);
    return;
  }
  const uint32_t bytes = ir::Bytes(place.type);
  const ir::Space& space = program_->spaces[place.space];
  for (uint32_t significance = 0; significance < bytes; ++significance) {
    const uint32_t at = place.offset + SignificanceOf(space, significance, bytes);
    for (uint8_t bit = 0; bit < 8; ++bit) {
      Write(cells_->OfBit(place.space, at, bit),
            terms_->Extract(value, static_cast<uint8_t>(8 * significance + bit), 1));
    }
  }
}

}  // namespace plcxx::prove
