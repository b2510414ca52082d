#include <algorithm>
#include <utility>

#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/gather.h"

namespace plcxx::execute {

Memory::Memory(terms::Terms& terms, const ir::Program& program, const Cells& cells, Environment environment)
    : terms_(&terms),
      program_(&program),
      cells_(&cells),
      environment_(std::move(environment)),
      values_(cells.count + environment_.notes),
      words_(values_.size()),
      written_(values_.size()),
      stamps_(values_.size()) {}

terms::TermId Memory::Read(CellId cell) {
  terms::TermId& value = values_[cell.index];
  if (value.valid()) return value;
  const WordBit& word = words_[cell.index];
  value = word.word.valid()            ? terms_->Extract(word.word, word.bit, 1)
          : cell.index < cells_->count ? environment_.initial(cell)
                                       : terms_->Const(0, 64);
  return value;
}

const std::vector<terms::TermId>& Memory::values() {
  for (uint32_t i = 0; i < values_.size(); ++i) {
    if (words_[i].word.valid()) Read(CellId(i));
  }
  return values_;
}

void Memory::NoteBefore(CellId cell) {
  if (open_stamps_.empty() || stamps_[cell.index] == open_stamps_.back()) return;
  undo_.back().push_back({.cell = cell,
                          .before = values_[cell.index],
                          .word_before = words_[cell.index],
                          .was_written = written_[cell.index],
                          .stamp = std::exchange(stamps_[cell.index], open_stamps_.back())});
}

void Memory::Write(CellId cell, terms::TermId value) {
  if (environment_.cut && cell.index < cells_->count) value = environment_.cut(cell, value);
  NoteBefore(cell);
  values_[cell.index] = value;
  words_[cell.index] = {};
  written_[cell.index] = true;
}

void Memory::BeginChanges() {
  undo_.emplace_back();
  open_stamps_.push_back(next_stamp_++);
}

std::vector<Memory::Change> Memory::TakeChanges() {
  std::vector<Change> changes;
  for (const Undo& undo : undo_.back()) {
    changes.push_back({undo.cell, Read(undo.cell)});
    values_[undo.cell.index] = undo.before;
    words_[undo.cell.index] = undo.word_before;
    written_[undo.cell.index] = undo.was_written;
    stamps_[undo.cell.index] = undo.stamp;
  }
  undo_.pop_back();
  open_stamps_.pop_back();
  std::ranges::sort(changes, {}, &Change::cell);
  return changes;
}

namespace {

CellId FieldCell(const Memory& memory, const ir::Place& place) {
  const ir::StateKind kind = memory.program().states[place.state].kind;
  return CellId(memory.cells().states[place.state.index] + meaning::FieldTermIndex(kind, place.field));
}

}  // namespace

terms::TermId Memory::WholeWord(std::span<const CellId> bits) const {
  const terms::TermId word = words_[bits.front().index].word;
  if (!word.valid() || terms_->Width(word) != bits.size()) return {};
  for (size_t i = 0; i < bits.size(); ++i) {
    const WordBit& at = words_[bits[i].index];
    if (at.word != word || at.bit != i) return {};
  }
  return word;
}

terms::TermId Memory::ReadPlace(const ir::Place& place) {
  if (place.is_field()) return Read(FieldCell(*this, place));
  if (place.type == ir::Type::kBit) return Read(cells_->OfBit(place.space, place.offset, place.bit));
  const std::vector<CellId> cells = CellsOf(*program_, *cells_, place);
  if (const terms::TermId word = WholeWord(cells); word.valid()) return word;
  std::vector<terms::TermId> bits;
  bool is_part = false;  // of a word that was written and is better kept
  for (const CellId cell : cells) {
    bits.push_back(Read(cell));
    is_part = is_part || words_[cell.index].word.valid();
  }
  const terms::TermId whole = terms::Gather(*terms_, bits);
  for (uint8_t bit = 0; !is_part && bit < cells.size(); ++bit) words_[cells[bit].index] = {.word = whole, .bit = bit};
  return whole;
}

void Memory::WritePlace(const ir::Place& place, terms::TermId value) {
  if (place.is_field()) {
    Write(FieldCell(*this, place), value);
    return;
  }
  if (place.type == ir::Type::kBit) {
    Write(cells_->OfBit(place.space, place.offset, place.bit), value);
    return;
  }
  const std::vector<CellId> cells = CellsOf(*program_, *cells_, place);
  const bool by_bit = environment_.cut && std::ranges::any_of(cells, [this](CellId cell) {
                        return !environment_.is_cut || environment_.is_cut(cell);
                      });
  uint8_t bit = 0;
  for (const CellId cell : cells) {
    if (by_bit) {
      Write(cell, terms_->Extract(value, bit, 1));
    } else {
      NoteBefore(cell);
      values_[cell.index] = {};
      words_[cell.index] = {.word = value, .bit = bit};
      written_[cell.index] = true;
    }
    ++bit;
  }
}

}  // namespace plcxx::execute
