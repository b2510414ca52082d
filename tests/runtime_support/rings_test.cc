// Ways round a ring, against walking both of them step by step.
#include "plcxx/rings.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace plcxx {
namespace {

/// The positions from behind `from` to `to`, going up or down.
std::vector<uint32_t> Walk(uint32_t places, uint32_t from, uint32_t to, uint32_t step) {
  std::vector<uint32_t> visited;
  for (uint32_t at = from; at != to;) {
    at = (at + step) % places;
    visited.push_back(at);
  }
  return visited;
}

// covers: HOST50-163..165
TEST(Rings, TheShorterWayOfAllSmallRings) {
  for (uint32_t places = 1; places <= 40; ++places) {
    for (uint32_t from = 0; from < places; ++from) {
      for (uint32_t to = 0; to < places; ++to) {
        const std::vector<uint32_t> up = Walk(places, from, to, 1), down = Walk(places, from, to, places - 1);
        const bool forward = up.size() <= down.size();
        const std::vector<uint32_t>& way = forward ? up : down;
        SCOPED_TRACE(testing::Message() << places << ": " << from << " -> " << to);
        ASSERT_TRUE(OnRing(places, from, to));
        ASSERT_EQ(RingForward(places, from, to), forward);
        ASSERT_EQ(RingSteps(places, from, to), way.size());
        const uint32_t before = way.empty() ? to : way.size() == 1 ? from : way[way.size() - 2];
        ASSERT_EQ(RingBefore(places, from, to), before);
      }
    }
  }
}

// covers: HOST50-163..165
TEST(Rings, WorkedExamplesOfTheSpecification) {
  // N = 8, positions from 1
  EXPECT_FALSE(RingForward(8, 1, 6));
  EXPECT_EQ(RingSteps(8, 1, 6), 3U);
  EXPECT_EQ(RingBefore(8, 1, 6) + 1, 8U);
  EXPECT_TRUE(RingForward(8, 6, 1));
  EXPECT_EQ(RingBefore(8, 6, 1) + 1, 1U);
  EXPECT_TRUE(RingForward(8, 0, 4));
  EXPECT_EQ(RingSteps(8, 0, 4), 4U);
}

// covers: HOST50-166
TEST(Rings, PositionsOutside) {
  EXPECT_FALSE(OnRing(0, 0, 0));
  EXPECT_FALSE(OnRing(0xFFFFFFFF, 0, 0));  // -1 places
  EXPECT_FALSE(OnRing(8, 8, 0));
  EXPECT_FALSE(OnRing(8, 0, 8));
  EXPECT_FALSE(OnRing(8, 0xFFFFFFFF, 0));  // position 0 of a ring that counts from 1
  EXPECT_FALSE(OnRing(8, 0, 0xFFFFFFFF));
  EXPECT_TRUE(OnRing(0x7FFFFFFF, 0x7FFFFFFE, 0));
}

}  // namespace
}  // namespace plcxx
