// The longest path through the blocks of one function.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plcxx::compile {

struct PathEdge {
  uint32_t to = 0;
  uint64_t cost = 0;
};

struct PathNode {
  uint64_t cost = 0;
  std::vector<PathEdge> successors;
  bool leaves = false;
};

/// A loop of the graph.
struct PathLoop {
  uint32_t header = 0;
  std::set<uint32_t> nodes;
  PathLoop* around = nullptr;  // the loop that it is in; null: none
  bool shared = false;         // one inside jumps back for this loop, too
};

/// How many rounds a loop makes at most.
struct Rounds {
  std::optional<uint64_t> most;  // none: not known, counted as no repetition
  bool same_as_around = false;   // it is a second way back of the loop around it: those rounds count for both
  /// Beside `most`: rounds that it shares with other loops. How many these are is not counted in the path.
  std::optional<uint32_t> budget;
  std::string where;  // head of the loop in the text; empty: not found
};

using RoundsOfLoop = std::function<Rounds(const PathLoop& loop)>;

constexpr uint64_t kMostCost = uint64_t{1} << 60;  // sums saturate here

/// From node 0 to any that leaves. A loop's way round counts as often as the loop makes rounds, then the way out; of a
/// loop that is entered at several nodes all of them count as its first.
/// By budget: the dearest round of its loops goes into `shared_rounds`, where that is given.
uint64_t LongestPath(const std::vector<PathNode>& nodes, const RoundsOfLoop& rounds,
                     std::map<uint32_t, uint64_t>* shared_rounds = nullptr);

}  // namespace plcxx::compile
