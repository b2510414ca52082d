#include "transpiler/prove/diff/open_cells.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "transpiler/ir/op.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/sets.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::diff {
namespace {

constexpr size_t kMostNumbers = 80;     // of one version
constexpr size_t kMostWhileEqual = 32;  // of those that are equal in both
constexpr uint8_t kLowBits = 4;         // of a field, of which each is looked at alone

}  // namespace

OpenCells::OpenCells(Comparison& comparison) : comparison_(comparison) {
  Add(Which::kOld, comparison.one_sided.old_only);
  Add(Which::kNew, comparison.one_sided.new_only);
  for (const PairResult& result : comparison.results) {
    if (comparison.pairing.IsEqual(result.old_cell)) continue;
    Add(Which::kOld, {&result.old_cell, 1});
    Add(Which::kNew, {&result.new_cell, 1});
  }
}

void OpenCells::Add(Which which, std::span<const execute::CellId> cells) {
  for (const execute::CellId cell : cells) {
    if (IsOwn(which, cell)) cells_[which == Which::kOld ? 0 : 1].insert(cell);
  }
}

bool OpenCells::IsOwn(Which which, execute::CellId cell) const {
  const machine::Version& version = comparison_.pairing.version(which);
  const machine::Uses& uses = which == Which::kOld ? comparison_.old_uses : comparison_.new_uses;
  const execute::CellId old_cell = which == Which::kOld ? cell : comparison_.match.old_of_new[cell.index];
  const bool is_others = machine::WhatControlWrites(version, cell) != execute::ControlWrite::kNothing ||
                         (machine::MayBeSetByHost(version, cell) && !uses.sets[cell.index]) ||
                         (old_cell.valid() && comparison_.IsInput(old_cell)) || machine::IsInbox(version, cell) ||
                         machine::IsRetentive(version, cell);
  return cell.index < version.cells.calls && machine::IsState(version, cell) && uses.writes[cell.index] && !is_others;
}

std::vector<Number> OpenCells::NumbersOf(Which which) const {
  const machine::Version& version = comparison_.pairing.version(which);
  const std::set<execute::CellId>& open = of(which);
  std::vector<Number> words, bits;
  for (const execute::CellId id : open) {
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
    const uint8_t width = execute::CellWidth(*version.program, cell);
    if (width > 1) words.push_back({.which = which, .cells = {id}, .width = width});
    for (uint8_t low = 0; low < std::min(width, kLowBits); ++low)
      bits.push_back({.which = which, .cells = {id}, .low = low});
  }
  std::set<std::vector<execute::CellId>> taken;
  std::set<execute::CellId> rest;
  for (const ir::Place& place : version.program->places) {
    const bool is_word = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                         place.type <= ir::Type::kI64 && execute::IsInside(*version.program, place);
    if (!is_word) continue;
    std::vector<execute::CellId> cells = execute::CellsOf(*version.program, version.cells, place);
    // The high digits may be equal, which are always 0.
    const bool is_open = std::ranges::any_of(cells, [&open](execute::CellId cell) { return open.contains(cell); });
    if (!is_open || !std::ranges::all_of(cells, [&](execute::CellId cell) { return IsOwn(which, cell); })) continue;
    std::ranges::reverse(cells);
    if (!taken.insert(cells).second) continue;
    for (const execute::CellId cell : cells) {
      if (!open.contains(cell) && rest.insert(cell).second) bits.push_back({.which = which, .cells = {cell}});
    }
    const auto width = static_cast<uint8_t>(cells.size());
    words.push_back({.which = which, .cells = std::move(cells), .width = width});
  }
  words.resize(std::min(words.size(), kMostNumbers / 2));
  bits.resize(std::min(bits.size(), kMostNumbers - words.size()));
  std::ranges::move(bits, std::back_inserter(words));
  return words;
}

std::vector<Number> OpenCells::EqualBits() const {
  std::vector<terms::TermId> next;
  for (const Which which : {Which::kOld, Which::kNew}) {
    for (const execute::CellId cell : of(which))
      next.push_back(which == Which::kOld ? comparison_.NextOld(cell) : comparison_.NextNew(cell));
  }
  const std::vector<terms::TermId> cone = terms::ConeOf(comparison_.terms, next);
  // Bits of a number say less than flags do.
  std::vector<Number> flags, digits;
  for (const PairResult& result : comparison_.results) {
    const execute::CellId cell = result.old_cell;
    if (!comparison_.pairing.IsEqual(cell) || !IsOwn(Which::kOld, cell)) continue;
    const execute::Cell at = execute::CellAt(*comparison_.old_version.program, comparison_.old_version.cells, cell);
    if (execute::CellWidth(*comparison_.old_version.program, at) != 1) continue;
    const terms::TermId initial = comparison_.pairing.Initial(Which::kOld, cell);
    const terms::Term& term = comparison_.terms[initial];
    const bool is_digit = term.kind == terms::TermKind::kExtract;
    if (std::ranges::binary_search(cone, is_digit ? terms::TermId(term.a) : initial))
      (is_digit ? digits : flags).push_back({.which = Which::kOld, .cells = {cell}});
  }
  std::ranges::move(digits, std::back_inserter(flags));
  flags.resize(std::min(flags.size(), kMostWhileEqual));
  return flags;
}

}  // namespace plcxx::prove::diff
