// The longest path through the blocks of one function.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
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

/// How many rounds a loop makes at most: of its header and its blocks. None: not known, counted as no repetition.
using RoundsOfLoop = std::function<std::optional<uint64_t>(uint32_t header, const std::set<uint32_t>& blocks)>;

constexpr uint64_t kMostCost = uint64_t{1} << 60;  // sums saturate here

/// From node 0 to any that leaves. A loop's way round counts as often as the loop makes rounds, then the way out; of a
/// loop that is entered at several nodes all of them count as its first.
uint64_t LongestPath(const std::vector<PathNode>& nodes, const RoundsOfLoop& rounds);

}  // namespace plcxx::compile
