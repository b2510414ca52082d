// The scan tables and the rules of PROSTEP 7.1.
#include "plcxx/time_word_timers.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <type_traits>
#include <vector>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<TimeWordTimer>, "part of a state that is copied and cleared as bytes");

using Start = bool (*)(TimeWordTimer&, bool, uint16_t);
constexpr uint16_t kFortyMs = 0x0040;

/// The columns of a worked table: S before and behind the instruction, L T at the end of the pass; `reset_in` is the
/// pass in which R T follows the start instruction, counted from 0.
struct Table {
  Start start;
  std::string_view s_in, s_after;
  std::vector<uint16_t> left;
  int reset_in = -1;
};

void Check(const Table& table) {
  TimeWordTimer timer{};
  ASSERT_EQ(table.s_in.size(), table.left.size());
  for (size_t pass = 0; pass < table.left.size(); ++pass) {
    SCOPED_TRACE("t = " + std::to_string(12 * (pass + 1)));
    PassTime(timer, 12);
    EXPECT_EQ(table.start(timer, table.s_in[pass] == '1', kFortyMs), table.s_after[pass] == '1');
    if (static_cast<int>(pass) == table.reset_in) ResetTimer(timer, true);
    EXPECT_EQ(TimeLeft(timer), table.left[pass]);
  }
}

// covers: PS-100
TEST(TimeWordTimers, Pulse) { Check({StartPulse, "1111110110", "1111000110", {40, 28, 16, 4, 0, 0, 0, 40, 28, 0}}); }

// covers: PS-101
TEST(TimeWordTimers, ExtendedPulse) { Check({StartExtended, "10111111", "11111100", {40, 28, 40, 28, 16, 4, 0, 0}}); }

// covers: PS-102, PS-107
TEST(TimeWordTimers, OnDelay) {
  Check({StartOnDelay, "111110111110", "000010000010", {40, 28, 16, 4, 0, 0, 40, 28, 16, 4, 0, 0}, 10});
}

// covers: PS-103, PS-104, PS-107
TEST(TimeWordTimers, LatchedDelay) {
  Check({StartLatchedDelay, "1000001000011", "0000111110000", {40, 28, 16, 4, 0, 0, 0, 0, 0, 0, 0, 40, 28}, 8});
}

// covers: PS-105, PS-106, PS-107
TEST(TimeWordTimers, OffDelay) {
  Check({StartOffDelay, "1100000101111", "1111110111110", {0, 0, 40, 28, 16, 4, 0, 0, 40, 0, 0, 0, 0}, 11});
}

