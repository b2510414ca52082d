// The scan table and the rules of NC110 7.2, for the three ends of the carry.
#include "plcxx/counters.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <random>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<RingCounter>, "part of a state that is copied and cleared as bytes");

/// A counter whose input statement stands in the slow part: one call of Scan is one slow cycle.
struct SlowCounter {
  RingCounter counter{};
  uint32_t cycle = 0;

  bool Scan(bool input, uint16_t modulus) {
    ++cycle;
    const bool in_range = CountSlow(counter, input, modulus, cycle);
    ExpireSlow(counter, cycle);
    return in_range;
  }
  void SkippedScan() {
    ++cycle;
    ExpireSlow(counter, cycle);
  }
  /// An input that rises and falls again; the carry is the one of the rising scan.
  bool Pulse(uint16_t modulus) {
    Scan(true, modulus);
    const bool carry = counter.carry;
    Scan(false, modulus);
    return carry;
  }
};

// covers: NC110-157, NC110-158, NC110-160, NC110-247
TEST(RingCounter, ScanTable) {
  // C5I(3) = I0A0
  struct Row {
    bool input;
    uint8_t count;
    bool carry;
  };
  const Row rows[] = {{true, 1, false},  {true, 1, false}, {false, 1, false}, {true, 2, false},
                      {false, 2, false}, {true, 0, true},  {true, 0, false}};
  SlowCounter c5;
  for (const Row& row : rows) {
    EXPECT_TRUE(c5.Scan(row.input, 3));
    EXPECT_EQ(c5.counter.count, row.count);
    EXPECT_EQ(c5.counter.carry, row.carry);
    EXPECT_EQ(c5.counter.input, row.input);
  }
}

// covers: NC110-159, NC110-161
TEST(RingCounter, CountsDownAndTurnsAtAnyTime) {
  SlowCounter c;
  c.counter.down = true;
  EXPECT_TRUE(c.Pulse(4));  // 0 -> 3
  EXPECT_EQ(c.counter.count, 3);
  EXPECT_FALSE(c.Pulse(4));
  EXPECT_EQ(c.counter.count, 2);
  c.counter.down = false;
  EXPECT_FALSE(c.Pulse(4));
  EXPECT_EQ(c.counter.count, 3);
  EXPECT_TRUE(c.Pulse(4));
  EXPECT_EQ(c.counter.count, 0);
  c.counter.down = true;
  EXPECT_TRUE(c.Pulse(255));
  EXPECT_EQ(c.counter.count, 254);
}

// covers: NC110-162, NC110-163, NC110-164
TEST(RingCounter, ResetClearsOnItsEdgeAndBlocks) {
  SlowCounter c;
  c.counter.count = 2;
  c.counter.down = true;
  c.Scan(true, 3);
  c.counter.carry = true;
  ResetCounter(c.counter, true);
  EXPECT_EQ(c.counter.count, 0);
  EXPECT_FALSE(c.counter.carry);
  EXPECT_FALSE(c.counter.input);
  EXPECT_FALSE(c.counter.down);
  EXPECT_TRUE(c.counter.reset);

  c.counter.count = 7;  // a direct assignment while the reset is 1 stays (D10)
  c.counter.down = true;
  for (int i = 0; i < 3; ++i) {
    ResetCounter(c.counter, true);
    EXPECT_FALSE(c.Pulse(10));
    EXPECT_EQ(c.counter.count, 7);
    EXPECT_TRUE(c.counter.down);
  }
  ResetCounter(c.counter, false);
  EXPECT_EQ(c.counter.count, 7);
  c.Pulse(10);
  EXPECT_EQ(c.counter.count, 6);
  ResetCounter(c.counter, true);
  EXPECT_EQ(c.counter.count, 0);
}

// covers: NC110-172
TEST(RingCounter, InputStillOneAfterResetCountsOnce) {
  SlowCounter c;
  c.Scan(true, 10);
  ResetCounter(c.counter, true);
  c.Scan(true, 10);
  EXPECT_FALSE(c.counter.input);
  EXPECT_EQ(c.counter.count, 0);
  ResetCounter(c.counter, false);
  c.Scan(true, 10);
  EXPECT_EQ(c.counter.count, 1);
  c.Scan(true, 10);
  EXPECT_EQ(c.counter.count, 1);
}

// covers: NC110-165
TEST(RingCounter, CountAtOrAboveTheModulus) {
  for (const uint8_t count : std::initializer_list<uint8_t>{3, 4, 200, 255}) {
    SlowCounter up;
    up.counter.count = count;
    EXPECT_TRUE(up.Pulse(4));
    EXPECT_EQ(up.counter.count, 0);
    SlowCounter down;
    down.counter.down = true;
    down.counter.count = count;
    EXPECT_FALSE(down.Pulse(4));
    EXPECT_EQ(down.counter.count, count - 1);
  }
}

