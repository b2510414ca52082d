#include "transpiler/review/diff/groups.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace plcxx::review::diff {
namespace {

std::vector<std::string> OwnChangesOf(const Diff& diff) {
  std::vector<std::string> names;
  for (const DiffItem& item : diff.items) {
    if (item.changed_itself) names.push_back(item.name);
  }
  return names;
}

/// For each item those with a change of their own from which it takes its difference. Found from these on, so that many
/// items that read each other are walked once for each change.
class Causes {
 public:
  explicit Causes(const Diff& diff) : diff_(diff), readers_(diff.items.size()), causes_(diff.items.size()) {
    std::map<std::string, uint32_t> by_name;
    for (uint32_t i = 0; i < diff.items.size(); ++i) by_name.emplace(diff.items[i].name, i);
    for (uint32_t i = 0; i < diff.items.size(); ++i) {
      for (const std::string& name : diff.items[i].through) {
        const auto at = by_name.find(name);
        if (at != by_name.end() && at->second != i) readers_[at->second].push_back(i);
      }
    }
    for (const auto& [name, i] : by_name) {  // so that causes are in the order of their names
      if (diff.items[i].changed_itself) AddCause(i);
    }
  }

  /// Of what is not decided these are named as far as it is proved that there are no others; of what differs else what
  /// it reads.
  std::vector<std::string> Of(uint32_t index) const {
    const DiffItem& item = diff_.items[index];
    const bool is_claim = item.verdict == ItemVerdict::kUndecided;
    if (is_claim && !diff_.changes_are_found) return {};
    std::vector<std::string> names;
    for (const uint32_t cause : causes_[index]) names.push_back(diff_.items[cause].name);
    if (names.empty() && is_claim) return OwnChangesOf(diff_);
    // Of many that read each other none is the cause of the others.
    constexpr size_t kMostNamed = 3;
    if (names.empty() && item.through.size() <= kMostNamed) names = item.through;
    std::ranges::sort(names);
    return names;
  }

 private:
  void AddCause(uint32_t cause) {
    std::vector<bool> seen(readers_.size());
    seen[cause] = true;
    std::vector<uint32_t> open{cause};
    while (!open.empty()) {
      const uint32_t from = open.back();
      open.pop_back();
      for (const uint32_t reader : readers_[from]) {
        if (seen[reader]) continue;
        seen[reader] = true;
        causes_[reader].push_back(cause);
        // What differs through others and has a change of its own is one of the causes, and may not be the first one.
        if (!diff_.items[reader].changed_itself) open.push_back(reader);
      }
    }
  }

  const Diff& diff_;
  std::vector<std::vector<uint32_t>> readers_;  // by item: those that take their difference through it
  std::vector<std::vector<uint32_t>> causes_;   // by item
};

using StatementIds = std::vector<uint32_t>;
StatementIds IdsOf(const std::vector<ItemStatement>& statements) {
  StatementIds ids;
  for (const ItemStatement& statement : statements) ids.push_back(statement.statement.index);
  return ids;
}

/// What items of one group have in common.
using GroupKey = std::tuple<ItemKind, bool, int, std::vector<std::string>, std::string, StatementIds, StatementIds>;

GroupKey KeyOf(const DiffItem& item, const std::vector<std::string>& causes, size_t number) {
  const int verdict = item.verdict == ItemVerdict::kDifferent ? 0 : 1;
  const bool is_declared = item.declared || item.kind == ItemKind::kSchedule;
  const bool follows = !item.changed_itself && !is_declared && (verdict == 1 || !item.through.empty());
  if (follows) return {item.kind, true, verdict, causes, {}, {}, {}};
  // What is declared is told one by one, and so is the schedule.
  return {item.kind,
          false,
          verdict,
          {},
          is_declared    ? std::to_string(number)
          : verdict == 1 ? item.reason
                         : std::string(),
          IdsOf(item.old_statements),
          IdsOf(item.new_statements)};
}

/// Of what is not decided and has no change of its own: so many lines of one kind, or one with all causes.
constexpr size_t kMostApart = 2;

bool FollowsUndecided(const DiffGroup& group) {
  const DiffItem& item = group.first();
  const bool is_declared = item.declared || item.kind == ItemKind::kSchedule;
  return item.verdict == ItemVerdict::kUndecided && !item.changed_itself && !is_declared;
}

/// What follows, and nobody knows whether it does, is one piece of news of each kind, not a page of them.
void JoinManyUndecided(std::vector<DiffGroup>& groups) {
  std::map<ItemKind, std::vector<size_t>> of_kind;
  for (size_t i = 0; i < groups.size(); ++i) {
    if (FollowsUndecided(groups[i])) of_kind[groups[i].first().kind].push_back(i);
  }
  std::set<size_t> gone;
  for (const auto& [kind, which] : of_kind) {
    if (which.size() <= kMostApart) continue;
    DiffGroup& all = groups[which.front()];
    for (const size_t i : which) {
      for (const std::string& cause : groups[i].causes) {
        if (std::ranges::find(all.causes, cause) == all.causes.end()) all.causes.push_back(cause);
      }
      if (i == which.front()) continue;
      all.items.insert(all.items.end(), groups[i].items.begin(), groups[i].items.end());
      gone.insert(i);
    }
    // As they were: by address. All are items of one vector.
    std::ranges::sort(all.items);
  }
  size_t index = 0;
  std::erase_if(groups, [&](const DiffGroup&) { return gone.contains(index++); });
}

/// A name in pieces: numbers, and what is between them.
std::vector<std::string> PiecesOf(const std::string& name) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::vector<std::string> pieces;
  for (const char c : name) {
    if (pieces.empty() || is_digit(pieces.back().back()) != is_digit(c)) pieces.emplace_back();
    pieces.back() += c;
  }
  return pieces;
}

