// The scan table and the rules of NC110 7.3, driven by the period of 4.3.
#include "plcxx/one_shots.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <type_traits>

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<OneShot>, "part of a state that is copied and cleared as bytes");

using Step = std::function<void()>;

/// One period of 4.3, with one one-shot and the statements given to it.
struct Schedule {
  uint8_t slices = 1;
  OneShot shot{};
  uint32_t slow_cycle = 0, slow_done = 0;
  uint8_t slice = 0;

  void Period(const Step& fast, const Step& slow_slice) {
    fast();
    ExpireFast(shot, slow_done);
    if (slice == 0) ++slow_cycle;
    slow_slice();
    if (++slice == slices) {
      slice = 0;
      ++slow_done;
      ExpireSlow(shot, slow_cycle);
    }
  }
  void Fast(bool input) { PulseFast(shot, input, slow_done, slice); }
  void Slow(bool input) { PulseSlow(shot, input, slow_cycle); }
};

const Step kNothing = [] {};

// covers: NC110-176, NC110-179
TEST(OneShot, ScanTable) {
  // P6 = I1A3
  const bool inputs[] = {false, true, true, false, true};
  const bool pulses[] = {false, true, false, false, true};
  Schedule s;
  for (int i = 0; i < 5; ++i) {
    s.Period(kNothing, [&] { s.Slow(inputs[i]); });
    EXPECT_EQ(s.shot.pulse, pulses[i]) << i;
    EXPECT_EQ(s.shot.previous, inputs[i]) << i;
  }
}

// covers: NC110-177
TEST(OneShot, StatementBeforeItSeesThePulseInTheNextCycle) {
  Schedule s;
  int before = 0, after = 0, first_before = 0, first_after = 0;
  for (int scan = 1; scan <= 6; ++scan) {
    s.Period(kNothing, [&] {
      if (s.shot.pulse && before++ == 0) first_before = scan;
      s.Slow(scan >= 2);
      if (s.shot.pulse && after++ == 0) first_after = scan;
    });
  }
  EXPECT_EQ(after, 1);
  EXPECT_EQ(first_after, 2);
  EXPECT_EQ(before, 1);
  EXPECT_EQ(first_before, 3);
}

// covers: NC110-178
TEST(OneShot, InputOneInTheFirstScan) {
  Schedule slow, fast;
  slow.Period(kNothing, [&] { slow.Slow(true); });
  EXPECT_TRUE(slow.shot.pulse);
  fast.Period([&] { fast.Fast(true); }, kNothing);
  EXPECT_TRUE(fast.shot.pulse);
}

// covers: NC110-181
TEST(OneShot, SkippedStatementDoesNotKeepThePulse) {
  Schedule s;
  s.Period(kNothing, [&] { s.Slow(true); });
  EXPECT_TRUE(s.shot.pulse);
  bool seen_in_skipped_cycle = false;
  s.Period(kNothing, [&] { seen_in_skipped_cycle = s.shot.pulse; });
  EXPECT_TRUE(seen_in_skipped_cycle);  // until the end of that cycle
  EXPECT_FALSE(s.shot.pulse);
  s.Period(kNothing, [&] { s.Slow(true); });
  EXPECT_FALSE(s.shot.pulse);  // the input has not fallen for the statement
}

// covers: NC110-180
TEST(OneShot, FastPulseWithOneSliceIsSeenInExactlyOneSlowCycle) {
  Schedule s;
  int seen = 0;
  for (int period = 0; period < 8; ++period) {
    s.Period([&] { s.Fast(period >= 3); }, [&] { seen += s.shot.pulse ? 1 : 0; });
  }
  EXPECT_EQ(seen, 1);
}

// covers: NC110-180
TEST(OneShot, FastPulseCoversACompleteSlowCycle) {
  for (const uint8_t slices : std::initializer_list<uint8_t>{1, 2, 3, 5}) {
    for (int start = 0; start < 2 * slices; ++start) {
      Schedule s{slices};
      int in_this_cycle = 0, complete_cycles = 0, periods = 0;
      for (int period = 0; period < 10 * slices; ++period) {
        s.Period([&] { s.Fast(period == start); },  // the input falls at once: nothing changes a running pulse
                 [&] {
                   if (s.slice == 0) in_this_cycle = 0;
                   if (s.shot.pulse) ++in_this_cycle, ++periods;
                   if (s.slice + 1 == slices && in_this_cycle == slices) ++complete_cycles;
                 });
      }
      EXPECT_EQ(complete_cycles, 1) << int{slices} << ' ' << start;
      EXPECT_EQ(periods, slices + (slices - start % slices) % slices) << int{slices} << ' ' << start;
      EXPECT_FALSE(s.shot.pulse);
    }
  }
}

// covers: NC110-179, NC110-180
TEST(OneShot, FastInputIsFollowedWhileThePulseRuns) {
  Schedule s{4};
  const auto period = [&](bool input) { s.Period([&] { s.Fast(input); }, kNothing); };
  period(true);
  period(false);
  period(true);  // rises during the pulse: swallowed
  EXPECT_TRUE(s.shot.pulse);
  period(true);
  period(true);  // the slow cycle is complete: no new edge
  EXPECT_FALSE(s.shot.pulse);
  period(false);
  period(true);
  EXPECT_TRUE(s.shot.pulse);
}

// covers: NC110-181
TEST(OneShot, SkippedFastStatement) {
  Schedule s;
  s.Period([&] { s.Fast(true); }, kNothing);
  EXPECT_TRUE(s.shot.pulse);
  s.Period(kNothing, kNothing);
  EXPECT_FALSE(s.shot.pulse);
}