// covers: NC110-166, NC110-167
TEST(RingCounter, ModulusOutOfRangeDoesNotCount) {
  for (const uint16_t modulus : std::initializer_list<uint16_t>{0, 1, 256, 257, 0x0102, 0xFFFF}) {
    for (bool down : {false, true}) {
      SlowCounter c;
      c.counter.down = down;
      c.counter.count = 9;
      EXPECT_FALSE(c.Scan(true, modulus)) << modulus;
      EXPECT_EQ(c.counter.count, 9);
      EXPECT_FALSE(c.counter.carry);
      EXPECT_TRUE(c.counter.input);        // the edge is spent
      EXPECT_TRUE(c.Scan(true, modulus));  // no edge: nothing to report
      EXPECT_TRUE(c.Scan(false, modulus));
      ResetCounter(c.counter, true);
      EXPECT_TRUE(c.Scan(true, modulus));  // blocked: nothing to report
      RingCounter while_input{}, until_next{};
      EXPECT_FALSE(CountCarryWhileInput(while_input, true, modulus));
      EXPECT_FALSE(CountCarryUntilNext(until_next, true, modulus));
      EXPECT_TRUE(CountCarryWhileInput(while_input, true, modulus));
      EXPECT_TRUE(CountCarryUntilNext(until_next, true, modulus));
      RingCounter fast{};
      EXPECT_FALSE(CountFast(fast, true, modulus, 1));
      EXPECT_TRUE(CountFast(fast, true, modulus, 2));
    }
  }
  SlowCounter c;  // read at every execution
  c.Pulse(255);
  c.Pulse(255);
  EXPECT_TRUE(c.Pulse(2));
  EXPECT_EQ(c.counter.count, 0);
}

// covers: NC110-173
TEST(RingCounter, SkippedStatementKeepsTheCountAndEndsTheCarry) {
  SlowCounter c;
  c.Pulse(2);
  c.Scan(true, 2);
  EXPECT_TRUE(c.counter.carry);
  c.SkippedScan();
  EXPECT_FALSE(c.counter.carry);
  EXPECT_EQ(c.counter.count, 0);
  EXPECT_TRUE(c.counter.input);
  c.Scan(true, 2);
  EXPECT_EQ(c.counter.count, 0);  // the input has not fallen for the statement
}

// covers: NC110-174
TEST(RingCounter, FastPart) {
  RingCounter c{};
  uint32_t fast_count = 0xFFFFFFFE;  // the number may wrap
  const auto execute = [&](bool input) {
    ++fast_count;
    EXPECT_TRUE(CountFast(c, input, 2, fast_count));
    ExpireFast(c, fast_count);
  };
  execute(true);
  execute(false);
  execute(true);
  EXPECT_TRUE(c.carry);
  ExpireSlow(c, 77);  // not this part's carry
  EXPECT_TRUE(c.carry);
  ++fast_count;
  ExpireFast(c, fast_count);
  EXPECT_FALSE(c.carry);
  EXPECT_EQ(c.count, 0);

  SlowCounter slow;
  slow.Pulse(2);
  slow.Scan(true, 2);
  ExpireFast(slow.counter, 77);
  EXPECT_TRUE(slow.counter.carry);
}

// covers: NC110-172
TEST(RingCounter, ResetWrittenByTheHost) {
  SlowCounter c;
  c.Scan(true, 10);
  c.counter.reset = true;  // without the edge of an assignment in the program: nothing is cleared ...
  c.Scan(true, 10);
  EXPECT_EQ(c.counter.count, 1);
  EXPECT_FALSE(c.counter.input);  // ... but the statement forgets its input
  c.counter.reset = false;
  c.Scan(true, 10);
  EXPECT_EQ(c.counter.count, 2);
}

TEST(RingCounter, CarryBelongsToThePartThatSetItLast) {
  RingCounter c{};
  c.count = 1;
  CountFast(c, true, 2, 100);
  EXPECT_TRUE(c.carry);
  EXPECT_EQ(c.part, kCarryOfFastPart);
  CountSlow(c, false, 2, 7);
  c.count = 1;
  CountSlow(c, true, 2, 8);
  ExpireFast(c, 101);
  EXPECT_TRUE(c.carry);
  ExpireSlow(c, 9);
  EXPECT_FALSE(c.carry);
}

TEST(RingCounter, CarryWrittenByTheHostEndsInEitherPart) {
  RingCounter in_slow{}, in_fast{};
  in_slow.carry = in_fast.carry = true;
  ExpireSlow(in_slow, 1);
  ExpireFast(in_fast, 1);
  EXPECT_FALSE(in_slow.carry);
  EXPECT_FALSE(in_fast.carry);
}

TEST(RingCounter, SlowCycleMayWrap) {
  SlowCounter c;
  c.cycle = 0xFFFFFFFC;
  c.Pulse(2);
  c.Scan(true, 2);
  EXPECT_EQ(c.cycle, 0xFFFFFFFF);
  EXPECT_TRUE(c.counter.carry);
  c.SkippedScan();
  EXPECT_FALSE(c.counter.carry);
}

