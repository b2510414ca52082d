// What the bytes of the generated State hold: the cells of the program, byte by byte.
//
// In: a program and its layout. Out: for each byte which cells it is made of, the terms that both sides begin with, and
// what a byte has to be for given cells. A bit that has a byte of its own is 0 or 1 there: assumed before, shown after.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

enum class ByteKind : uint8_t {
  kNothing,  // padding
  kBits,     // eight cells of width 1, the least significant first
  kCell,     // eight bits of one cell, from `low` on; of a cell of width 1 the byte is 0 or 1
  kLayout    // of the retentive block's hash, from bit `low` on
};

struct StateByte {
  ByteKind kind = ByteKind::kNothing;
  execute::CellId cell;  // kBits: the first
  uint8_t low = 0;       // bit of the cell
};

class StateImage {
 public:
  StateImage(const ir::Program& program, const emit::layout::Layout& layout, const execute::Cells& cells);

  uint32_t size() const { return static_cast<uint32_t>(bytes_.size()); }
  const StateByte& operator[](uint32_t offset) const { return bytes_[offset]; }
  /// Whether a byte is a bit of its own, 0 or 1.
  bool IsBit(uint32_t offset) const { return is_bit_[offset]; }
  /// Where the retentive block begins and ends, its hash included; both 0 when there is none.
  uint32_t retentive_begin() const { return retentive_begin_; }
  uint32_t retentive_end() const { return retentive_end_; }
  uint32_t layout_hash() const { return layout_hash_; }

  /// Variables for all that State holds, one for each word, byte, bit or field.
  void MakeVariables(terms::Terms& terms);
  /// What a cell is before a routine, by these variables; of what State does not hold a variable of its own.
  terms::TermId CellBefore(terms::Terms& terms, execute::CellId cell);
  /// What a byte of State is before a routine: of padding some variable.
  terms::TermId ByteBefore(terms::Terms& terms, uint32_t offset);
  /// At power-on.
  terms::TermId CellAtPowerOn(terms::Terms& terms, execute::CellId cell) const;

  /// What a byte is for these cells and hash; not of padding.
  terms::TermId ByteFor(terms::Terms& terms, uint32_t offset, const std::function<terms::TermId(execute::CellId)>& cell,
                        terms::TermId hash) const;
  /// The hash before a routine.
  terms::TermId HashBefore(terms::Terms& terms);

  /// "U.10.3", "T5.elapsed_ms".
  std::string NameOf(uint32_t offset) const;

 private:
  void PlaceSpaces();
  void PlaceStates();
  void HashLayout();
  terms::TermId Variable(terms::Terms& terms, terms::TermId& variable, const std::string& name, uint8_t width) const;

  const ir::Program& program_;
  const emit::layout::Layout& layout_;
  const execute::Cells& cells_;
  std::vector<StateByte> bytes_;
  std::vector<bool> is_bit_;         // by offset
  std::vector<uint32_t> places_;     // by CellId: the byte of State that holds it, or its first; kNowhere: none
  std::vector<uint32_t> units_;      // by offset: first byte of the word that it belongs to
  std::vector<uint8_t> unit_bytes_;  // by offset of that first byte
  std::vector<terms::TermId> units_before_;
  std::vector<terms::TermId> cells_before_;
  terms::TermId hash_before_;
  uint32_t retentive_begin_ = 0, retentive_end_ = 0, layout_hash_ = 0;
};

}  // namespace plcxx::prove::verify