/// Which piece of `next` is the number after that of `name`, when everything else is the same.
std::optional<size_t> CountedPiece(const std::vector<std::string>& name, const std::vector<std::string>& next) {
  if (name.size() != next.size()) return std::nullopt;
  std::optional<size_t> counted;
  for (size_t i = 0; i < name.size(); ++i) {
    if (name[i] == next[i]) continue;
    if (counted) return std::nullopt;
    counted = i;
  }
  if (!counted) return std::nullopt;
  const auto is_number = [](const std::string& piece) {
    const bool has_digits = std::isdigit(static_cast<unsigned char>(piece.front())) != 0;
    return has_digits && piece.size() < 10 && (piece.front() != '0' || piece.size() == 1);
  };
  const std::string &one = name[*counted], &other = next[*counted];
  const bool follows = is_number(one) && is_number(other) && std::stoull(other) == std::stoull(one) + 1;
  return follows ? counted : std::nullopt;
}

/// "U4A0..3", of `names` from `first` on so many.
std::string RangeOf(const std::vector<std::string>& names, size_t first, size_t count, size_t counted) {
  std::vector<std::string> pieces = PiecesOf(names[first]);
  pieces[counted] += ".." + PiecesOf(names[first + count - 1])[counted];
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  return text;
}

}  // namespace

std::vector<DiffGroup> GroupsOf(const Diff& diff) {
  const Causes all_causes(diff);
  std::vector<DiffGroup> groups;
  std::map<GroupKey, size_t> of_key;
  for (size_t i = 0; i < diff.items.size(); ++i) {
    const DiffItem& item = diff.items[i];
    std::vector<std::string> causes;
    if (!item.changed_itself) causes = all_causes.Of(static_cast<uint32_t>(i));
    const auto [at, added] = of_key.try_emplace(KeyOf(item, causes, i), groups.size());
    if (added) groups.push_back({.items = {}, .causes = std::move(causes)});
    groups[at->second].items.push_back(&item);
  }
  JoinManyUndecided(groups);
  std::ranges::stable_sort(groups, {}, [](const DiffGroup& group) {
    const DiffItem& item = group.first();
    return std::tuple(item.kind, item.verdict == ItemVerdict::kDifferent ? 0 : 1,
                      !item.changed_itself && !group.causes.empty());
  });
  return groups;
}

std::string NamesAsRanges(const std::vector<std::string>& names, size_t most) {
  std::vector<std::string> ranges;
  for (size_t i = 0; i < names.size();) {
    size_t count = 1;
    std::optional<size_t> counted;
    while (i + count < names.size()) {
      const std::optional<size_t> piece = CountedPiece(PiecesOf(names[i + count - 1]), PiecesOf(names[i + count]));
      if (!piece || (counted && piece != counted)) break;
      counted = piece;
      ++count;
    }
    constexpr size_t kLeastOfRange = 3;
    if (count < kLeastOfRange) count = 1;
    ranges.push_back(count == 1 ? names[i] : RangeOf(names, i, count, *counted));
    i += count;
  }
  std::string text;
  for (size_t i = 0; i < ranges.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + ranges[i];
  if (ranges.size() > most) text += " and " + std::to_string(ranges.size() - most) + " more ranges";
  return text;
}

std::string NamesOf(const DiffGroup& group) {
  std::vector<std::string> names;
  for (const DiffItem* const item : group.items) names.push_back(item->name);
  return NamesAsRanges(names);
}

}  // namespace plcxx::review::diff
