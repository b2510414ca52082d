// Stepping: which periods run, and what the time is afterwards.
#include "transpiler/sim/clock.h"

#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A slow cycle takes SLICES periods; NOW is the time of the last period, FAST counts executions of the fast part.
constexpr std::string_view kSliced = R"(
  space M 20 volatile little host_visible
  space T 1 retentive little host_visible
  place NOW i32 M[0]
  place DONE i32 M[4]
  place SLICE i8 M[8]
  place SLICES i8 M[9]
  place STORE bit M[10].0
  place FAST i8 M[11]
  place T0 i8 T[0]
  initial M 9 2
  host now () -> i32 routine_exchange
  host load_all () writes_retentive routine_exchange
  host store_all () reads_retentive
  routine init init {
    host load_all ()
  }
  routine fast schedule {
    %now = host now ()
    store NOW %now
    %one = const i8 1
    %f = load FAST
    %g = add.i8 %f %one
    store FAST %g
  }
  routine period schedule {
    call fast ()
    %one = const i8 1
    %j = load SLICE
    %next = add.i8 %j %one
    store SLICE %next
    %slices = load SLICES
    %end = eq.i8 %next %slices
    if %end {
      %zero = const i8 0
      store SLICE %zero
      %done = load DONE
      %wide = const i32 1
      %more = add.i32 %done %wide
      store DONE %more
    }
  }
  schedule init init
  schedule period period
  schedule fast_only fast
  schedule slow_done DONE
  schedule now now
  schedule retentive_load load_all
  schedule retentive_store store_all
)";

struct Stepping : testing::Test {
  Machine machine{kSliced};
  Clock clock{machine.program, {&machine.simulator}};
  std::vector<uint32_t> periods;

  void SetUp() override {
    clock.after_period = [this](uint32_t now) { periods.push_back(now); };
  }
};

TEST_F(Stepping, SlowCycles) {
  EXPECT_EQ(clock.RunSlow(2), Step::kDone);
  EXPECT_THAT(periods, ElementsAre(0, 10, 20, 30));
  EXPECT_EQ(clock.time_ms(), 40u);
  EXPECT_EQ(machine.Get("DONE"), 2u);
  EXPECT_EQ(machine.Get("NOW"), 30u);
}

TEST_F(Stepping, SlowStepEndsTheCycleThatIsHalfDone) {
  clock.RunMs(10);
  periods.clear();
  EXPECT_EQ(clock.RunSlow(1), Step::kDone);
  EXPECT_THAT(periods, ElementsAre(10));
}

TEST_F(Stepping, Milliseconds) {
  struct Row {
    uint64_t ms;
    std::vector<uint32_t> periods;
    uint64_t time_ms;
  };
  const Row kRows[] = {
      {0, {}, 0},  {1, {0}, 1},   {9, {}, 10},        {10, {10}, 20}, {5, {20}, 25},
      {5, {}, 30}, {1, {30}, 31}, {20, {40, 50}, 51}, {9, {}, 60},    {25, {60, 70, 80}, 85},
  };
  for (const Row& row : kRows) {
    periods.clear();
    clock.RunMs(row.ms);
    EXPECT_EQ(periods, row.periods) << row.time_ms;
    EXPECT_EQ(clock.time_ms(), row.time_ms);
  }
}

TEST_F(Stepping, FastPartAlone) {
  clock.RunMs(10);
  clock.RunFast(3);
  EXPECT_THAT(periods, ElementsAre(0, 10, 20, 30));
  EXPECT_EQ(clock.time_ms(), 40u);
  EXPECT_EQ(machine.Get("FAST"), 4u);
  EXPECT_EQ(machine.Get("SLICE"), 1u);  // as the period has left it
  EXPECT_EQ(machine.Get("DONE"), 0u);
  EXPECT_EQ(machine.Get("NOW"), 30u);
}

TEST_F(Stepping, BetweenTwoPeriodsTheNextOneIsFirst) {
  clock.RunMs(13);
  periods.clear();
  clock.RunSlow(1);
  EXPECT_THAT(periods, ElementsAre(20, 30));
  EXPECT_EQ(clock.time_ms(), 40u);
  clock.RunMs(3);
  periods.clear();
  clock.RunFast(1);
  EXPECT_THAT(periods, ElementsAre(50));
  EXPECT_EQ(clock.time_ms(), 60u);
}

