#include "transpiler/driver/diff_groups.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace plcxx::driver {
namespace {

/// The items with a change of their own from which `item` takes its difference; what it reads, when none is among that.
std::vector<std::string> CausesOf(const DiffItem& item, const std::map<std::string, const DiffItem*>& by_name) {
  std::set<std::string> seen{item.name}, causes;
  std::vector<const DiffItem*> open{&item};
  while (!open.empty()) {
    const DiffItem& from = *open.back();
    open.pop_back();
    for (const std::string& name : from.through) {
      if (!seen.insert(name).second) continue;
      const auto at = by_name.find(name);
      if (at == by_name.end()) continue;
      if (at->second->changed_itself) causes.insert(name);
      // What differs through others and has a change of its own is one of the causes, and may not be the first one.
      if (!at->second->changed_itself) open.push_back(at->second);
    }
  }
  // Of many that read each other none is the cause of the others.
  constexpr size_t kMostNamed = 3;
  if (causes.empty() && item.through.size() <= kMostNamed) causes.insert(item.through.begin(), item.through.end());
  return {causes.begin(), causes.end()};
}

using StatementIds = std::vector<uint32_t>;
StatementIds IdsOf(const std::vector<ItemStatement>& statements) {
  StatementIds ids;
  for (const ItemStatement& statement : statements) ids.push_back(statement.statement.index);
  return ids;
}

/// What items of one group have in common.
using GroupKey = std::tuple<ItemKind, bool, int, std::vector<std::string>, std::string, StatementIds, StatementIds>;

GroupKey KeyOf(const DiffItem& item, const std::vector<std::string>& causes, size_t number) {
  const bool follows = !item.changed_itself && !item.through.empty();
  const int verdict = item.verdict == ItemVerdict::kDifferent ? 0 : 1;
  if (follows) return {item.kind, true, verdict, causes, {}, {}, {}};
  // What is declared is told one by one, and so is the schedule.
  const bool alone = item.declared || item.kind == ItemKind::kSchedule;
  return {item.kind,
          false,
          verdict,
          {},
          alone          ? std::to_string(number)
          : verdict == 1 ? item.reason
                         : std::string(),
          IdsOf(item.old_statements),
          IdsOf(item.new_statements)};
}

/// "U4A", 12, "" and "G[", 3, "]": the last number of a name.
struct Numbered {
  std::string before, after;
  uint64_t number = 0;
};
std::optional<Numbered> LastNumberOf(const std::string& name) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  size_t end = name.size();
  while (end > 0 && !is_digit(name[end - 1])) --end;
  size_t begin = end;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  if (begin == end || end - begin > 9 || name.size() - end > 1 || (name[begin] == '0' && end - begin > 1))
    return std::nullopt;
  return Numbered{.before = name.substr(0, begin),
                  .after = name.substr(end),
                  .number = std::stoull(name.substr(begin, end - begin))};
}

}  // namespace

std::vector<DiffGroup> GroupsOf(const Diff& diff) {
  std::map<std::string, const DiffItem*> by_name;
  for (const DiffItem& item : diff.items) by_name.emplace(item.name, &item);
  std::vector<DiffGroup> groups;
  std::map<GroupKey, size_t> of_key;
  for (size_t i = 0; i < diff.items.size(); ++i) {
    const DiffItem& item = diff.items[i];
    std::vector<std::string> causes;
    if (!item.changed_itself) causes = CausesOf(item, by_name);
    const auto [at, added] = of_key.try_emplace(KeyOf(item, causes, i), groups.size());
    if (added) groups.push_back({.items = {}, .causes = std::move(causes)});
    groups[at->second].items.push_back(&item);
  }
  std::ranges::stable_sort(groups, {}, [](const DiffGroup& group) {
    const DiffItem& item = group.first();
    return std::tuple(item.kind, !item.changed_itself && !group.causes.empty(),
                      item.verdict == ItemVerdict::kDifferent ? 0 : 1);
  });
  return groups;
}

std::string NamesAsRanges(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size();) {
    const std::optional<Numbered> first = LastNumberOf(names[i]);
    size_t count = 1;
    while (first && i + count < names.size()) {
      const std::optional<Numbered> next = LastNumberOf(names[i + count]);
      const bool follows =
          next && next->before == first->before && next->after == first->after && next->number == first->number + count;
      if (!follows) break;
      ++count;
    }
    if (!text.empty()) text += ", ";
    if (count < 3) {
      text += names[i];
      count = 1;
    } else {
      text += first->before + std::to_string(first->number) + ".." + std::to_string(first->number + count - 1) +
              first->after;
    }
    i += count;
  }
  return text;
}

std::string NamesOf(const DiffGroup& group) {
  std::vector<std::string> names;
  for (const DiffItem* const item : group.items) names.push_back(item->name);
  return NamesAsRanges(names);
}

}  // namespace plcxx::driver
