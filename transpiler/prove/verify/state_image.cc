#include "transpiler/prove/verify/state_image.h"

#include <algorithm>
#include <array>

#include "transpiler/support/fnv1a.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/gather.h"

namespace plcxx::prove::verify {
namespace {

constexpr uint32_t kNowhere = 0xFFFFFFFF;
constexpr uint32_t kHashBytes = 4;  // in front of the retentive bytes

}  // namespace

StateImage::StateImage(const ir::Program& program, const emit::layout::Layout& layout, const execute::Cells& cells)
    : program_(program),
      layout_(layout),
      cells_(cells),
      bytes_(layout.size),
      places_(cells.count, kNowhere),
      units_(layout.size),
      unit_bytes_(layout.size, 1) {
  for (uint32_t i = 0; i < layout.size; ++i) units_[i] = i;
  for (const emit::layout::Member& member : layout.members) {
    const bool words = member.name.starts_with("word") || member.name.starts_with("float");
    if (member.name == "retentive") {
      retentive_begin_ = member.offset;
      retentive_end_ = member.offset + kHashBytes + layout.retentive_bytes;
      for (uint32_t i = 0; i < kHashBytes; ++i)
        bytes_[member.offset + i] = {.kind = ByteKind::kLayout, .low = static_cast<uint8_t>(8 * i)};
    }
    if (!words) continue;
    for (uint32_t i = 0; i < member.count * member.element_bytes; ++i) {
      units_[member.offset + i] = member.offset + i / member.element_bytes * member.element_bytes;
      unit_bytes_[member.offset + i] = static_cast<uint8_t>(member.element_bytes);
    }
  }
  PlaceSpaces();
  PlaceStates();
  for (const StateByte& byte : bytes_)
    is_bit_.push_back(byte.kind == ByteKind::kCell &&
                      execute::CellWidth(program, execute::CellAt(program, cells, byte.cell)) == 1);
  HashLayout();
}

void StateImage::HashLayout() {
  if (retentive_end_ == 0) return;
  std::string text = program_.dialect;
  for (const ir::Space& space : program_.spaces) {
    if (space.lifetime == ir::Lifetime::kRetentive) text += " " + space.name + "[" + std::to_string(space.bytes) + "]";
  }
  layout_hash_ = support::HashOf32(text);  // as plcxx::LayoutHash has it
}

void StateImage::PlaceSpaces() {
  for (uint32_t s = 0; s < layout_.bytes.size(); ++s) {
    for (uint32_t b = 0; b < layout_.bytes[s].size(); ++b) {
      const emit::layout::ByteStorage& stored = layout_.bytes[s][b];
      const execute::CellId first = cells_.OfBit(ir::SpaceId(s), b, 0);
      if (stored.whole.storage != emit::layout::Storage::kNone) {
        bytes_[stored.whole.offset] = {.kind = ByteKind::kBits, .cell = first};
        std::fill_n(places_.begin() + first.index, 8, stored.whole.offset);
        continue;
      }
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if (stored.bits[bit].storage == emit::layout::Storage::kNone) continue;
        const execute::CellId cell = cells_.OfBit(ir::SpaceId(s), b, bit);
        bytes_[stored.bits[bit].offset] = {.kind = ByteKind::kCell, .cell = cell};
        places_[cell.index] = stored.bits[bit].offset;
      }
    }
  }
}

void StateImage::PlaceStates() {
  for (uint32_t i = 0; i < program_.states.size(); ++i) {
    const ir::StateKind kind = program_.states[ir::StateId(i)].kind;
    uint32_t cell = cells_.states[i];
    const auto fields = ir::Info(kind).fields;
    for (size_t field = 0; field < fields.size(); ++field) {
      const uint32_t width = ir::Bytes(fields[field].type);
      for (uint32_t element = 0; element < fields[field].count; ++element, ++cell) {
        const uint32_t offset =
            layout_.states[i].offset + emit::layout::FieldOffset(kind, static_cast<uint8_t>(field)) + element * width;
        places_[cell] = offset;
        for (uint32_t byte = 0; byte < width; ++byte) {
          bytes_[offset + byte] = {
              .kind = ByteKind::kCell, .cell = execute::CellId(cell), .low = static_cast<uint8_t>(8 * byte)};
        }
      }
    }
  }
}

