// plcxx diff: what is shown of a difference: its run, its names, its calls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A counterexample that begins at power-on and was run on both versions.
void ExpectShown(const Diff& diff, const std::string& name) {
  const DiffItem* const item = ItemNamed(diff, name);
  ASSERT_NE(item, nullptr) << NamesIn(diff);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << item->reason;
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator) << item->counterexample->scenario;
  EXPECT_FALSE(item->counterexample->from_state);
}

TEST(DiffExamples, AWaitInAMechanismThatIsAPassLonger) {
  const std::string motor = R"(        DATA
IN0: DFM KUS
OUT0: DFM CHOD
        DATA_END
        MODULE_MAIN
        LDR KUS
        FL1 1,MOTOR
        MECH_BEGIN MOTOR
        FL 1,CHOD
        TIM -,@
        FL 0,CHOD
        MECH_END MOTOR
        MODULE_MAIN_END
        STOP
)";
  ExpectShown(ComparedTexts(kTechnol, With(motor, "300"), With(motor, "301")), "CHOD");
  ExpectShown(ComparedTexts(kTechnol, With(motor, "3000"), With(motor, "3001")), "CHOD");
}

TEST(DiffExamples, TimersOfMinutes) {
  const std::string timer = "SLOW\nNETWORK\nLD %I0\n@\nOUT %Q0\nEND_SLOW\n";
  const DiffOptions unhurried = {.time_ms = 60'000};  // also on a machine that has other work
  ExpectShown(ComparedTexts(kHost50, With(timer, "TONM %TM1, 10"), With(timer, "TONM %TM1, 11"), unhurried), "Q0");
  // No constant changed, and only a wait behind the preset shows it.
  const std::string iec = "OPTION TP=IEC\n" + timer;
  ExpectShown(ComparedTexts(kHost50, With(iec, "TOFM %TM1, 3"), With(iec, "TPM %TM1, 3"), unhurried), "Q0");
}

TEST(DiffExamples, OnlyWhatMattersIsSet) {
  // The other inputs stand in the program, and are not needed for the difference.
  std::string others;
  for (int i = 5; i < 30; ++i) {
    others += "U4A" + std::to_string(i) + "=I1A" + std::to_string(i) + "*/I2A" + std::to_string(i) + "\n";
  }
  const Diff diff = ComparedTexts(kNc110, "$\n" + others + "U20K0=I0A3*I0A4+U20K0*/I0A5\nU4A3=U20K0*I0A6\n",
                                  "$\n" + others + "U20K0=I0A3*I0A4+U20K0*/I0A5\nU4A3=U20K0\n");
  const DiffItem* const item = ItemNamed(diff, "U4A3");
  ASSERT_NE(item, nullptr);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->steps, "I0A3=1, I0A4=1, slow 1");
}

TEST(DiffExamples, ACountBehindConditions) {
  // Each pulse needs a key that comes and goes while a fault stands, and an acknowledgement between two of them.
  const std::string counted = "$\nU100K0=(U100K0+I0A0*/I0A1)*/I0A2\nC20I(@)=U100K0\nU4A0=(U4A0+C20R)*/I0A3\n";
  const Diff diff = ComparedTexts(kNc110, With(counted, "200"), With(counted, "210"));
  ExpectShown(diff, "U4A0");
  const DiffItem* const item = ItemNamed(diff, "U4A0");
  EXPECT_THAT(item->counterexample->steps, HasSubstr(" times ("));
  EXPECT_THAT(item->counterexample->scenario, HasSubstr("- repeat:\n    times: 19"));
}

TEST(DiffExamples, CallsAreExpected) {
  // A counter whose modulus is out of range is a fault that the control is told.
  const std::string counter = "$\nW100K0=@\nC20I(W100K0)=I0A0\n";
  const Diff diff = ComparedTexts(kNc110, With(counter, "5"), With(counter, "0"));
  const DiffItem* const item = ItemNamed(diff, "calls of fault");
  ASSERT_NE(item, nullptr) << NamesIn(diff);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_THAT(item->counterexample->scenario, HasSubstr("- expect_calls: []"));
  EXPECT_EQ(item->counterexample->old_value, "no call");
  EXPECT_THAT(item->counterexample->new_value, HasSubstr("fault(kind: PARAM_RANGE, index: 20"));
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator) << item->counterexample->scenario;
}

TEST(DiffExamples, NamesOfTheSourceComeFirst) {
  const std::string program = R"(        DATA
IN0: DFM KUS
OUT0: DFM PAS
N: DS 1
        DATA_END
        MODULE_MAIN
        LDR @KUS
        WR PAS
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, ""), With(program, "-"));
  const DiffItem* const item = ItemNamed(diff, "PAS");
  ASSERT_NE(item, nullptr) << NamesIn(diff);
  EXPECT_EQ(item->meaning, "OUT+0.0");
}

TEST(DiffExamples, WhatIsHiddenInATimerBelongsToIt) {
  const Diff diff = ComparedTexts(kNc110, "$\nT0I(10)=I0A3\nU4A8=T0U\n", "$\nT0I(20)=I0A3*I0A4\nU4A8=T0U\n");
  EXPECT_THAT(NamesIn(diff), Not(HasSubstr("last_ms")));
  EXPECT_NE(ItemNamed(diff, "U4A8"), nullptr);
}

TEST(DiffExamples, TheTimeIsKept) {
  // A row of counters, each counted by the one before it: nothing decides what the last one does in so short a time.
  std::string row = "$\n";
  for (int i = 1; i < 60; ++i) {
    row += "C" + std::to_string(i) + "I(250)=" + (i == 1 ? std::string("I0A3") : "C" + std::to_string(i - 1) + "R") +
           "*/U20K" + std::to_string(i % 30) + "\n";
  }
  const auto begin = std::chrono::steady_clock::now();
  ComparedTexts(kNc110, row + "U4A8=C59R\n", row + "U4A8=C59R*/I0A4\n", {.time_ms = 3000});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(6));
}

}  // namespace
}  // namespace plcxx::review::diff
