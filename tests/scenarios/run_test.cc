// Running scenarios: every step, and the exact words of a failure.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/scenarios/scenario_fixture.h"

namespace plcxx::scenarios {
namespace {

using testing::HasSubstr;

TEST(ScenarioRun, SetRunExpect) {
  EXPECT_EQ(ScenarioBench().Run("- set: {I0: 1, W2: 0x1234}\n"
                                "- expect: {Q0: 0, W2: 4660}\n"
                                "- run: {slow: 1}\n"
                                "- expect: {Q0: on, W2: 1234H}\n"
                                "- set: {I0: off}\n"
                                "- run: {ms: 10}\n"
                                "- expect: {Q0: false, T9U: 0}\n"),
            "passed");
}

TEST(ScenarioRun, StepsOfARunGoInTheOrderWritten) {
  EXPECT_EQ(ScenarioBench().Run("- run: {fast: 3, slow: 2}\n- expect: {FAST: 5, DONE: 2}\n"
                                "- run: {s: 0.1, ms: 25}\n- expect: {FAST: 18, DONE: 15}\n"),
            "passed");
}

TEST(ScenarioRun, AFailureTellsStepTimeValuesAndWriters) {
  EXPECT_EQ(ScenarioBench().Run("- run: {slow: 2}\n- set: {I0: 1}\n- run: {slow: 2}\n- expect: {W1: 0, Q0: 0}\n"),
            "s.yaml:5:19: step 4 (expect), at 40 ms: expected Q0 = 0, found 1\n"
            "  last writes to Q0, newest first:\n"
            "    value 1 from 20 ms to 30 ms: machine.plc:2:1: Q0=I0\n"
            "    value 0 from 0 ms to 10 ms: machine.plc:2:1: Q0=I0");
}

TEST(ScenarioRun, AllWrongValuesOfAStepAreTold) {
  EXPECT_EQ(ScenarioBench().Run("- set: {W2: 18}\n- expect: {W2: 19, W1: 5, T9U: 1}\n"),
            "s.yaml:3:12: step 2 (expect), at 0 ms: expected W2 = 19 (0x13), found 18 (0x12)\n"
            "  last writes to W2, newest first:\n"
            "    value 18 at 0 ms: the scenario or the control\n"
            "s.yaml:3:20: step 2 (expect), at 0 ms: expected W1 = 5 (0x05), found 0 (0x00)\n"
            "  nothing has written W1 since power-on\n"
            "s.yaml:3:27: step 2 (expect), at 0 ms: expected T9U = 1, found 0: the program does not use it");
}

TEST(ScenarioRun, ForceHoldsUntilRelease) {
  EXPECT_EQ(ScenarioBench().Run("- set: {I0: 1}\n- force: {Q0: 0}\n- run: {slow: 1}\n- expect: {Q0: 0}\n"
                                "- power_cycle: {}\n- set: {I0: 1}\n- run: {slow: 1}\n- expect: {Q0: 0}\n"
                                "- release: Q0\n- run: {slow: 1}\n- expect: {Q0: 1}\n"),
            "passed");
}

TEST(ScenarioRun, PowerCycleKeepsWhatTheHostStored) {
  EXPECT_EQ(ScenarioBench().Run(
                "- set: {T0: 7, W1: 1}\n- power_cycle: {}\n- expect: {T0: 0, W1: 0}\n"
                "- set: {T0: 7, KEEP: 1}\n- run: {slow: 3}\n- power_cycle: {}\n- expect: {T0: 7, KEEP: 0, DONE: 0}\n"
                "- set: {T0: 9}\n- power_cycle: {}\n- expect: {T0: 7}\n"),
            "passed");
  const std::string without = Replaced(kScenarioProgram, "schedule retention 1", "");
  EXPECT_EQ(ScenarioBench(without).Run("- set: {T0: 7, KEEP: 1}\n- power_cycle: {}\n- expect: {T0: 0}\n"), "passed");
}

TEST(ScenarioRun, HostCalls) {
  EXPECT_EQ(ScenarioBench().Run(
                "- expect_calls: []\n- set: {W1: 3}\n- run: {slow: 2}\n"
                "- expect_calls: [{fault: {kind: LOOP_LIMIT, index: 20}}, fault]\n- set: {W1: 0}\n- run: {slow: 1}\n"
                "- expect_calls: []\n"),
            "passed");
  EXPECT_EQ(ScenarioBench().Run("- set: {W1: 3}\n- run: {slow: 1}\n- expect_calls: [{fault: {index: 21}}]\n"),
            "s.yaml:4:3: step 3 (expect_calls), at 10 ms: expected host calls fault(index: 21), "
            "found fault(kind: LOOP_LIMIT, index: 20)");
  // A function that must not be called, also one that the program does not know.
  EXPECT_EQ(ScenarioBench().Run("- run: {slow: 1}\n- expect_calls: [{fault: none}, {axis_home: none}]\n"), "passed");
  EXPECT_EQ(ScenarioBench().Run("- set: {W1: 3}\n- run: {slow: 1}\n- expect_calls: [{fault: none}]\n"),
            "s.yaml:4:3: step 3 (expect_calls), at 10 ms: expected host calls no fault, "
            "found fault(kind: LOOP_LIMIT, index: 20)");
  EXPECT_EQ(
      ScenarioBench().Run("- expect_calls: [{axis_home: {axis: 1}}]\n"),
      "s.yaml:2:3: step 1 (expect_calls), at 0 ms: expected host calls axis_home(axis: 1), found none\n"
      "  the program never calls 'axis_home', so the list cannot match; it may call: now, load_all, store_all, fault");
  EXPECT_THAT(ScenarioBench().Run("- run: {slow: 1}\n- expect_calls: [now]\n"),
              HasSubstr("'now' is part of the routine exchange"));
}

TEST(ScenarioRun, Messages) {
  EXPECT_EQ(ScenarioBench().Run("- set: {MESSAGES: 5}\n- run: {slow: 1}\n- set: {MESSAGES: 2}\n- run: {slow: 1}\n"
                                "- expect_messages: [1, 3, 2]\n- run: {slow: 1}\n- expect_messages: []\n"),
            "passed");
  EXPECT_EQ(ScenarioBench().Run("- set: {MESSAGES: 5}\n- run: {slow: 1}\n- expect_messages: [1]\n"),
            "s.yaml:4:3: step 3 (expect_messages), at 10 ms: expected messages [1], found [1, 3]");
}

TEST(ScenarioRun, WhatIsWrongIsToldBeforeAnythingRuns) {
  EXPECT_EQ(
      ScenarioBench().Run("- expect: {Q0: 1}\n- set: {Q7: 1, W1: 256, W2: -1, I0: maybe}\n"
                          "- expect: {OPERATOR_TEXT: A}\n- force: {I0: -1}\n"),
      "s.yaml:3:9: 'Q7' is no location of dialect test; 'plcxx report --print-symbols' lists those of the program\n"
      "s.yaml:3:20: value 256 does not fit: 'W1' takes 0 to 255\n"
      "s.yaml:3:37: 'maybe' is no value: 'I0' takes 0 to 1\n"
      "s.yaml:4:12: 'OPERATOR_TEXT' can only be set: it sends a text\n"
      "s.yaml:5:15: value -1 does not fit: 'I0' takes 0 to 1");
  EXPECT_EQ(ScenarioBench().Run("- expect_calls: [{fault: {kind: SMALL, number: 2}}]\n"),
            "s.yaml:2:33: 'SMALL' is no value of 'kind'; there are: PARAM_RANGE, LOOP_LIMIT\n"
            "s.yaml:2:40: 'number' is no parameter of 'fault'; there are: kind, index");
}

TEST(ScenarioRun, WhatTheProgramDoesNotUseKeepsWhatIsWritten) {
  EXPECT_EQ(ScenarioBench().Run(
                "- set: {T9U: 1}\n- run: {slow: 1}\n- expect: {T9U: 1}\n- force: {T9U: 0}\n- set: {T9U: 1}\n"
                "- expect: {T9U: 0}\n- release: [T9U]\n- set: {T9U: 1}\n- power_cycle: {}\n- expect: {T9U: 0}\n"),
            "passed");
}

TEST(ScenarioRun, EnginesThatPartAreTold) {
  ScenarioBench bench;
  bench.other = ir::ReadOrDie(Replaced(kScenarioProgram, "store Q0 %i", "%n = not.bit %i\n store Q0 %n"));
  EXPECT_EQ(bench.Run("- set: {I0: 1}\n- run: {slow: 5}\n- expect: {Q0: 0}\n"),
            "s.yaml:3:3: step 2 (run), at 0 ms: simulator and compiled differ in Q0 (simulator: 1; compiled: 0)\n"
            "  last writes to Q0, newest first:\n"
            "    value 1 at 0 ms: machine.plc:2:1: Q0=I0");
  bench.other = ir::ReadOrDie(Replaced(kScenarioProgram, "const i32 20", "const i32 21"));
  EXPECT_EQ(bench.Run("- run: {slow: 1}\n- set: {W1: 3}\n- run: {slow: 5}\n"),
            "s.yaml:4:3: step 3 (run), at 10 ms: simulator and compiled differ in the host calls (simulator: "
            "fault(kind: LOOP_LIMIT, "
            "index: 20); compiled: fault(kind: LOOP_LIMIT, index: 21))");
  bench.other = ir::ReadOrDie(kScenarioProgram);
  EXPECT_EQ(bench.Run("- set: {I0: 1}\n- run: {s: 1}\n- expect: {Q0: 1}\n"), "passed");
}

TEST(ScenarioRun, TheWaveformHoldsWhatTheScenarioNames) {
  ScenarioBench bench;
  sim::Trace trace({sim::Watch(bench.program, "Q0", bench.program.places[ir::PlaceId(1)])});
  EXPECT_EQ(bench.Run("- set: {I0: 1}\n- run: {slow: 2}\n- power_cycle: {}\n- run: {slow: 1}\n", &trace), "passed");
  using testing::ElementsAre;
  EXPECT_THAT(trace.samples(), ElementsAre(sim::Sample{0, {1}}, sim::Sample{10, {1}}, sim::Sample{20, {0}}));
}

/// Answers I0 = 1 before each period, and counts the slow cycles in W1.
class Answering : public dialects::ControlStub {
 public:
  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<Answering>(*this); }
  void PowerOn(dialects::ImagePort&) override {}
  void BeforePeriod(uint32_t, dialects::ImagePort& image) override { image.Set(ir::SpaceId(0), 0, 0x03); }
  void AfterPeriod(uint32_t, uint32_t slow_cycles, dialects::ImagePort& image) override {
    image.Set(ir::SpaceId(0), 4, static_cast<uint8_t>(slow_cycles));
    if (slow_cycles == 2) image.StoreRetentive();
  }
};

TEST(ScenarioRun, WhatTheScenarioSetsWinsOverTheSimulatedControl) {
  ScenarioBench bench;
  bench.stub = std::make_unique<Answering>();
  EXPECT_EQ(bench.Run("- set: {T0: 4}\n- run: {slow: 2}\n- expect: {Q0: 1, W2: 2}\n"
                      "- set: {I0: 0}\n- run: {slow: 1}\n- expect: {Q0: 0, W2: 3}\n"
                      "- power_cycle: {}\n- expect: {T0: 4}\n- run: {slow: 1}\n- expect: {Q0: 1}\n"),
            "passed");
}

}  // namespace
}  // namespace plcxx::scenarios
