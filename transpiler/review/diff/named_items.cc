#include "transpiler/review/diff/named_items.h"

#include <algorithm>
#include <utility>

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::PairResult;
using prove::diff::PairVerdict;

ItemKind KindOf(const prove::machine::Version& version, CellId cell) {
  if (execute::CellAt(*version.program, version.cells, cell).kind == execute::CellKind::kCalls) return ItemKind::kCalls;
  if (prove::machine::DirectionOf(version, cell) == ir::Direction::kOutput) return ItemKind::kOutput;
  return prove::machine::IsRetentive(version, cell) ? ItemKind::kRetentive : ItemKind::kInternal;
}

ItemVerdict VerdictOf(const PairResult& pair) {
  switch (pair.verdict) {
    case PairVerdict::kUntouched:
    case PairVerdict::kEqual:
      return ItemVerdict::kEqual;
    case PairVerdict::kDifferent:
      return ItemVerdict::kDifferent;
    case PairVerdict::kUndecided:
      return ItemVerdict::kUndecided;
  }
  return ItemVerdict::kUndecided;
}

/// The worse of two: what differs beats what is not decided.
bool IsWorse(ItemVerdict one, ItemVerdict other) {
  const auto rank = [](ItemVerdict verdict) {
    return verdict == ItemVerdict::kDifferent ? 2 : verdict == ItemVerdict::kUndecided ? 1 : 0;
  };
  return rank(one) > rank(other);
}

/// Of calls that one version alone makes, for certain; none: a run has to show it.
std::optional<Declared> CallsOfOneVersion(const PairResult& pair) {
  const std::string with = "asked of the control", without = "not asked of the control";
  if (!pair.new_cell.valid() || pair.only_caller == prove::diff::Which::kOld) return Declared{with, without};
  if (!pair.old_cell.valid() || pair.only_caller == prove::diff::Which::kNew) return Declared{without, with};
  return std::nullopt;
}

}  // namespace

std::vector<NamedItem> MakeItems(const prove::diff::CompareResult& result, const Named& old_side,
                                 const Named& new_side) {
  std::vector<NamedItem> items;
  std::map<std::pair<ItemKind, std::string>, size_t> index;
  for (const PairResult& pair : result.pairs) {
    if (pair.verdict == PairVerdict::kUntouched) continue;
    const Named& side = pair.old_cell.valid() ? old_side : new_side;
    const CellId cell = pair.old_cell.valid() ? pair.old_cell : pair.new_cell;
    CellWord word = side.words.WordOf(cell);
    // A place that only the new version uses has its name there.
    if (!word.place && pair.new_cell.valid()) {
      CellWord other = new_side.words.WordOf(pair.new_cell);
      if (other.place) word = std::move(other);
    }
    const ItemKind kind = KindOf(side.version, cell);
    const auto [at, added] = index.try_emplace({kind, word.name}, items.size());
    if (added) {
      items.push_back({.item = {.name = word.name, .kind = kind, .verdict = ItemVerdict::kEqual}});
      items.back().item.meaning = new_side.words.MeaningOf(word);
      if (items.back().item.meaning.empty()) items.back().item.meaning = old_side.words.MeaningOf(word);
      std::ranges::replace(items.back().item.meaning, '\n', ' ');  // comments of several lines
    }
    NamedItem& named = items[at->second];
    if (kind == ItemKind::kCalls) named.item.declared = CallsOfOneVersion(pair);
    if (pair.old_cell.valid()) named.old_cells.push_back(pair.old_cell);
    if (pair.new_cell.valid()) named.new_cells.push_back(pair.new_cell);
    named.item.changed_itself = named.item.changed_itself || pair.changed_itself;
    if (named.worst == nullptr || IsWorse(VerdictOf(pair), named.item.verdict)) {
      named.worst = &pair;
      named.item.verdict = VerdictOf(pair);
      named.item.reason = pair.reason;
    }
  }
  return items;
}

void DropOrderOfCalls(std::vector<NamedItem>& items, const execute::Cells& cells) {
  const auto is_of = [](const NamedItem& named, CellId cell) {
    return std::ranges::find(named.old_cells, cell) != named.old_cells.end();
  };
  const auto is_order = [&](const NamedItem& named) { return is_of(named, cells.OfOrder()); };
  const auto actions =
      std::ranges::find_if(items, [&](const NamedItem& named) { return is_of(named, cells.OfActions()); });
  const bool is_equal_but_faults = actions == items.end() || actions->item.verdict == ItemVerdict::kEqual;
  // Whose own news is why the order is another one.
  const bool is_explained = std::ranges::any_of(items, [&](const NamedItem& named) {
    const DiffItem& item = named.item;
    if (item.kind != ItemKind::kCalls || item.verdict != ItemVerdict::kDifferent || named.old_cells.empty())
      return false;
    const uint32_t function = named.old_cells.front().index - cells.calls;
    if (function >= cells.roles.size()) return false;
    return cells.roles[function] == execute::HostRole::kAction ||
           (cells.roles[function] == execute::HostRole::kReport && is_equal_but_faults);
  });
  std::erase_if(items, [&](const NamedItem& named) { return is_of(named, cells.OfActions()); });
  std::erase_if(items, [&](const NamedItem& named) {
    return is_order(named) && (is_explained || named.item.verdict == ItemVerdict::kEqual);
  });
}

}  // namespace plcxx::review::diff
