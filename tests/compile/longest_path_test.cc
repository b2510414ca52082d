#include "transpiler/compile/longest_path.h"

#include <gtest/gtest.h>

#include <utility>

namespace plcxx::compile {
namespace {

/// Edges cost nothing; a node with no way forward leaves.
std::vector<PathNode> Graph(const std::vector<uint64_t>& costs,
                            const std::vector<std::pair<uint32_t, uint32_t>>& edges) {
  std::vector<PathNode> nodes;
  for (const uint64_t cost : costs) nodes.push_back({.cost = cost, .successors = {}, .leaves = true});
  for (const auto& [from, to] : edges) {
    nodes[from].successors.push_back({to, 0});
    if (to > from) nodes[from].leaves = false;
  }
  return nodes;
}

RoundsOfLoop Always(uint64_t rounds) {
  return [rounds](const PathLoop&) { return Rounds{.most = rounds}; };
}

TEST(LongestPath, TakesTheDearerWay) {
  EXPECT_EQ(LongestPath(Graph({1, 5, 9, 2}, {{0, 1}, {0, 2}, {1, 3}, {2, 3}}), Always(0)), 12u);
}

TEST(LongestPath, EdgesCost) {
  std::vector<PathNode> nodes = Graph({1, 5, 2}, {{0, 1}, {1, 2}, {0, 2}});
  nodes[0].successors[1].cost = 100;
  EXPECT_EQ(LongestPath(nodes, Always(0)), 103u);
}

TEST(LongestPath, ALoopGoesRoundAsOftenAsItMay) {
  // 0, then (1 2) five times and once more to leave, then 3
  EXPECT_EQ(LongestPath(Graph({1, 10, 100, 1000}, {{0, 1}, {1, 2}, {2, 1}, {1, 3}}), Always(5)),
            1u + 5 * 110 + 110 + 1000 - 100);
}

TEST(LongestPath, ABlockMayBeALoopOfItsOwn) {
  EXPECT_EQ(LongestPath(Graph({1, 10, 100}, {{0, 1}, {1, 1}, {1, 2}}), Always(3)), 1u + 4 * 10 + 100);
}

TEST(LongestPath, TheFirstBlockMayBeTheHead) {
  EXPECT_EQ(LongestPath(Graph({10, 1}, {{0, 0}, {0, 1}}), Always(7)), 81u);
}

TEST(LongestPath, LoopsNest) {
  // 1 is the outer head, 2 the inner loop
  const auto nodes = Graph({0, 1, 10, 0, 0}, {{0, 1}, {1, 2}, {2, 2}, {2, 3}, {3, 1}, {3, 4}});
  EXPECT_EQ(LongestPath(nodes, Always(2)), 3u * (1 + 3 * 10));
}

TEST(LongestPath, AnUnknownBoundIsNoRepetition) {
  const RoundsOfLoop unknown = [](const PathLoop&) { return Rounds{}; };
  EXPECT_EQ(LongestPath(Graph({1, 10, 100}, {{0, 1}, {1, 1}, {1, 2}}), unknown), 111u);
}

TEST(LongestPath, ASecondWayBackSharesTheRounds) {
  // 1 -> 2 -> 1 and 2 -> 3 -> 2, one loop of the text: each round is one of them
  const auto nodes = Graph({0, 1, 10, 100, 0}, {{0, 1}, {1, 2}, {2, 3}, {3, 2}, {2, 1}, {3, 4}});
  const RoundsOfLoop rounds = [](const PathLoop& loop) {
    return loop.around == nullptr ? Rounds{.most = 5} : Rounds{.most = 0, .same_as_around = true};
  };
  EXPECT_EQ(LongestPath(nodes, rounds), 5u * 111 + 111);
}

TEST(LongestPath, AnEntryInTheMiddleEndsAllTheSame) {
  const auto nodes = Graph({1, 10, 100, 0}, {{0, 1}, {0, 2}, {1, 2}, {2, 1}, {2, 3}});
  EXPECT_GE(LongestPath(nodes, Always(1)), 211u);
}

TEST(LongestPath, SumsSaturate) {
  EXPECT_EQ(LongestPath(Graph({1, kMostCost / 2, 1}, {{0, 1}, {1, 1}, {1, 2}}), Always(kMostCost)), kMostCost);
}

TEST(LongestPath, ThousandsOfBlocksInARow) {
  std::vector<uint64_t> costs(100'000, 1);
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (uint32_t i = 0; i + 1 < costs.size(); ++i) edges.emplace_back(i, i + 1);
  EXPECT_EQ(LongestPath(Graph(costs, edges), Always(0)), costs.size());
}

}  // namespace
}  // namespace plcxx::compile
