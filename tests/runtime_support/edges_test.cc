// The scan table of HOST50 7.1.
#include "plcxx/edges.h"

#include <gtest/gtest.h>

#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<EdgeMemory>, "part of a state that is copied and cleared as bytes");

// covers: HOST50-088 HOST50-089 HOST50-094
TEST(Edges, ScanTable) {
  EdgeMemory rising{}, skipping{}, falling{};
  PresetEdge(rising, false);
  PresetEdge(skipping, false);
  PresetEdge(falling, false);
  EXPECT_TRUE(Rising(rising, true));
  EXPECT_TRUE(Rising(skipping, true));
  EXPECT_FALSE(Falling(falling, true));
  EXPECT_FALSE(Rising(rising, false));  // the second instruction is not executed in this scan
  EXPECT_TRUE(Falling(falling, false));
  EXPECT_TRUE(Rising(rising, true));
  EXPECT_FALSE(Rising(skipping, true));
  EXPECT_FALSE(Falling(falling, true));
}

// covers: HOST50-097
TEST(Edges, PresetHidesAnEdge) {
  EdgeMemory rising{}, falling{};
  PresetEdge(rising, true);
  PresetEdge(falling, true);
  EXPECT_FALSE(Rising(rising, true));
  EXPECT_TRUE(Falling(falling, false));
  rising = falling = {};  // EDGEINIT=OFF
  EXPECT_TRUE(Rising(rising, true));
  EXPECT_FALSE(Falling(falling, false));
}

TEST(Edges, RandomSignals) {
  std::mt19937 random(11);
  EdgeMemory rising{}, falling{};
  bool before = false;
  for (int i = 0; i < 10000; ++i) {
    const bool now = random() % 2 == 1;
    ASSERT_EQ(Rising(rising, now), now && !before);
    ASSERT_EQ(Falling(falling, now), !now && before);
    before = now;
  }
}

}  // namespace
}  // namespace plcxx
