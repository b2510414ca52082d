// The scan tables and the rules of NC110 7.1.
#include "plcxx/timers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<OnDelayTimer>, "part of a state that is copied and cleared as bytes");

// covers: NC110-134, NC110-143, NC110-144, NC110-145, NC110-150
TEST(OnDelay, PulseGenerator) {
  // T50I(3) = /T50U, every 10 ms
  struct Row {
    uint32_t now;
    bool input;
    uint32_t elapsed;
    bool done, timing;
  };
  const Row rows[] = {
      {0, true, 0, false, true},    {10, true, 10, false, true},  {20, true, 20, false, true},
      {30, true, 30, true, false},  {40, false, 0, false, false}, {50, true, 0, false, true},
      {60, true, 10, false, true},  {70, true, 20, false, true},  {80, true, 30, true, false},
      {90, false, 0, false, false},
  };
  OnDelayTimer t50{};
  for (const Row& row : rows) {
    const bool input = !t50.done;
    EXPECT_EQ(input, row.input) << row.now;
    OnDelay(t50, input, 30, row.now);
    EXPECT_EQ(t50.input, row.input) << row.now;
    EXPECT_EQ(t50.elapsed_ms, row.elapsed) << row.now;
    EXPECT_EQ(t50.done, row.done) << row.now;
    EXPECT_EQ(t50.timing, row.timing) << row.now;
  }
}

// covers: NC110-133, NC110-149
TEST(OnDelay, FlipFlopOfTwoTimers) {
  // T2I(10)=/T3D, then T3I(10)=/T2D, every 10 ms
  OnDelayTimer t2{}, t3{};
  for (uint32_t now = 0; now <= 8040; now += 10) {
    OnDelay(t2, !t3.timing, 1000, now);
    OnDelay(t3, !t2.timing, 1000, now);
    // The table repeats every 2010 ms: T2 starts again one scan after T3 is done.
    const uint32_t phase = now % 2010;
    SCOPED_TRACE(now);
    if (phase < 1000) {
      EXPECT_TRUE(t2.input && !t2.done && t2.timing);
      EXPECT_TRUE(!t3.input && !t3.done && !t3.timing);
    } else if (phase == 1000) {
      EXPECT_TRUE(t2.input && t2.done && !t2.timing);
      EXPECT_TRUE(t3.input && !t3.done && t3.timing);
    } else if (phase < 2000) {
      EXPECT_TRUE(!t2.input && !t2.done && !t2.timing);
      EXPECT_TRUE(t3.input && !t3.done && t3.timing);
    } else {
      EXPECT_TRUE(!t2.input && !t2.done && !t2.timing);
      EXPECT_TRUE(t3.input && t3.done && !t3.timing);
    }
  }
}

// covers: NC110-141
TEST(OnDelay, PresetIsReadAtEveryExecution) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 1000, 0);
  OnDelay(timer, true, 1000, 50);
  EXPECT_TRUE(timer.timing);
  OnDelay(timer, true, 60, 60);  // shortened: ends at once
  EXPECT_TRUE(timer.done);
  EXPECT_FALSE(timer.timing);
  OnDelay(timer, true, 100000, 70);  // lengthened: stays done until the input is 0
  EXPECT_TRUE(timer.done);
  EXPECT_FALSE(timer.timing);
  OnDelay(timer, false, 100000, 80);
  EXPECT_FALSE(timer.done);
}

// covers: NC110-142
TEST(OnDelay, PresetZeroIsDoneInTheStartingExecution) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 0, 1234);
  EXPECT_TRUE(timer.done);
  EXPECT_FALSE(timer.timing);
}

// covers: NC110-146
TEST(OnDelay, HoldStopsTheTimeAndKeepsTiming) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 30, 0);
  OnDelay(timer, true, 30, 10);
  timer.hold = true;
  for (uint32_t now = 20; now <= 500; now += 10) {
    OnDelay(timer, true, 30, now);
    EXPECT_EQ(timer.elapsed_ms, 10U);
    EXPECT_TRUE(timer.timing);
  }
  timer.hold = false;
  OnDelay(timer, true, 30, 510);
  EXPECT_FALSE(timer.done);
  OnDelay(timer, true, 30, 520);
  EXPECT_TRUE(timer.done);
  timer.hold = true;
  OnDelay(timer, false, 30, 530);  // hold does not keep the input's fall from resetting
  EXPECT_FALSE(timer.done);
  EXPECT_TRUE(timer.hold);
}

