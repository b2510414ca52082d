#include "transpiler/review/diff/causes.h"

#include <algorithm>

#include "transpiler/review/diff/statements.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;

constexpr uint32_t kNoItem = 0xFFFFFFFF;

/// What the statements of one version do with the items, by index of the item.
struct Touched {
  std::vector<std::set<ir::StatementId>> writers;
  std::map<ir::StatementId, std::set<uint32_t>> reads;  // differing items only
};

Touched TouchedBy(const Named& side, const std::vector<NamedItem>& items, std::vector<CellId> NamedItem::* cells) {
  std::vector<uint32_t> item_of(side.version.cells.count, kNoItem);
  for (uint32_t i = 0; i < items.size(); ++i) {
    if (items[i].item.verdict == ItemVerdict::kEqual) continue;
    for (const CellId cell : items[i].*cells) item_of[cell.index] = i;
  }
  Touched touched{.writers = std::vector<std::set<ir::StatementId>>(items.size()), .reads = {}};
  for (const StatementAccess& access : side.accesses) {
    if (!access.statement.valid()) continue;
    for (uint32_t cell = access.begin; cell < access.end; ++cell) {
      if (item_of[cell] == kNoItem) continue;
      if (access.writes) {
        touched.writers[item_of[cell]].insert(access.statement);
      } else {
        touched.reads[access.statement].insert(item_of[cell]);
      }
    }
  }
  return touched;
}

/// The changed statements that write what `readers` read: a value may be another one in the middle of a scan only, and
/// what has it then is not in the list.
std::set<ir::StatementId> ChangedBefore(const Named& side, const std::set<ir::StatementId>& readers,
                                        const StatementTexts& other_texts) {
  std::vector<bool> read(side.version.cells.count);
  for (const StatementAccess& access : side.accesses) {
    if (access.writes || !readers.contains(access.statement)) continue;
    for (uint32_t cell = access.begin; cell < access.end; ++cell) read[cell] = true;
  }
  std::set<ir::StatementId> writers;
  for (const StatementAccess& access : side.accesses) {
    if (!access.writes || !access.statement.valid()) continue;
    for (uint32_t cell = access.begin; cell < access.end; ++cell) {
      if (read[cell]) writers.insert(access.statement);
    }
  }
  std::erase_if(writers, [&](ir::StatementId id) { return !StatementOf(side.side, id, other_texts).changed; });
  return writers;
}

/// The changed statements that decide whether others are executed.
std::set<ir::StatementId> ChangedHeads(const Named& side, const std::set<ir::StatementId>& statements,
                                       const StatementTexts& other_texts) {
  const std::map<ir::StatementId, std::set<ir::StatementId>>& heads = side.heads;
  std::set<ir::StatementId> around = statements;
  std::vector<ir::StatementId> open(statements.begin(), statements.end());
  while (!open.empty()) {
    const auto found = heads.find(open.back());
    open.pop_back();
    if (found == heads.end()) continue;
    for (const ir::StatementId head : found->second) {
      if (around.insert(head).second) open.push_back(head);
    }
  }
  std::erase_if(around, [&](ir::StatementId id) {
    return statements.contains(id) || !StatementOf(side.side, id, other_texts).changed;
  });
  return around;
}

}  // namespace

void AddCauses(std::vector<NamedItem>& items, const Named& old_side, const Named& new_side) {
  const StatementTexts old_texts = TextsOf(old_side.side), new_texts = TextsOf(new_side.side);
  const Touched old_touched = TouchedBy(old_side, items, &NamedItem::old_cells);
  const Touched new_touched = TouchedBy(new_side, items, &NamedItem::new_cells);
  for (uint32_t i = 0; i < items.size(); ++i) {
    DiffItem& item = items[i].item;
    if (item.verdict == ItemVerdict::kEqual) continue;
    std::set<std::string> through;
    const auto add = [&](const Named& side, const Touched& touched, const StatementTexts& other_texts,
                         std::vector<ItemStatement>& statements) {
      for (const ir::StatementId id : touched.writers[i]) {
        statements.push_back(StatementOf(side.side, id, other_texts));
        const auto reads = touched.reads.find(id);
        if (reads == touched.reads.end()) continue;
        for (const uint32_t other : reads->second) {
          if (other != i) through.insert(items[other].item.name);
        }
      }
    };
    add(old_side, old_touched, new_texts, item.old_statements);
    add(new_side, new_touched, old_texts, item.new_statements);
    item.through.assign(through.begin(), through.end());
    ShowChangedLines(old_side.side, new_side.side, item);
    const auto is_changed = [](const std::vector<ItemStatement>& statements) {
      return std::ranges::any_of(statements, &ItemStatement::changed);
    };
    if (!item.changed_itself || is_changed(item.old_statements) || is_changed(item.new_statements)) continue;
    const auto add_changed = [&](const auto& find) {
      for (const ir::StatementId id : find(old_side, old_touched.writers[i], new_texts)) {
        item.old_statements.push_back(StatementOf(old_side.side, id, new_texts));
      }
      for (const ir::StatementId id : find(new_side, new_touched.writers[i], old_texts)) {
        item.new_statements.push_back(StatementOf(new_side.side, id, old_texts));
      }
    };
    add_changed(ChangedHeads);
    if (!is_changed(item.old_statements) && !is_changed(item.new_statements)) add_changed(ChangedBefore);
    ShowChangedLines(old_side.side, new_side.side, item);
  }
}

}  // namespace plcxx::review::diff
