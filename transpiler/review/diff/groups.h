// The items of a comparison as a reader wants them: what follows from a change is folded under it.
//
// In: a Diff. Out: groups of items of one kind and verdict, each with its cause; the changes themselves first. Not its
// job: how a group is spelled (diff_output.cc, diff_page.cc).
#pragma once

#include <string>
#include <vector>

#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

struct DiffGroup {
  std::vector<const DiffItem*> items;  // one at least
  /// Of items without a change of their own: those that have one, and that these take their difference from.
  std::vector<std::string> causes;

  const DiffItem& first() const { return *items.front(); }
};

/// By kind, in the order of ItemKind; what differs before what is not decided, what changed itself before what follows
/// from it. The diff outlives the groups.
std::vector<DiffGroup> GroupsOf(const Diff& diff);

/// "U4A0..3, U5K0, F byte 0..511, LABEL_MEM+5..44:8": names in which one number counts on are a range. Of many ranges
/// the first ones; JSON has all names.
inline constexpr size_t kMostRanges = 24;
std::string NamesAsRanges(const std::vector<std::string>& names, size_t most = kMostRanges);
std::string NamesOf(const DiffGroup& group);

}  // namespace plcxx::review::diff