// covers: PS-109, PS-117
TEST(TimeWordTimers, ScalesAndTheLongestTime) {
  const struct {
    uint16_t word;
    uint32_t ms;
  } rows[] = {{0x0040, 40}, {0x1040, 400}, {0x2050, 5000}, {0x3002, 2000}, {0x3999, 999'000}, {0xC040, 40}};
  for (const auto& row : rows) {
    TimeWordTimer timer{};
    EXPECT_TRUE(StartExtended(timer, true, row.word));
    EXPECT_EQ(timer.left_ms, row.ms) << row.word;
    PassTime(timer, row.ms - 1);
    EXPECT_TRUE(timer.output) << row.word;
    PassTime(timer, 1);
    EXPECT_FALSE(timer.output) << row.word;
  }
}

// covers: PS-114, PS-115
TEST(TimeWordTimers, WhatIsLeftIsRoundedUp) {
  TimeWordTimer timer{};
  EXPECT_EQ(TimeLeft(timer), 0);
  EXPECT_EQ(TimeLeftCoded(timer), 0);
  StartExtended(timer, true, 0x1040);
  EXPECT_EQ(TimeLeftCoded(timer), 0x1040);
  PassTime(timer, 1);
  EXPECT_EQ(TimeLeft(timer), 40);
  PassTime(timer, 9);
  EXPECT_EQ(TimeLeft(timer), 39);
  EXPECT_EQ(TimeLeftCoded(timer), 0x1039);
  PassTime(timer, 1000);
  EXPECT_EQ(TimeLeft(timer), 0);
  EXPECT_EQ(TimeLeftCoded(timer), 0x1000);  // the scale stays
}

// covers: PS-116
TEST(TimeWordTimers, ZeroTime) {
  TimeWordTimer timer{};
  EXPECT_FALSE(StartPulse(timer, true, 0));
  timer = {};
  EXPECT_FALSE(StartExtended(timer, true, 0));
  timer = {};
  EXPECT_TRUE(StartOnDelay(timer, true, 0));
  timer = {};
  EXPECT_TRUE(StartLatchedDelay(timer, true, 0));
  timer = {};
  EXPECT_TRUE(StartOffDelay(timer, true, 0));
  EXPECT_FALSE(StartOffDelay(timer, false, 0));
}

// covers: PS-107, PS-108
TEST(TimeWordTimers, AResetTimerStaysOffUntilANewEdge) {
  for (const Start start : {StartPulse, StartExtended, StartOnDelay, StartLatchedDelay}) {
    TimeWordTimer timer{};
    start(timer, true, kFortyMs);
    ResetTimer(timer, false);
    EXPECT_EQ(timer.left_ms, 40u);
    ResetTimer(timer, true);
    EXPECT_FALSE(start(timer, true, kFortyMs));
    EXPECT_EQ(timer.left_ms, 0u);
    start(timer, false, kFortyMs);
    start(timer, true, kFortyMs);
    EXPECT_EQ(timer.left_ms, 40u);
  }
  TimeWordTimer timer{};
  StartOffDelay(timer, true, kFortyMs);
  ResetTimer(timer, true);
  EXPECT_FALSE(StartOffDelay(timer, false, kFortyMs));  // a falling edge alone starts nothing
  EXPECT_EQ(timer.left_ms, 0u);
}

/// 7.1 once more, written down independently: signed milliseconds, one function.
struct Reference {
  int type = 0;
  bool run = false, out = false, edge = false;
  long long rem = 0;

  bool Load(uint16_t word) {
    const long long scales[] = {1, 10, 100, 1000};
    rem = ((word >> 8 & 15) * 100 + (word >> 4 & 15) * 10 + (word & 15)) * scales[word >> 12 & 3];
    return rem > 0;
  }
  void Advance(long long ms) {
    if (!run) return;
    rem -= ms;
    if (rem > 0) return;
    rem = 0;
    run = false;
    out = type == 2 || type == 3;
  }
  bool Step(int kind, bool s, uint16_t word) {
    const bool rise = s && !edge, fall = edge && !s;
    edge = s;
    type = kind;
    if (kind == 0) {
      if (!s) {
        out = run = false;
        rem = 0;
      } else if (rise) {
        run = out = Load(word);
      }
    } else if (kind == 1) {
      if (rise) run = out = Load(word);
    } else if (kind == 2) {
      if (!s) {
        out = run = false;
        rem = 0;
      } else if (rise) {
        run = Load(word);
        out = !run;
      }
    } else if (kind == 3) {
      if (rise && !out) {
        run = Load(word);
        out = !run;
      }
    } else {
      if (rise) {
        out = true;
        run = false;
        rem = 0;
      } else if (fall && out) {
        run = Load(word);
        out = run;
      }
    }
    return out;
  }
};

// covers: PS-121, PS-122
TEST(TimeWordTimers, RandomStepsOfAllKindsOnOneTimer) {
  constexpr std::array<Start, 5> kStarts = {StartPulse, StartExtended, StartOnDelay, StartLatchedDelay, StartOffDelay};
  std::mt19937 random(11);
  TimeWordTimer timer{};
  Reference reference;
  for (int i = 0; i < 200'000; ++i) {
    const auto ms = static_cast<uint32_t>(random() % 40);
    PassTime(timer, ms);
    reference.Advance(ms);
    if (random() % 9 == 0) {
      ResetTimer(timer, true);
      reference.out = reference.run = false;
      reference.rem = 0;
    }
    // Mostly one kind for a while, sometimes another one; digits above 9 count as they are.
    const int kind = random() % 50 == 0 ? static_cast<int>(random() % 5) : reference.type;
    const bool s = random() % 2 != 0;
    const auto word = static_cast<uint16_t>(random() % 3 == 0 ? random() & 0xFFFF : random() & 0x00FF);
    ASSERT_EQ(kStarts[static_cast<size_t>(kind)](timer, s, word), reference.Step(kind, s, word)) << i;
    ASSERT_EQ(timer.running, reference.run) << i;
    ASSERT_EQ(timer.edge, reference.edge) << i;
    ASSERT_EQ(timer.left_ms, reference.rem) << i;
  }
}

}  // namespace
}  // namespace plcxx
