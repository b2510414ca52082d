// The worked table and the rules of PROSTEP 7.2.
#include "plcxx/decade_counters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<DecadeCounter>, "part of a state that is copied and cleared as bytes");

// covers: PS-130, PS-132, PS-133, PS-134
TEST(DecadeCounters, WorkedTable) {
  const struct {
    bool count, set;
    uint16_t after_count, at_end;
  } rows[] = {{true, false, 1, 1},     {true, false, 1, 1},      {false, true, 1, 250},  {true, true, 251, 250},
              {true, false, 250, 250}, {false, false, 250, 250}, {true, false, 251, 251}};
  DecadeCounter counter{};
  int pass = 0;
  for (const auto& row : rows) {
    SCOPED_TRACE(++pass);
    EXPECT_TRUE(CountUp(counter, row.count));
    EXPECT_EQ(counter.value, row.after_count);
    SetCounter(counter, row.set, 0x0250);
    EXPECT_EQ(counter.value, row.at_end);
  }
}

// covers: PS-131
TEST(DecadeCounters, StopAtTheirLimits) {
  DecadeCounter counter{};
  EXPECT_FALSE(CountDown(counter, true));
  SetCounter(counter, true, 0x0998);
  for (int i = 0; i < 3; ++i) {
    CountUp(counter, true);
    CountUp(counter, false);
  }
  EXPECT_EQ(counter.value, 999);
  CountDown(counter, false);
  EXPECT_TRUE(CountDown(counter, true));
  EXPECT_EQ(counter.value, 998);
}

// covers: PS-138, PS-139
TEST(DecadeCounters, EdgesAreApartAndOutliveSettingAndResetting) {
  DecadeCounter counter{};
  CountUp(counter, true);
  ZeroCounter(counter, true);
  EXPECT_FALSE(CountUp(counter, true));  // no new edge
  SetCounter(counter, true, 0x0005);
  CountDown(counter, true);
  EXPECT_EQ(counter.value, 4);
  CountUp(counter, true);
  EXPECT_EQ(counter.value, 4);
  ZeroCounter(counter, false);
  EXPECT_EQ(counter.value, 4);
}

// covers: PS-134
TEST(DecadeCounters, SetOnAnEdge) {
  DecadeCounter counter{};
  SetCounterOnEdge(counter, true, 0x0010);
  EXPECT_EQ(counter.value, 10);
  SetCounterOnEdge(counter, true, 0x0020);
  EXPECT_EQ(counter.value, 10);
  SetCounterOnEdge(counter, false, 0x0020);
  SetCounterOnEdge(counter, true, 0x0030);
  EXPECT_EQ(counter.value, 30);
}

// covers: PS-133, PS-140
TEST(DecadeCounters, EveryPreset) {
  for (uint32_t preset = 0; preset < 0x10000; ++preset) {
    DecadeCounter counter{};
    SetCounter(counter, true, static_cast<uint16_t>(preset));
    const uint32_t digits = (preset >> 8 & 15) * 100 + (preset >> 4 & 15) * 10 + (preset & 15);
    ASSERT_EQ(counter.value, std::min(digits, 999u)) << preset;
  }
}

TEST(DecadeCounters, RandomSteps) {
  std::mt19937 random(5);
  DecadeCounter counter{};
  int value = 0;
  bool up = false, down = false;
  for (int i = 0; i < 100'000; ++i) {
    const bool s = random() % 2 != 0;
    switch (random() % 5) {
      case 0:
      case 1:
        if (s && !up) value = std::min(value + 1, 999);
        up = s;
        ASSERT_EQ(CountUp(counter, s), value != 0) << i;
        break;
      case 2:
        if (s && !down) value = std::max(value - 1, 0);
        down = s;
        ASSERT_EQ(CountDown(counter, s), value != 0) << i;
        break;
      case 3:
        if (s && random() % 100 == 0) {
          value = 997;
          SetCounter(counter, true, 0x0997);
        }
        break;
      default:
        if (random() % 1000 == 0) {
          if (s) value = 0;
          ZeroCounter(counter, s);
        }
        break;
    }
    ASSERT_EQ(counter.value, value) << i;
  }
}

}  // namespace
}  // namespace plcxx
