// The scan table and the rules of HOST50 7.3, and random pins against positions on a ring.
#include "plcxx/position_counters.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<PositionCounter>, "part of a state that is copied and cleared as bytes");

constexpr uint8_t kUpFromOne = Pins(false, false, true);

// covers: HOST50-195 HOST50-197 HOST50-198 HOST50-202
TEST(PositionCounters, ScanTable) {
  constexpr bool kInput[] = {false, true, false, true, true, false, true, false, false};
  constexpr bool kReset[] = {false, false, false, false, false, false, false, false, true};
  constexpr uint32_t kValue[] = {1, 2, 2, 3, 3, 3, 1, 1, 1};
  constexpr bool kOutput[] = {false, false, false, true, true, true, false, false, false};
  PositionCounter counter{};
  for (int i = 0; i < 9; ++i) {
    SCOPED_TRACE(i + 1);
    EXPECT_EQ(CNUD(counter, kInput[i], 3, Pins(kReset[i], false, true)), kOutput[i]);
    EXPECT_EQ(counter.value, kValue[i]);
    EXPECT_EQ(counter.output, kOutput[i]);
    EXPECT_EQ(counter.preset, 3U);
  }
}

// covers: HOST50-196 HOST50-197
TEST(PositionCounters, Down) {
  PositionCounter counter{};
  const uint8_t down = Pins(false, true, false);
  EXPECT_FALSE(CNUD(counter, false, 3, down));
  for (const uint32_t value : {3U, 2U, 1U, 0U, 3U}) {
    EXPECT_EQ(counter.value, value);
    EXPECT_EQ(counter.output, value == 0);
    CNUD(counter, true, 3, down);
    CNUD(counter, false, 3, down);
  }
}

// covers: HOST50-198
TEST(PositionCounters, EdgesDuringResetAreNotCounted) {
  PositionCounter counter{};
  CNUD(counter, false, 5, kUpFromOne);
  CNUD(counter, true, 5, kUpFromOne);
  EXPECT_EQ(counter.value, 2U);
  CNUD(counter, false, 5, Pins(true, false, true));
  CNUD(counter, true, 5, Pins(true, false, true));
  CNUD(counter, true, 5, kUpFromOne);
  EXPECT_EQ(counter.value, 1U);
  EXPECT_FALSE(CNUD(counter, false, 1, Pins(true, false, true))) << "Q is 0 while P is 1, at the end value, too";
}

// covers: HOST50-202 HOST50-203
TEST(PositionCounters, FirstExecutionLoads) {
  PositionCounter counter{};
  counter.value = 7;  // written by the program before the first execution
  CNUD(counter, true, 9, kUpFromOne);
  EXPECT_EQ(counter.value, 1U);
  counter.value = 7;
  CNUD(counter, true, 9, kUpFromOne);
  EXPECT_EQ(counter.value, 7U) << "the input has not fallen";
  CNUD(counter, false, 9, kUpFromOne);
  CNUD(counter, true, 9, kUpFromOne);
  EXPECT_EQ(counter.value, 8U);
}

// covers: HOST50-204
TEST(PositionCounters, OutsideOfTheRing) {
  const auto next = [](uint32_t value, uint32_t preset, uint8_t pins, auto step) {
    PositionCounter counter{};
    step(counter, false, preset, pins);
    counter.value = value;
    step(counter, true, preset, pins);
    return counter.value;
  };
  EXPECT_EQ(next(10, 3, kUpFromOne, CNUD), 1U);
  EXPECT_EQ(next(10, 3, kUpFromOne, CNUDHold), 10U);
  EXPECT_EQ(next(0xFFFFFFFB, 3, kUpFromOne, CNUD), 0xFFFFFFFCU);  // -5 counts up to -4
  EXPECT_EQ(next(0xFFFFFFFB, 3, Pins(false, true, false), CNUD), 3U);
  EXPECT_EQ(next(0xFFFFFFFB, 3, Pins(false, true, false), CNUDHold), 0xFFFFFFFBU);
  EXPECT_EQ(next(10, 3, Pins(false, true, false), CNUD), 9U);
  EXPECT_EQ(next(0x7FFFFFFF, 0x7FFFFFFF, kUpFromOne, CNUDHold), 0x7FFFFFFFU);
}

// covers: HOST50-195..197
TEST(PositionCounters, RandomPins) {
  std::mt19937 random(23);
  for (int run = 0; run < 200; ++run) {
    const uint32_t preset = 1 + static_cast<uint32_t>(random() % 6);
    const bool down = random() % 2 == 1, from_one = random() % 2 == 1, holds = random() % 2 == 1;
    const uint32_t low = from_one ? 1 : 0, places = preset - low + 1;
    PositionCounter counter{};
    uint32_t steps = 0;  // from the start value
    bool first = true, before = false;
    for (int i = 0; i < 200; ++i) {
      const bool input = random() % 2 == 1, reset = random() % 20 == 0;
      if (first || reset) {
        steps = 0;
      } else if (input && !before) {
        const bool at_end = steps == places - 1;
        steps = !at_end ? steps + 1 : holds ? steps : 0;
      }
      first = false;
      before = input;
      const uint8_t pins = Pins(reset, down, from_one);
      const bool output = holds ? CNUDHold(counter, input, preset, pins) : CNUD(counter, input, preset, pins);
      ASSERT_EQ(counter.value, down ? preset - steps : low + steps);
      ASSERT_EQ(output, !reset && steps == places - 1);
    }
  }
}

}  // namespace
}  // namespace plcxx