TEST_F(Stepping, NothingIsNothing) {
  clock.RunMs(13);
  periods.clear();
  EXPECT_EQ(clock.RunSlow(0), Step::kDone);
  clock.RunFast(0);
  EXPECT_THAT(periods, IsEmpty());
  EXPECT_EQ(clock.time_ms(), 13u);
}

TEST_F(Stepping, ASlowPartThatNeverCompletesIsNoHang) {
  machine.Force("SLICES", 0);
  machine.Force("SLICE", 0);
  EXPECT_EQ(clock.RunSlow(1), Step::kStuck);
  EXPECT_EQ(periods.size(), machine.program.schedule.most_periods);
}

TEST_F(Stepping, CallbacksStandAroundThePeriod) {
  std::vector<uint64_t> seen;
  clock.before_period = [&](uint32_t now) { seen.insert(seen.end(), {now, clock.time_ms(), machine.Get("FAST")}); };
  clock.after_period = [&](uint32_t now) { seen.insert(seen.end(), {now, clock.time_ms(), machine.Get("FAST")}); };
  clock.RunMs(15);
  EXPECT_THAT(seen, ElementsAre(0, 0, 0, 0, 0, 1, 10, 10, 1, 10, 10, 2));
}

TEST_F(Stepping, PowerCycleStoresWhenRetentionIsOnAndTheProgramAsks) {
  machine.program.schedule.retain_at_power_off = ir::PlaceId(4);  // STORE
  const auto cycle = [&](uint64_t value, uint64_t store) {
    machine.Set("T0", value);
    machine.Set("STORE", store);
    clock.RunMs(25);
    clock.PowerCycle();
    EXPECT_EQ(clock.time_ms(), 0u);
    EXPECT_EQ(machine.Get("DONE"), 0u);
    EXPECT_EQ(machine.Get("SLICES"), 2u);
    return machine.Get("T0");
  };
  EXPECT_EQ(cycle(5, 1), 0u);  // retention is off
  machine.program.schedule.retention = true;
  EXPECT_EQ(cycle(6, 0), 0u);
  EXPECT_EQ(cycle(7, 1), 7u);
  EXPECT_EQ(cycle(8, 0), 7u);  // the last image that was stored
}

TEST_F(Stepping, AnInterruptedStepEndsBehindItsPeriod) {
  clock.interrupted = [this] { return periods.size() == 2; };
  EXPECT_EQ(clock.RunMs(100), Step::kInterrupted);
  EXPECT_EQ(clock.time_ms(), 20u);
  periods.clear();
  EXPECT_EQ(clock.RunSlow(3), Step::kInterrupted);
  periods.clear();
  EXPECT_EQ(clock.RunFast(5), Step::kInterrupted);
  EXPECT_THAT(periods, ElementsAre(40, 50));
}

/// Periods at the end of their time, 12 ms; ELAPSED holds the time of the last `elapse`, COUNT their number.
constexpr std::string_view kEnds = R"(
  space M 20 volatile little host_visible
  place DONE i32 M[0]
  place ELAPSED i32 M[4]
  place COUNT i8 M[8]
  host now () -> i32 routine_exchange
  routine period schedule {
    %done = load DONE
    %one = const i32 1
    %more = add.i32 %done %one
    store DONE %more
  }
  routine elapse schedule {
    %now = host now ()
    store ELAPSED %now
    %count = load COUNT
    %one = const i8 1
    %more = add.i8 %count %one
    store COUNT %more
  }
  schedule period period
  schedule fast_only period
  schedule elapse elapse
  schedule period_ms 12
  schedule period_ends_its_time 1
  schedule slow_done DONE
  schedule now now
)";

struct EndingPeriods : testing::Test {
  Machine machine{kEnds};
  Clock clock{machine.program, {&machine.simulator}};
  std::vector<uint32_t> periods;

  void SetUp() override {
    clock.after_period = [this](uint32_t now) { periods.push_back(now); };
  }
};

TEST_F(EndingPeriods, TheFirstOneIsAtTheEndOfItsTime) {
  EXPECT_EQ(clock.RunSlow(2), Step::kDone);
  EXPECT_EQ(clock.time_ms(), 24u);
  clock.RunFast(1);
  EXPECT_THAT(periods, ElementsAre(12, 24, 36));
  EXPECT_EQ(clock.time_ms(), 36u);
  EXPECT_EQ(machine.Get("COUNT"), 0u);
}

