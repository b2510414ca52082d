// Lanes that become copies of others: the state, and the way that leads to it.
#include <gtest/gtest.h>

#include <vector>

#include "transpiler/prove/wide/history.h"

namespace plcxx::prove::wide {
namespace {

constexpr uint32_t kLanes = terms::Plane::kLanes;

TEST(WideHistory, TheWayOfALaneIsThatOfTheOneItWasCopiedFrom) {
  std::vector<Period> history(4);
  history[1].copy_of[2] = 5;    // lanes 128 to 191
  history[3].copy_of[0] = 130;  // lanes 0 to 63
  EXPECT_EQ(WayOf(history, 130, 4), (std::vector<uint32_t>{5, 130, 130, 130}));
  EXPECT_EQ(WayOf(history, 7, 4), (std::vector<uint32_t>{5, 130, 130, 7}));
  EXPECT_EQ(WayOf(history, 300, 4), (std::vector<uint32_t>{300, 300, 300, 300}));
  EXPECT_EQ(WayOf(history, 7, 2), (std::vector<uint32_t>{7, 7}));
}

// Word 0 is copied from a lane of word 1, and word 1 from one of word 0: each as it was before.
TEST(WideHistory, LanesAreCopiedAllAtOnce) {
  std::vector<terms::Plane> planes(2);
  planes[0].Set(3, true);
  planes[1].Set(70, true);
  CopyOf copy_of = NoCopies();
  copy_of[0] = 70;
  copy_of[1] = 3;
  SpreadLanes(planes, copy_of);
  for (uint32_t lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(planes[0].Get(lane), lane / 64 == 1) << lane;
    EXPECT_EQ(planes[1].Get(lane), lane / 64 == 0) << lane;
  }
}

TEST(WideHistory, OnlyLanesThatAreWorthSomethingAreCopied) {
  terms::Random random(0x9E3779B97F4A7C15);
  Scores none{};
  EXPECT_EQ(DrawCopies(none, random), NoCopies());
  Scores scores{};
  terms::Plane few;
  for (uint32_t lane = 0; lane < kLanes; lane += 8) few.Set(lane, true);
  AddScore(few, 1, scores);
  uint32_t copied = 0;
  for (int i = 0; i < 20; ++i) {
    for (const uint32_t lane : DrawCopies(scores, random)) {
      if (lane == kNoLane) continue;
      ++copied;
      EXPECT_TRUE(few.Get(lane));
    }
  }
  EXPECT_GT(copied, 60U);
  // What most lanes have is no news.
  Scores of_all{};
  AddScore(~terms::Plane(), 1, of_all);
  EXPECT_EQ(of_all, Scores{});
}

}  // namespace
}  // namespace plcxx::prove::wide
