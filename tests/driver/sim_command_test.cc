// plcxx sim: time, watching, forcing, graphs, lines switched off, budgets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kSimulatedProgram =
    "U4A0=I0A0\n"
    "U4A1=I0A0*/U4A3\n"
    "W100K0=[W100K0+1]\n"
    "$\n"
    "U4A2=I0A1\n";

class Sim : public ::testing::Test {
 protected:
  Sim() { work_.Write("main.plc", kSimulatedProgram); }
  Ran Run(const std::string& arguments) { return work_.Run("sim main.plc -Wno-W330 " + arguments); }
  Workplace work_;
};

// covers: NC110-237
TEST_F(Sim, OneRowForEachScan) {
  const Ran ran = Run("--for 30ms --watch U4A0,W100K0");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_EQ(ran.out,
            "  time ms  U4A0        W100K0\n"
            "        0     0  00000001   1\n"
            "       10     0  00000010   2\n"
            "       20     0  00000011   3\n");
  EXPECT_THAT(ran.errors, HasSubstr("ran 3 periods, 30 ms simulated, 3 slow cycles"));
}

TEST_F(Sim, ChangesOnlyAndWritesAtATime) {
  const Ran ran = Run("--for 100ms --changes --watch U4A0,U4A2 --at 20ms:I0A0=1 --at 50ms:I0A0=0 --at 45ms:I0A1=1");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_EQ(ran.out,
            "  time ms  U4A0  U4A2\n"
            "        0     0     0\n"
            "       20     1     0\n"
            "       50     0     1\n");
}

TEST_F(Sim, UntilSlowCyclesAreDone) {
  const Ran ran = Run("--cycles 4 --watch W100K0 --set slices=2");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("ran 8 periods, 80 ms simulated, 4 slow cycles"));
}

// A fast part with a period of its own is no period of the machine: the time is as long as asked for.
TEST_F(Sim, TimeIsTimeWhereTheFastPartHasItsOwnPeriod) {
  work_.Write("t.plc",
              "        DATA\nBITY: DFM A,Q\n        DATA_END\n        MODULE_MAIN\n        LDR A\n        WR Q\n"
              "        MODULE_MAIN_END\n        STOP\n");
  const Ran ran = work_.Run("sim t.plc --dialect technol --for 400ms --changes --watch Q --at 300ms:A=1");
  EXPECT_THAT(ran.out, HasSubstr("      300  1\n"));
  EXPECT_THAT(ran.errors, HasSubstr("ran 20 periods, 400 ms simulated, 20 slow cycles"));
  EXPECT_THAT(work_.Run("sim t.plc --dialect technol --cycles 7").errors,
              HasSubstr("ran 7 periods, 140 ms simulated, 7 slow cycles"));
}

// covers: NC110-236
TEST_F(Sim, ForceWinsAgainstTheProgram) {
  const Ran ran = Run("--for 20ms --watch U4A0,W100K0 --force U4A0=1 --force W100K0=0FH");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("       10     1  00001111  15\n"));
}

// covers: NC110-235
TEST_F(Sim, LinesSwitchedOff) {
  EXPECT_THAT(Run("--for 20ms --watch W100K0 --disconnect-lines 3").out, HasSubstr("       10  00000000   0\n"));
  EXPECT_THAT(Run("--for 20ms --watch W100K0 --disconnect-lines 1,2").out, HasSubstr("       10  00000010   2\n"));
  EXPECT_THAT(Run("--for 20ms --watch W100K0 --disconnect-lines '*'").out, HasSubstr("       10  00000000   0\n"));
  EXPECT_THAT(Run("--for 20ms --watch W100K0 --disconnect-lines main.plc:2,3").out,
              HasSubstr("       10  00000000   0\n"));
  for (const std::string lines : {"9", "3,2", "x", "other.plc:1", "4"}) {
    EXPECT_EQ(Run("--disconnect-lines " + lines).code, 2) << lines;
  }
}

