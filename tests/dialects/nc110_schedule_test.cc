#include "tests/dialects/nc110_lowered.h"

namespace plcxx::nc110 {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// covers: NC110-057 NC110-208 NC110-211 NC110-212
TEST(Nc110Schedule, OnePeriodWithOneSlice) {
  LoweredProgram lowered;
  LowerInto(lowered, {"T5I(3)=I0A1"});
  EXPECT_THAT(lowered.Routine("period"),
              ElementsAre("%0 = host now_ms ()", "store now %0", "host read_inputs ()", "call fast ()",
                          "%1 = const i8 0", "call slow (%1)", "host write_outputs ()", "%2 = load U10N4",
                          "%3 = load u10n4_was", "%4 = not.bit %3", "%5 = and.bit %2 %4", "store u10n4_was %2",
                          "if %5 {", "host retentive_store ()", "}", "}"));
  EXPECT_THAT(lowered.Routine("fast_only"), ElementsAre("%0 = host now_ms ()", "store now %0", "host read_inputs ()",
                                                        "call fast ()", "host write_outputs ()", "}"));
  const ir::Schedule& schedule = lowered.program().schedule;
  EXPECT_EQ(schedule.period_ms, 10u);
  EXPECT_EQ(schedule.slot_ms, 2u);
  EXPECT_FALSE(schedule.retention);
  EXPECT_FALSE(schedule.retain_at_power_off.valid());
}

TEST(Nc110Schedule, WithoutTimersTheTimeIsNotAskedFor) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A1"});
  EXPECT_THAT(lowered.Routine("period"), Not(Contains(HasSubstr("now"))));
}

// covers: NC110-056 NC110-057
TEST(Nc110Schedule, RetentionLoadsAndStoresPackageT) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A1"}, {{"old", "on"}});
  EXPECT_THAT(lowered.Routine("init"), ElementsAre("host retentive_load ()", "}"));
  EXPECT_THAT(lowered.Routine("period"), Contains("store u10k0_was %5"));
  const ir::Schedule& schedule = lowered.program().schedule;
  EXPECT_TRUE(schedule.retention);
  ASSERT_TRUE(schedule.retain_at_power_off.valid());
  EXPECT_EQ(lowered.program().places[schedule.retain_at_power_off].name, "U10K0");
}

// covers: NC110-209 NC110-252
TEST(Nc110Schedule, SlicesAreCountedWithoutKnowingTheirNumber) {
  for (const std::string slices : {"3", "auto"}) {
    LoweredProgram lowered;
    LowerInto(lowered, {"P1=I0A1 $\nU4A0=P1"}, {{"slices", slices}, {"clo", "20,4"}});
    EXPECT_EQ(lowered.program().schedule.slices_by_cost, slices == "auto");
    EXPECT_EQ(lowered.program().schedule.period_ms, 20u);
    EXPECT_EQ(lowered.program().schedule.slot_ms, 4u);
    EXPECT_THAT(lowered.Routine("fast"), Contains("%2 = load slow_open"));
    EXPECT_THAT(lowered.Routine("slow"), Contains("store slow_open %0"));
    EXPECT_THAT(
        lowered.Routine("period"),
        ElementsAre("host read_inputs ()", "call fast ()", "%0 = load next_slice", "call slow (%0)", "%1 = const i8 0",
                    "%2 = load slow_open", "%3 = eq.i8 %2 %1", "if %3 {", "%4 = const i8 0", "store next_slice %4",
                    "} else {", "%5 = load next_slice", "%6 = const i8 1", "%7 = add.i8 %5 %6", "store next_slice %7",
                    "}", "host write_outputs ()", "%8 = load U10N4", "%9 = load u10n4_was", "%10 = not.bit %9",
                    "%11 = and.bit %8 %10", "store u10n4_was %8", "if %11 {", "host retentive_store ()", "}", "}"));
  }
}

// covers: NC110-213
TEST(Nc110Schedule, LatchedInputsAreCopiedBeforeTheFirstSlice) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A1 $\nU4A1=I0A1*I30K0*I3K5 U9K17=0 U4A2=I9K17"},
            {{"slices", "2"}, {"latch-slow-inputs", "on"}});
  const auto slow = lowered.Routine("slow");
  EXPECT_THAT(slow, Contains("store I0A1_latched %1"));
  EXPECT_THAT(slow, Contains("%0 = load I0A1_latched"));
  EXPECT_THAT(slow, Contains("%1 = load I30K0"));  // free memory is no input
  EXPECT_THAT(slow, Contains("store U9K17 %0"));
  EXPECT_THAT(slow, Contains("store U9K17_latched %1"));  // what is there now: a force keeps its value
  EXPECT_THAT(lowered.Routine("fast"), Contains("%0 = load I0A1"));

  // A timer that has an input's number is none.
  LoweredProgram timed;
  LowerInto(timed, {"$\nT0I(1)=I0A0 U4A2=T0D"}, {{"slices", "2"}, {"latch-slow-inputs", "on"}});
  EXPECT_THAT(timed.Routine("slow"), Contains(HasSubstr("load I0A0_latched")));
  EXPECT_THAT(timed.Routine("slow"), Contains(HasSubstr("load T0D")));
  EXPECT_THAT(timed.Routine("slow"), Not(Contains(HasSubstr("T0D_latched"))));

  LoweredProgram one_slice;
  LowerInto(one_slice, {"$\nU4A1=I0A1"}, {{"latch-slow-inputs", "on"}});
  EXPECT_THAT(one_slice.Routine("slow"), Contains("%0 = load I0A1"));
}

// covers: NC110-222
TEST(Nc110Schedule, MessagesAreBitsAndOneNumber) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=1"});
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("message_bits K 84 first 1 count 64\n"));
  EXPECT_THAT(text, HasSubstr("message_word W17K3\n"));
}

// covers: NC110-061
TEST(Nc110Schedule, ZonesFollowTheProcesses) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=1"}, {{"processes", "2"}});
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("zone K 104 144 input\nzone K 144 208 output\n"));
}

}  // namespace
}  // namespace plcxx::nc110