TEST_F(EndingPeriods, MillisecondsAndTheTimeThatIsLeft) {
  struct Row {
    uint64_t ms;
    std::vector<uint32_t> periods;
    uint64_t elapsed, count;
  };
  const Row kRows[] = {{0, {}, 0, 0},  {11, {}, 11, 1}, {1, {12}, 11, 1},      {12, {24}, 11, 1},
                       {1, {}, 25, 2}, {0, {}, 25, 2},  {25, {36, 48}, 50, 3}, {10, {60}, 50, 3}};
  for (const Row& row : kRows) {
    periods.clear();
    EXPECT_EQ(clock.RunMs(row.ms), Step::kDone);
    EXPECT_EQ(periods, row.periods) << clock.time_ms();
    EXPECT_EQ(machine.Get("ELAPSED"), row.elapsed) << clock.time_ms();
    EXPECT_EQ(machine.Get("COUNT"), row.count) << clock.time_ms();
  }
  EXPECT_EQ(clock.time_ms(), 60u);
}

TEST_F(EndingPeriods, FromTheMiddleTheNextPeriodIsTheNextMultiple) {
  clock.RunMs(17);
  EXPECT_EQ(clock.RunSlow(1), Step::kDone);
  clock.RunMs(1);
  clock.RunFast(1);
  EXPECT_THAT(periods, ElementsAre(12, 24, 36));
}

TEST_F(EndingPeriods, ElapseAtEveryMillisecondThatIsNoPeriods) {
  machine.program.schedule.elapses_every_ms = true;
  clock.RunSlow(1);
  EXPECT_EQ(machine.Get("COUNT"), 11u);
  clock.RunFast(1);
  EXPECT_EQ(machine.Get("COUNT"), 22u);
  clock.RunMs(14);
  EXPECT_EQ(machine.Get("COUNT"), 35u);
  EXPECT_EQ(machine.Get("ELAPSED"), 38u);
  EXPECT_THAT(periods, ElementsAre(12, 24, 36));
}

TEST_F(EndingPeriods, AfterAPowerCycleTimeBeginsAnew) {
  clock.RunMs(30);
  periods.clear();
  clock.PowerCycle();
  clock.RunMs(30);
  EXPECT_THAT(periods, ElementsAre(12, 24));
}

TEST(Clock, EnginesRunInLockstep) {
  Machine first(kSliced), second(kSliced);
  Clock clock(first.program, {&first.simulator, &second.simulator});
  clock.RunSlow(3);
  clock.RunFast(1);
  EXPECT_EQ(first.Get("NOW"), 60u);
  EXPECT_EQ(first.simulator.Snapshot(), second.simulator.Snapshot());
}

TEST(Clock, PartsWithPeriodsOfTheirOwn) {
  Machine machine(kSliced);
  machine.program.schedule.fast_ms = 2;  // `period` of this program counts as slow part of 10 ms, FAST counts both
  Clock clock(machine.program, {&machine.simulator});
  std::vector<uint32_t> times;
  clock.before_period = [&](uint32_t now_ms) { times.push_back(now_ms); };
  clock.RunFast(2);
  clock.RunSlow(1);
  EXPECT_THAT(times, ElementsAre(0, 0, 0));
  times.clear();
  clock.RunMs(7);
  EXPECT_THAT(times, ElementsAre(2, 4, 6));
  times.clear();
  clock.RunMs(4);
  EXPECT_THAT(times, ElementsAre(8, 10, 10));
  EXPECT_EQ(clock.time_ms(), 11u);
  clock.RunMs(100);
  EXPECT_EQ(machine.Get("FAST"), 3u + 55 + 11);
}

TEST(Clock, WithoutACountEveryPeriodIsASlowCycle) {
  Machine machine(kSliced);
  machine.program.schedule.slow_done = {};
  Clock clock(machine.program, {&machine.simulator});
  EXPECT_EQ(clock.RunSlow(3), Step::kDone);
  EXPECT_EQ(clock.time_ms(), 30u);
}

}  // namespace
}  // namespace plcxx::sim
