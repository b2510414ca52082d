#include "transpiler/prove/diff/pairing.h"

#include <string>

#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::prove::diff {
namespace {

/// The bytes that a place of a byte or more touches.
std::vector<bool> WordBytes(const machine::Version& version) {
  std::vector<bool> words(version.cells.count);
  for (const ir::Place& place : version.program->places) {
    if (place.is_field() || place.type == ir::Type::kBit) continue;
    const uint32_t size = version.program->spaces[place.space].bytes;
    const uint32_t begin = place.indexed ? place.low : place.offset;
    const uint32_t end = place.indexed ? place.high : place.offset + ir::Bytes(place.type);
    for (uint32_t offset = begin; offset < end && offset < size; ++offset) {
      words[version.cells.OfBit(place.space, offset, 0).index] = true;
    }
  }
  return words;
}

}  // namespace

Pairing::Pairing(terms::Terms& terms, const machine::Version& old_version, const machine::Version& new_version,
                 const Match& match)
    : terms_(terms),
      old_(old_version),
      new_(new_version),
      match_(match),
      equal_(old_version.cells.count),
      old_words_(WordBytes(old_version)),
      new_words_(WordBytes(new_version)) {
  for (uint32_t i = 0; i < old_version.cells.count; ++i) equal_[i] = match.new_of_old[i].valid();
}

terms::TermId& Pairing::VariableOf(Owner owner, uint32_t cell, Extent extent) {
  return variables_[uint64_t{cell} << 3 | static_cast<uint64_t>(owner) << 1 | static_cast<uint64_t>(extent)];
}

std::string Pairing::PrefixOf(Owner owner) {
  switch (owner) {
    case Owner::kOld:
      return "old ";
    case Owner::kNew:
      return "new ";
    case Owner::kBoth:
      break;
  }
  return {};
}

/// All bits of the byte are equal, and the other version has them in one byte, too.
bool Pairing::SharesByte(execute::CellId first) const {
  const execute::CellId partner = match_.new_of_old[first.index];
  for (uint32_t i = 0; i < 8; ++i) {
    if (!equal_[first.index + i] || match_.new_of_old[first.index + i] != execute::CellId(partner.index + i))
      return false;
  }
  const execute::Cell there = execute::CellAt(*new_.program, new_.cells, partner);
  return there.kind == execute::CellKind::kBit && there.bit == 0 &&
         (old_words_[first.index] || new_words_[partner.index]);
}

terms::TermId Pairing::Bit(Owner owner, execute::CellId id) {
  const machine::Version& version = VersionOf(owner);
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  const execute::CellId first(id.index - cell.bit);
  const bool as_byte =
      owner == Owner::kBoth ? SharesByte(first) : (owner == Owner::kOld ? old_words_ : new_words_)[first.index];
  if (!as_byte) {
    terms::TermId& variable = VariableOf(owner, id.index, Extent::kCell);
    if (!variable.valid()) variable = terms_.Variable(PrefixOf(owner) + execute::CellName(*version.program, cell), 1);
    return variable;
  }
  terms::TermId& variable = VariableOf(owner, first.index, Extent::kByte);
  if (!variable.valid()) {
    variable = terms_.Variable(
        PrefixOf(owner) + version.program->spaces[cell.space].name + "." + std::to_string(cell.offset), 8);
  }
  return terms_.Extract(variable, cell.bit, 1);
}

terms::TermId Pairing::Initial(Which which, execute::CellId id) {
  const execute::CellId old_cell = which == Which::kOld ? id : match_.old_of_new[id.index];
  const bool shared = old_cell.valid() && equal_[old_cell.index];
  const terms::TermId constant = ConstantOf(which, id);
  if (constant.valid() && (!shared || IsConstantPair(old_cell))) return constant;
  const Owner owner = shared ? Owner::kBoth : which == Which::kOld ? Owner::kOld : Owner::kNew;
  if (shared) id = old_cell;
  const machine::Version& version = VersionOf(owner);
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  if (cell.kind == execute::CellKind::kBit) return Bit(owner, id);
  terms::TermId& variable = VariableOf(owner, id.index, Extent::kCell);
  if (!variable.valid()) {
    variable = terms_.Variable(PrefixOf(owner) + execute::CellName(*version.program, cell),
                               execute::CellWidth(*version.program, cell));
  }
  return variable;
}

}  // namespace plcxx::prove::diff