// covers: NC110-248
TEST(OneShot, FastStatementEndsAPulseOfTheSlowPart) {
  Schedule s;
  s.Period([&] { s.Fast(false); }, [&] { s.Slow(true); });
  EXPECT_TRUE(s.shot.pulse);
  s.Period(
      [&] {
        s.Fast(true);  // no edge, and no pulse of its own that would run on
        EXPECT_FALSE(s.shot.pulse);
      },
      kNothing);
  EXPECT_FALSE(s.shot.pulse);
}

// covers: NC110-248
TEST(OneShot, StampOfTheSlowPartIsNoTargetOfTheFastPart) {
  OneShot shot{};
  PulseSlow(shot, true, 1000);  // a stamp far above slow_done
  PulseFast(shot, true, 10, 0);
  EXPECT_FALSE(shot.pulse);
  PulseFast(shot, false, 10, 0);
  PulseSlow(shot, true, 11);
  PulseFast(shot, false, 10, 0);
  PulseFast(shot, true, 10, 1);  // a new edge in the fast part
  EXPECT_TRUE(shot.pulse && shot.fast);
  EXPECT_EQ(shot.target, 12U);
}

// covers: NC110-248
TEST(OneShot, FastStatementLeavesARunningPulseAloneWhoeverStartedIt) {
  OneShot shot{};
  PulseFast(shot, true, 10, 1);   // target 12
  PulseSlow(shot, false, 11);     // the slow statement ends it
  PulseSlow(shot, true, 12);      // and starts one of its own
  PulseFast(shot, false, 11, 0);  // 7.3: P is 1 and 11 < 12
  EXPECT_TRUE(shot.pulse);
  PulseFast(shot, false, 12, 0);
  EXPECT_FALSE(shot.pulse);
}

// covers: NC110-248
TEST(OneShot, TargetStaysAheadWhereAFastStatementFindsNoPulse) {
  OneShot shot{};
  PulseFast(shot, true, 10, 1);   // target 12
  PulseSlow(shot, false, 11);     // the slow statement ends it
  PulseFast(shot, false, 11, 0);  // no pulse: nothing of 7.3 changes the target
  PulseSlow(shot, true, 12);
  PulseFast(shot, false, 11, 0);  // P is 1 and 11 < 12
  EXPECT_TRUE(shot.pulse);
}

// covers: NC110-248
TEST(OneShot, SlowStatementEndsAPulseOfTheFastPart) {
  Schedule s;
  bool before = false, after = true;
  s.Period([&] { s.Fast(true); },
           [&] {
             before = s.shot.pulse;
             s.Slow(true);
             after = s.shot.pulse;
           });
  EXPECT_TRUE(before);
  EXPECT_FALSE(after);
}

TEST(OneShot, ExpiryTouchesOnlyPulsesOfItsPart) {
  OneShot slow{}, fast{};
  PulseSlow(slow, true, 5);
  ExpireFast(slow, 100);
  EXPECT_TRUE(slow.pulse);
  ExpireSlow(slow, 5);
  EXPECT_TRUE(slow.pulse);
  ExpireSlow(slow, 6);
  EXPECT_FALSE(slow.pulse);
  PulseFast(fast, true, 5, 0);
  ExpireSlow(fast, 100);
  EXPECT_TRUE(fast.pulse);
  ExpireFast(fast, 5);
  EXPECT_TRUE(fast.pulse);
  ExpireFast(fast, 6);
  EXPECT_FALSE(fast.pulse);
}

// covers: NC110-248
TEST(OneShot, PulseBelongsToThePartThatStartedItLast) {
  OneShot shot{};
  PulseFast(shot, true, 10, 0);
  PulseSlow(shot, false, 11);
  PulseSlow(shot, true, 12);
  ExpireFast(shot, 100);
  EXPECT_TRUE(shot.pulse);
  ExpireSlow(shot, 13);
  EXPECT_FALSE(shot.pulse);
}

TEST(OneShot, ATargetIsAheadByLessThanHalfOfAllCounts) {
  EXPECT_TRUE(ReachedSlowCycle(7, 7));
  EXPECT_FALSE(ReachedSlowCycle(7, 8));
  EXPECT_TRUE(ReachedSlowCycle(0x7FFFFFFF, 0));
  EXPECT_FALSE(ReachedSlowCycle(0x80000000, 0));
  EXPECT_TRUE(ReachedSlowCycle(1, 0xFFFFFFFF));
  EXPECT_FALSE(ReachedSlowCycle(0xFFFFFFFF, 1));
}

TEST(OneShot, CyclesMayWrap) {
  for (uint32_t start = 0xFFFFFFFB; start != 3; ++start) {
    Schedule s{2};
    s.slow_cycle = s.slow_done = start;
    int periods = 0;
    for (int period = 0; period < 12; ++period) {
      s.Period([&] { s.Fast(period == 1); }, [&] { periods += s.shot.pulse ? 1 : 0; });
    }
    EXPECT_EQ(periods, 3) << start;

    Schedule slow;
    slow.slow_cycle = slow.slow_done = start;
    slow.Period(kNothing, [&] { slow.Slow(true); });
    EXPECT_TRUE(slow.shot.pulse);
    slow.Period(kNothing, kNothing);
    EXPECT_FALSE(slow.shot.pulse);
  }
}

}  // namespace
}  // namespace plcxx