// covers: NC110-146
TEST(OnDelay, HoldAtTheStart) {
  OnDelayTimer timer{};
  timer.hold = true;
  OnDelay(timer, true, 20, 0);
  EXPECT_TRUE(timer.input);
  EXPECT_TRUE(timer.timing);
  OnDelay(timer, true, 20, 1000);
  EXPECT_TRUE(timer.timing);
  EXPECT_EQ(timer.elapsed_ms, 0U);
  timer.hold = false;
  OnDelay(timer, true, 20, 1020);
  EXPECT_TRUE(timer.done);
}

// covers: NC110-152
TEST(OnDelay, TimeOfSkippedExecutionsIsAddedLater) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 100, 0);
  const OnDelayTimer frozen = timer;
  EXPECT_TRUE(frozen.timing && frozen.input && !frozen.done);
  OnDelay(timer, true, 100, 100);  // 9 executions were skipped
  EXPECT_TRUE(timer.done);

  timer = frozen;
  timer.hold = true;  // it is the hold at the next execution that decides
  OnDelay(timer, true, 100, 100);
  EXPECT_EQ(timer.elapsed_ms, 0U);
  EXPECT_TRUE(timer.timing);
}

// covers: NC110-147
TEST(OnDelay, InputAndHoldCanBeRead) {
  OnDelayTimer timer{};
  timer.hold = true;
  OnDelay(timer, true, 10, 0);
  EXPECT_TRUE(timer.input && timer.hold);
  OnDelay(timer, false, 10, 10);
  EXPECT_TRUE(!timer.input && timer.hold);
}

// covers: NC110-154
TEST(OnDelay, TwoStatementsBothStep) {
  OnDelayTimer timer{};
  for (uint32_t now = 0; now <= 30; now += 10) {
    OnDelay(timer, true, 30, now);
    OnDelay(timer, true, 30, now);  // no time has passed since the other one
    EXPECT_EQ(timer.elapsed_ms, now);
  }
  EXPECT_TRUE(timer.done);
}

// The host may write the signals of a timer: one whose input it took away starts from zero.
TEST(OnDelay, StartForgetsTheTimeBefore) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 100, 0);
  OnDelay(timer, true, 100, 90);
  timer.input = false;
  OnDelay(timer, true, 100, 200);
  EXPECT_EQ(timer.elapsed_ms, 0U);
  EXPECT_TRUE(timer.timing);
}

TEST(OnDelay, ClockMayWrap) {
  OnDelayTimer timer{};
  const uint32_t start = 0xFFFFFFF0;
  for (uint32_t t = 0; t <= 50; t += 10) {
    OnDelay(timer, true, 40, start + t);
    EXPECT_EQ(timer.elapsed_ms, t);
    EXPECT_EQ(timer.done, t >= 40);
  }
}

TEST(OnDelay, ElapsedSaturates) {
  OnDelayTimer timer{};
  OnDelay(timer, true, 0xFFFFFFFF, 0);
  for (int i = 1; i <= 3; ++i) OnDelay(timer, true, 0xFFFFFFFF, static_cast<uint32_t>(i) * 0x7FFFFFFFU);
  EXPECT_EQ(timer.elapsed_ms, 0xFFFFFFFF);
  EXPECT_TRUE(timer.done);
}

/// The pseudo code of the paragraph, in unlimited integers: time since the start less the time held.
TEST(OnDelay, RandomHistoriesAgreeWithUnlimitedTime) {
  std::mt19937 random(3);
  for (int history = 0; history < 200; ++history) {
    OnDelayTimer timer{};
    int64_t now = random(), last = 0, elapsed = 0;
    bool input = false, done = false;
    for (int step = 0; step < 200; ++step) {
      now += random() % 500;
      const bool v = random() % 8 != 0;
      const bool hold = random() % 4 == 0;
      const int64_t preset = random() % 2000;
      timer.hold = hold;
      OnDelay(timer, v, static_cast<uint32_t>(preset), static_cast<uint32_t>(now));
      if (!v || !input) elapsed = 0;
      if (v && input && !hold) elapsed += now - last;
      done = v && (done || elapsed >= preset);
      input = v;
      last = now;
      ASSERT_EQ(timer.input, input);
      ASSERT_EQ(timer.done, done);
      ASSERT_EQ(timer.timing, v && !done);
      ASSERT_EQ(timer.elapsed_ms, elapsed);
    }
  }
}

}  // namespace
}  // namespace plcxx