// covers: NC110-246
TEST(RingCounter, CarryWhileInput) {
  RingCounter c{};
  const auto scan = [&](bool input) {
    CountCarryWhileInput(c, input, 2);
    return c.carry;
  };
  EXPECT_FALSE(scan(true));
  EXPECT_FALSE(scan(false));
  EXPECT_TRUE(scan(true));
  EXPECT_TRUE(scan(true));
  EXPECT_TRUE(scan(true));
  EXPECT_FALSE(scan(false));
  EXPECT_EQ(c.count, 0);
  EXPECT_FALSE(scan(true));
  EXPECT_FALSE(scan(false));
  EXPECT_TRUE(scan(true));
  ResetCounter(c, true);
  EXPECT_FALSE(scan(true));
}

// covers: NC110-246
TEST(RingCounter, CarryUntilNextEdge) {
  RingCounter c{};
  const auto scan = [&](bool input, uint16_t modulus = 2) {
    CountCarryUntilNext(c, input, modulus);
    return c.carry;
  };
  EXPECT_FALSE(scan(true));
  EXPECT_FALSE(scan(false));
  EXPECT_TRUE(scan(true));
  EXPECT_TRUE(scan(true));
  EXPECT_TRUE(scan(false));
  EXPECT_FALSE(scan(true));
  EXPECT_EQ(c.count, 1);
  scan(false);
  EXPECT_TRUE(scan(true));
  ResetCounter(c, true);
  EXPECT_FALSE(c.carry);
  ResetCounter(c, false);
  scan(true);
  scan(false);
  EXPECT_TRUE(scan(true));
  scan(false);
  EXPECT_FALSE(scan(true, 0));  // an edge that is not counted ends it too
}

// covers: NC110-170
TEST(RingCounter, ToggleIdiom) {
  SlowCounter c;
  for (int i = 1; i <= 6; ++i) {
    EXPECT_EQ(c.Pulse(2), i % 2 == 0);
    EXPECT_EQ(c.counter.count, i % 2);
  }
}

/// The pseudo code of the paragraph in plain integers.
struct Reference {
  enum class Carry { kScan, kInput, kNext };
  Carry mode;
  int i = 0, a = 0, z = 0, r = 0, w = 0;

  void Reset(int v) {
    if (v == 1 && z == 0) w = r = i = a = 0;
    z = v;
  }
  bool Count(int v, int m) {
    if (mode == Carry::kScan || (mode == Carry::kInput && v == 0)) r = 0;
    if (z == 1) {
      i = 0;
      return true;
    }
    const bool rising = v == 1 && i == 0;
    i = v;
    if (!rising) return true;
    if (mode == Carry::kNext) r = 0;
    if (m < 2 || m > 255) return false;
    if (a == 0) {
      if (w + 1 >= m) {
        w = 0;
        r = 1;
      } else {
        w = w + 1;
      }
    } else if (w == 0) {
      w = m - 1;
      r = 1;
    } else {
      w = w - 1;
    }
    return true;
  }
};

TEST(RingCounter, RandomHistoriesAgreeWithThePseudoCode) {
  std::mt19937 random(5);
  for (auto mode : {Reference::Carry::kScan, Reference::Carry::kInput, Reference::Carry::kNext}) {
    for (int history = 0; history < 100; ++history) {
      Reference expected{mode};
      RingCounter c{};
      for (int step = 0; step < 300; ++step) {
        if (random() % 16 == 0) expected.a = c.down = random() % 2 != 0;
        if (random() % 16 == 0) expected.w = c.count = static_cast<uint8_t>(random());
        if (random() % 8 == 0) {
          const bool v = random() % 3 == 0;
          expected.Reset(v);
          ResetCounter(c, v);
        }
        const bool v = random() % 2 != 0;
        const auto m = static_cast<uint16_t>(random() % 8 != 0 ? random() % 6 : random() % 300);
        bool in_range = false;
        switch (mode) {
          case Reference::Carry::kScan:
            in_range = step % 2 == 0 ? CountSlow(c, v, m, 1) : CountFast(c, v, m, 1);
            break;
          case Reference::Carry::kInput:
            in_range = CountCarryWhileInput(c, v, m);
            break;
          case Reference::Carry::kNext:
            in_range = CountCarryUntilNext(c, v, m);
            break;
        }
        ASSERT_EQ(in_range, expected.Count(v, m));
        ASSERT_EQ(c.count, expected.w);
        ASSERT_EQ(c.carry, expected.r == 1);
        ASSERT_EQ(c.input, expected.i == 1);
        ASSERT_EQ(c.down, expected.a == 1);
        ASSERT_EQ(c.reset, expected.z == 1);
      }
    }
  }
}

}  // namespace
}  // namespace plcxx
