#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/live/live_fixture.h"
#include "transpiler/live/pace.h"
#include "transpiler/live/why.h"

namespace plcxx::live {
namespace {

using testing::HasSubstr;

TEST(Timeline, BackInTimeIsTheSameMachineAgain) {
  LiveBench bench;
  std::vector<std::vector<uint8_t>> states;
  sim::Engine* engine = &bench.session->timeline().machine().simulator();
  // Inputs change now and then, also at the border of a checkpoint.
  for (int period = 0; period < 700; ++period) {
    if (period % 83 == 0 || period == 250 || period == 499) Toggle(*bench.session, "I0A3");
    if (period % 101 == 7) Toggle(*bench.session, "I0A4");
    if (period == 300) Force(*bench.session, "U4A9", "1");
    if (period == 420) Release(*bench.session, "U4A9");
    states.push_back(engine->Snapshot());
    bench.Periods(1);
  }
  for (const uint64_t period : {699, 500, 499, 421, 420, 419, 301, 251, 250, 249, 1, 0}) {
    EXPECT_EQ(bench.session->GoTo(period), "");
    EXPECT_EQ(engine->Snapshot(), states[period]) << period;
  }
  // Forward again along what was recorded.
  for (uint64_t period = 0; period < 699; ++period) {
    ASSERT_EQ(engine->Snapshot(), states[period]) << period;
    bench.Periods(1);
  }
}

TEST(Timeline, SomethingElseForgetsWhatWasAhead) {
  LiveBench bench;
  bench.Periods(5);
  Set(*bench.session, "I0A3", "1");
  bench.Periods(5);
  EXPECT_EQ(bench.Value("U4A8"), 1u);
  EXPECT_EQ(bench.session->Back(7), "");
  EXPECT_EQ(bench.session->timeline().end(), 10u);
  Set(*bench.session, "I0A5", "1");
  EXPECT_EQ(bench.session->timeline().end(), 3u);
  bench.Periods(10);
  EXPECT_EQ(bench.Value("U4A8"), 0u);
}

TEST(Timeline, TenThousandPeriodsAreKeptAndNoMore) {
  LiveBench bench;
  for (int i = 0; i < 10'600; ++i) bench.session->RunRecorded({.kind = AdvanceKind::kMs, .ms = 10});
  const Timeline& timeline = bench.session->timeline();
  EXPECT_LE(timeline.first(), timeline.period() - kMostBack);
  EXPECT_GT(timeline.first() + kMostBack + 500, timeline.period());
  EXPECT_EQ(bench.session->Back(kMostBack), "");
  EXPECT_EQ(bench.Value("W3K0"), 600u % 256);
  EXPECT_THAT(bench.session->GoTo(0), HasSubstr("known are the periods"));
}

TEST(Timeline, StatementsOneByOneAndBack) {
  LiveBench bench;
  Set(*bench.session, "I0A3", "1");
  Timeline& timeline = bench.session->timeline();
  EXPECT_EQ(bench.session->Step(StepKind::kStatement), "");
  EXPECT_EQ(timeline.at(), bench.Statement("W3K0"));
  EXPECT_EQ(bench.Value("W3K0"), 0u);
  EXPECT_EQ(bench.session->Step(StepKind::kStatement), "");
  EXPECT_EQ(timeline.at(), bench.Statement("U4A8"));
  EXPECT_EQ(bench.Value("W3K0"), 1u);
  EXPECT_EQ(bench.Value("U4A8"), 0u);
  EXPECT_EQ(bench.session->Step(StepKind::kStatement), "");
  EXPECT_EQ(bench.Value("U4A8"), 1u);
  EXPECT_EQ(bench.session->BackStatement(), "");
  EXPECT_EQ(timeline.at(), bench.Statement("U4A8"));
  EXPECT_EQ(bench.Value("U4A8"), 0u);
  // The rest of the period, once.
  bench.Periods(1);
  EXPECT_TRUE(timeline.is_between());
  EXPECT_EQ(timeline.period(), 1u);
  EXPECT_EQ(bench.Value("W3K0"), 1u);
  EXPECT_EQ(bench.Value("U4A9"), 1u);
  // From between two periods to the last statement of the one before.
  EXPECT_EQ(bench.session->BackStatement(), "");
  EXPECT_EQ(timeline.at(), bench.Statement("W2K2"));
  EXPECT_EQ(bench.Value("U4A9"), 1u);
}

TEST(Timeline, AnInputWithinAPeriodCountsForTheNextOne) {
  LiveBench bench;
  bench.session->Step(StepKind::kStatement);
  Set(*bench.session, "I0A3", "1");
  EXPECT_TRUE(bench.session->timeline().is_between());
  EXPECT_EQ(bench.session->timeline().period(), 1u);
  EXPECT_EQ(bench.Value("U4A8"), 0u);
  bench.Periods(1);
  EXPECT_EQ(bench.Value("U4A8"), 1u);
}

TEST(Session, StopsAtAStatementBeforeItIsExecuted) {
  LiveBench bench;
  EXPECT_EQ(bench.session->breakpoints().AtStatement(bench.Statement("U4A9"), true), "");
  Set(*bench.session, "I0A3", "1");
  EXPECT_EQ(bench.session->Run(), "");
  bench.session->RunPeriods(100);
  EXPECT_FALSE(bench.session->is_running());
  EXPECT_EQ(bench.session->timeline().at(), bench.Statement("U4A9"));
  EXPECT_EQ(bench.Value("U4A8"), 1u);
  EXPECT_EQ(bench.Value("U4A9"), 0u);
  // On: the same one in the next period.
  bench.session->Run();
  bench.session->RunPeriods(100);
  EXPECT_EQ(bench.session->timeline().period(), 1u);
  EXPECT_EQ(bench.session->timeline().at(), bench.Statement("U4A9"));
  EXPECT_EQ(bench.Value("W3K0"), 2u);
  EXPECT_EQ(bench.session->breakpoints().AtStatement(bench.Statement("U4A9"), false), "");
  bench.session->Run();
  EXPECT_EQ(bench.session->RunPeriods(100), 100u);
}

TEST(Session, StopsAtAChangeAndAtACondition) {
  LiveBench bench;
  EXPECT_EQ(BreakAtChange(*bench.session, "U4A8"), "");
  EXPECT_EQ(BreakAtCondition(*bench.session, "U4A8 for 50 ms"), "");
  bench.session->Run();
  EXPECT_EQ(bench.session->RunPeriods(20), 20u);
  Set(*bench.session, "I0A3", "1");
  EXPECT_EQ(bench.session->RunPeriods(20), 1u);
  EXPECT_EQ(bench.session->why_stopped(), "U4A8 has changed");
  bench.session->Run();
  EXPECT_EQ(bench.session->RunPeriods(20), 4u);
  EXPECT_THAT(bench.session->why_stopped(), HasSubstr("U4A8 for 50 ms"));
  bench.session->Run();
  EXPECT_EQ(bench.session->RunPeriods(20), 20u) << "it holds on, and does not come again";
  EXPECT_THAT(BreakAtCondition(*bench.session, "U4A8 and"), HasSubstr("expected"));
  EXPECT_THAT(BreakAtCondition(*bench.session, "NOSUCH"), HasSubstr("NOSUCH"));
  EXPECT_THAT(BreakAtCondition(*bench.session, "U4A8\nnever U4A9"), HasSubstr("one line"));
  EXPECT_EQ(BreakAtCondition(*bench.session, "never U4A9 and I0A5"), "");
  EXPECT_EQ(bench.session->breakpoints().Remove(2), "");
  EXPECT_EQ(bench.session->breakpoints().all().size(), 2u);
}

TEST(Session, ForcedAgainstEveryWriterUntilReleased) {
  LiveBench bench;
  EXPECT_EQ(Force(*bench.session, "U4A8", "1"), "");
  Set(*bench.session, "I0A4", "1");
  bench.Periods(3);
  EXPECT_EQ(bench.Value("U4A8"), 1u);
  ASSERT_EQ(bench.session->forced().size(), 1u);
  EXPECT_EQ(Toggle(*bench.session, "U4A8"), "");
  bench.Periods(1);
  EXPECT_EQ(bench.Value("U4A8"), 0u);
  EXPECT_EQ(Force(*bench.session, "W2K2", "12H"), "");
  EXPECT_EQ(bench.session->forced().size(), 2u);
  EXPECT_EQ(ReleaseAll(*bench.session), "");
  EXPECT_TRUE(bench.session->forced().empty());
  bench.Periods(1);
  EXPECT_EQ(bench.Value("W2K2"), bench.Value("W3K0"));
  EXPECT_THAT(Release(*bench.session, "U4A8"), HasSubstr("not forced"));
  EXPECT_EQ(bench.session->Back(2), "");
  EXPECT_EQ(bench.session->forced().size(), 1u) << "forced in the past";
}

TEST(Session, StatementsOffAndOn) {
  LiveBench bench;
  EXPECT_EQ(SwitchStatement(*bench.session, bench.Statement("U4A8"), false), "");
  Set(*bench.session, "I0A3", "1");
  bench.Periods(3);
  EXPECT_EQ(bench.Value("U4A8"), 0u);
  EXPECT_EQ(SwitchAllOn(*bench.session), "");
  bench.Periods(1);
  EXPECT_EQ(bench.Value("U4A8"), 1u);
  EXPECT_EQ(bench.session->Back(2), "");
  EXPECT_TRUE(bench.session->timeline().machine().IsOff(bench.Statement("U4A8")));
}

TEST(Session, WhatIsWrongIsSaid) {
  LiveBench bench;
  EXPECT_THAT(Set(*bench.session, "U4A", "1"), HasSubstr("no location of nc110"));
  EXPECT_THAT(Set(*bench.session, "I0A3", "2"), HasSubstr("value 2 does not fit: 'I0A3' takes 0 to 1"));
  EXPECT_THAT(Toggle(*bench.session, "W2K2"), HasSubstr("only a bit"));
  EXPECT_THAT(SwitchStatement(*bench.session, ir::StatementId(999), false), HasSubstr("no such statement"));
  EXPECT_THAT(bench.session->Step(StepKind::kFast), HasSubstr("no such part"));
  EXPECT_THAT(bench.session->Back(1), HasSubstr("nothing is known"));
  EXPECT_THAT(bench.session->SetSpeed(-1), HasSubstr("a speed is"));
  EXPECT_EQ(bench.session->PowerOff(), "");
  EXPECT_THAT(bench.session->Run(), HasSubstr("off"));
  EXPECT_THAT(bench.session->Step(StepKind::kPeriod), HasSubstr("off"));
  EXPECT_EQ(bench.session->PowerOn(), "");
  EXPECT_EQ(bench.session->timeline().machine().time_ms(), 0u);
}

TEST(Session, WhyFollowsBackToTheInputThatWasSet) {
  LiveBench bench;
  bench.Periods(300);
  Set(*bench.session, "I0A3", "1");
  bench.Periods(2);
  Set(*bench.session, "I0A3", "0");
  bench.Periods(3);
  const Reasons reasons = WhyNow(*bench.session, "U4A9");
  ASSERT_EQ(reasons.refusal, "");
  EXPECT_THAT(reasons.text, HasSubstr("U4A9 is 1"));
  EXPECT_THAT(reasons.text, HasSubstr("U4A8"));
  EXPECT_THAT(reasons.text, HasSubstr("I0A4"));
  EXPECT_NE(WhyNow(*bench.session, "NOSUCH").refusal, "");
}

TEST(Session, AStepOfTheSlowPart) {
  LiveBench bench;
  ASSERT_TRUE(bench.session->CanStep(StepKind::kSlow));
  const uint64_t before = bench.session->timeline().period();
  EXPECT_EQ(bench.session->Step(StepKind::kSlow), "");
  EXPECT_GT(bench.session->timeline().period(), before);
}

TEST(Pace, RealTimeSlowerFasterAndABreak) {
  Pace pace;
  pace.Begin(1'000'000, 10, 1);
  EXPECT_EQ(pace.Due(1'009'999), 0u);
  EXPECT_EQ(pace.Due(1'010'001), 1u);
  EXPECT_EQ(pace.Due(1'100'001), 9u);
  EXPECT_GT(pace.UsUntilNext(1'100'001), 9'000u);
  EXPECT_EQ(pace.Due(61'000'000), 25u) << "what is owed for a minute is not run at once";
  EXPECT_LE(pace.Due(61'010'001), 1u);
  pace.Begin(0, 10, 0.1);
  EXPECT_EQ(pace.Due(99'000), 0u);
  EXPECT_EQ(pace.Due(101'000), 1u);
  pace.Begin(0, 10, 100);
  EXPECT_EQ(pace.Due(10'001), 100u);
  pace.Begin(0, 10, 0);
  EXPECT_GT(pace.Due(0), 1u);
  EXPECT_EQ(pace.UsUntilNext(0), 0u);
}

}  // namespace
}  // namespace plcxx::live