terms::TermId StateImage::Variable(terms::Terms& terms, terms::TermId& variable, const std::string& name,
                                   uint8_t width) const {
  if (!variable.valid()) variable = terms.Variable(name, width);
  return variable;
}

void StateImage::MakeVariables(terms::Terms&) {
  units_before_.assign(bytes_.size(), terms::TermId());
  cells_before_.assign(cells_.count, terms::TermId());
  hash_before_ = terms::TermId();
}

terms::TermId StateImage::HashBefore(terms::Terms& terms) {
  return Variable(terms, hash_before_, "retentive.layout", 32);
}

terms::TermId StateImage::CellBefore(terms::Terms& terms, execute::CellId id) {
  const uint32_t offset = places_[id.index];
  const execute::Cell cell = execute::CellAt(program_, cells_, id);
  if (offset != kNowhere && bytes_[offset].kind == ByteKind::kBits) {
    const uint32_t unit = units_[offset];
    const terms::TermId word =
        Variable(terms, units_before_[unit], NameOf(unit), static_cast<uint8_t>(8 * unit_bytes_[unit]));
    return terms.Extract(word, static_cast<uint8_t>(8 * (offset - unit) + cell.bit), 1);
  }
  return Variable(terms, cells_before_[id.index], execute::CellName(program_, cell),
                  execute::CellWidth(program_, cell));
}

terms::TermId StateImage::ByteBefore(terms::Terms& terms, uint32_t offset) {
  if (bytes_[offset].kind == ByteKind::kNothing)
    return Variable(terms, units_before_[offset], "padding " + std::to_string(offset), 8);
  return ByteFor(terms, offset, [&](execute::CellId cell) { return CellBefore(terms, cell); }, HashBefore(terms));
}

terms::TermId StateImage::CellAtPowerOn(terms::Terms& terms, execute::CellId id) const {
  const execute::Cell cell = execute::CellAt(program_, cells_, id);
  const uint8_t width = execute::CellWidth(program_, cell);
  if (cell.kind != execute::CellKind::kBit) return terms.Const(0, width);
  const std::vector<ir::InitialByte>& initial = program_.spaces[cell.space].initial;
  const auto at = std::ranges::lower_bound(initial, cell.offset, {}, &ir::InitialByte::offset);
  const bool there = at != initial.end() && at->offset == cell.offset;
  return terms.Const(there ? (at->value >> cell.bit & 1U) : 0U, width);
}

terms::TermId StateImage::ByteFor(terms::Terms& terms, uint32_t offset,
                                  const std::function<terms::TermId(execute::CellId)>& cell, terms::TermId hash) const {
  const StateByte& byte = bytes_[offset];
  switch (byte.kind) {
    case ByteKind::kNothing:
      break;
    case ByteKind::kLayout:
      return terms.Extract(hash, byte.low, 8);
    case ByteKind::kCell: {
      const terms::TermId value = cell(byte.cell);
      return terms.Width(value) < 8 ? terms.Zext(value, 8) : terms.Extract(value, byte.low, 8);
    }
    case ByteKind::kBits: {
      std::array<terms::TermId, 8> bits;
      for (uint32_t bit = 0; bit < 8; ++bit) bits[bit] = cell(execute::CellId(byte.cell.index + bit));
      return terms::Gather(terms, bits);
    }
  }
  PLCXX_UNREACHABLE();
}

std::string StateImage::NameOf(uint32_t offset) const {
  const StateByte& byte = bytes_[offset];
  if (byte.kind == ByteKind::kNothing) return "padding " + std::to_string(offset);
  if (byte.kind == ByteKind::kLayout) return "retentive.layout";
  const execute::Cell cell = execute::CellAt(program_, cells_, byte.cell);
  if (byte.kind == ByteKind::kBits) return program_.spaces[cell.space].name + "." + std::to_string(cell.offset);
  return execute::CellName(program_, cell);
}

}  // namespace plcxx::prove::verify
