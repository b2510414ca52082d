// Work on numbered items in child processes: a crash, a fault of plcxx or work without an end is that of one item, and
// the others go on.
//
// In: groups of items, each the work of one child. Out: for each item the bytes that the work reported, or why there
// are none. What a child was at when it ended badly is to blame; the rest of its group gets a new child. Not its job:
// what the work is (suite.cc).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::scenarios {

using ItemGroup = std::vector<uint32_t>;

/// A child's words to its parent.
class WorkReport {
 public:
  explicit WorkReport(int pipe) : pipe_(pipe) {}
  /// What happens from here on is this item's doing, and its time begins anew.
  void Begin(uint32_t item) { Send('b', item, {}); }
  /// What happens from here on is work for all items of the group.
  void BeginCommon() { Send('c', 0, {}); }
  void Done(uint32_t item, std::string_view result) { Send('d', item, result); }

 private:
  void Send(char kind, uint32_t item, std::string_view bytes);

  int pipe_;
};

struct SeparateOptions {
  unsigned jobs = 1;              // children at a time
  unsigned item_seconds = 60;     // of real time, from a Begin to the next word
  unsigned common_seconds = 900;  // likewise, from a BeginCommon
};

/// What became of an item.
struct ItemEnd {
  std::optional<std::string> result;  // as it was reported
  std::string why;                    // there is none
};

/// Called in a child, for a group or for what is left of it. It reports each item once.
using GroupWork = std::function<void(const ItemGroup& items, WorkReport& report)>;
/// Called here, once for each item, as they end.
using ItemEnded = std::function<void(uint32_t item, ItemEnd end)>;

void WorkSeparately(const std::vector<ItemGroup>& groups, const SeparateOptions& options, const GroupWork& work,
                    const ItemEnded& ended);

}  // namespace plcxx::scenarios