// covers: NC110-237
TEST_F(Sim, GraphBeginsWithAnEdge) {
  const Ran ran =
      Run("--for 1s --watch W100K0 --at 100ms:I0A0=1 --trigger rising:U4A0 --delay 20ms --sampling 30ms --samples 3");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, ContainsRegex("120 +13\n"));
  EXPECT_THAT(ran.out, ContainsRegex("150 +16\n"));
  EXPECT_THAT(ran.out, ContainsRegex("180 +19\n"));
  EXPECT_THAT(ran.out, Not(HasSubstr("210")));
  EXPECT_THAT(Run("--for 50ms --watch W100K0 --trigger falling:U4A0").errors, HasSubstr("did not come"));
}

TEST_F(Sim, Waveform) {
  const Ran ran = Run("--for 50ms --watch U4A0,W100K0 --vcd out.vcd");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(work_.Read("out.vcd"), HasSubstr("$var"));
  EXPECT_EQ(Run("--for 50ms --watch U4A0 --vcd new/folder/out.vcd").code, 0);
  EXPECT_TRUE(work_.Has("new/folder/out.vcd"));
  const Ran refused = Run("--for 50ms --watch U4A0 --vcd out.vcd/below.vcd");  // before the work, not after it
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.errors, HasSubstr("cannot write 'out.vcd/below.vcd': not a directory; "));
  EXPECT_EQ(Run("--for 50ms --vcd out.vcd").code, 2);
}

TEST_F(Sim, TheWaveformGoesOverNoSource) {
  const Ran ran = Run("--watch U4A0 --vcd main.plc");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("cannot write 'main.plc': it is a source of this program"));
}

TEST_F(Sim, WordsThatMeanNothing) {
  for (const std::string arguments : {"--for 3",
                                      "--for 3h",
                                      "--for 0s",
                                      "--for 4000000s",
                                      "--cycles 0",
                                      "--for 1s --cycles 3",
                                      "--watch NOTHING",
                                      "--watch OPERATOR_TEXT",
                                      "--at I0A0=1",
                                      "--at 1s:I0A0",
                                      "--at 1s:I0A0=2",
                                      "--at x:I0A0=1",
                                      "--force U4A0=2",
                                      "--force U4A0=1 --force U4A0=0",
                                      "--force OPERATOR_TEXT=a",
                                      "--trigger U4A0",
                                      "--trigger up:U4A0",
                                      "--trigger rising:W100K0 --watch U4A0",
                                      "--trigger rising:U4A0",
                                      "--delay 5ms",
                                      "--time-limit 0"}) {
    const Ran ran = Run(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("error:")) << arguments;
  }
  EXPECT_THAT(Run("--force U4A0=7").errors, HasSubstr("value 7 does not fit: 'U4A0' takes 0 to 1"));
  EXPECT_THAT(Run("--force U4A0=x").errors, HasSubstr("'x' is no value: 'U4A0' takes 0 to 1"));
  std::string many = "--watch U4A0";
  for (int i = 1; i < 17; ++i) many += ",U4A" + std::to_string(i);
  EXPECT_THAT(Run(many).errors, HasSubstr("up to 16"));
}

// An empty list took the next option for its location.
TEST_F(Sim, AListOfNothingIsRefused) {
  const Ran ran = Run("--watch , --for 20ms");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("'--watch ,' names no location"));
  EXPECT_EQ(Run("--watch U4A0, --for 20ms").code, 0);
}

TEST_F(Sim, WhatComesAfterTheEndIsNoted) {
  const Ran ran = Run("--watch U4A0 --for 100ms --at 90ms:I0A0=1 --at 91ms:I0A0=0 --at 5s:I0A0=1");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors, AllOf(HasSubstr("note: '--at 5s:I0A0=1' did not come"), HasSubstr("'--at 91ms:I0A0=0'"),
                                Not(HasSubstr("90ms"))));
}

TEST_F(Sim, RealTimeIsLimited) {
  const Ran ran = Run("--for 9999s --changes --watch U4A0 --time-limit 1");
  // A fast machine may be done before.
  EXPECT_TRUE(ran.code == 1 || ran.code == 0) << ran;
  if (ran.code == 1) {
    EXPECT_THAT(ran.errors, HasSubstr("stopped after 1 s"));
  }
}

}  // namespace
}  // namespace plcxx::driver
