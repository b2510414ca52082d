// plcxx prove: each kind of property proved and violated, and the counterexamples run again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Two valves that lock each other, a latch, one that nobody can reset, and a register that the program moves on.
constexpr std::string_view kMachine =
    "$\n"
    "U4A8=I0A0*/U4A9\n"
    "U4A9=I0A1*/U4A8\n"
    "U4A5=U4A5*/I0A4+I0A3\n"
    "U4A6=U4A6+I0A5\n"
    "U4A2=U4A1\n"
    "U4A1=I0A2\n";

struct Machine {
  explicit Machine(std::string_view source = kMachine) { work.Write("m.plc", source); }
  Ran Prove(std::string_view properties, const std::string& options = "") const {
    work.Write("m.prop", properties);
    return work.Run("prove m.plc --property m.prop --counterexamples found " + options);
  }
  /// Violated, with a scenario that `plcxx test` sees fail.
  void ExpectShown(std::string_view property) const {
    const Ran ran = Prove(property);
    EXPECT_EQ(ran.code, 1) << ran;
    EXPECT_THAT(ran.out, HasSubstr("VIOLATED     " + std::string(property)));
    EXPECT_THAT(ran.out, Not(HasSubstr("not replayed")));
    const Ran again = work.Run("test --engine sim found/property-1.yaml");
    EXPECT_EQ(again.code, 1) << again;
    EXPECT_THAT(again.out, HasSubstr("property '" + std::string(property) + "' does not hold"));
  }
  void ExpectProved(std::string_view property) const {
    const Ran ran = Prove(property);
    EXPECT_EQ(ran.code, 0) << ran;
    EXPECT_THAT(ran.out, HasSubstr("proved       " + std::string(property)));
  }
  Workplace work;
};

TEST(Prove, EachKindIsProved) {
  const Machine machine;
  machine.ExpectProved("never U4A8 and U4A9");
  machine.ExpectProved("at most one of U4A8, U4A9");
  machine.ExpectProved("I0A3 implies U4A5");
  machine.ExpectProved("I0A4 and not I0A3 implies U4A5 is 0 within 1 slow");
  machine.ExpectProved("I0A2 for 2 slow implies U4A2");
  machine.ExpectProved("W4K3 in 0..255");
  machine.ExpectProved("U4A5 is never stuck within 1 slow");
  machine.ExpectProved("I0A2 implies U4A2 within 2 slow");
}

TEST(Prove, EachKindIsViolatedByARunThatCanBeRepeated) {
  const Machine machine;
  machine.ExpectShown("never U4A8 and U4A5");
  machine.ExpectShown("exactly one of U4A8, U4A9");
  machine.ExpectShown("I0A4 implies U4A5 is 0");
  machine.ExpectShown("I0A2 implies U4A2 within 1 slow");
  machine.ExpectShown("U4A6 for 3 slow implies I0A5");
}

// The base software drives the lamp U159K6 (nc110), and not the one beside it.
TEST(Prove, OneBitOfAByteMayBeTheControls) {
  const Machine machine("$\nU4A5=U159K6\nU4A6=U159K5\nU159K6=I0A0*/I0A0\nU159K5=I0A0*/I0A0\n");
  machine.ExpectShown("never U4A5");
  machine.ExpectProved("never U4A6");
}

TEST(Prove, AnOutputThatNobodyResetsIsStuck) {
  const Machine machine;
  const Ran ran = machine.Prove("U4A6 is never stuck within 3 slow\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("from there no inputs make it 0 within 3 periods"));
  EXPECT_THAT(machine.work.Read("found/property-1.yaml"), HasSubstr("- expect: {U4A6: 1}"));
  EXPECT_EQ(machine.work.Run("test --engine sim found/property-1.yaml").code, 0);
}

// The program writes the output under a condition and never reads it: its own value is no part of what decides.
TEST(Prove, AnOutputThatIsSetInABlockAndNowhereReadIsStuck) {
  const Machine machine("$\nDOF: I0A5\nU4A0=1\nENDF\n");
  const Ran ran = machine.Prove("U4A0 is never stuck within 3 slow\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("from there no inputs make it 0 within 3 periods"));
  EXPECT_EQ(machine.work.Run("test --engine sim found/property-1.yaml").code, 0);
}

// prostep reads the table by an index alone; the host may set it, and a scenario says `DB10`.
TEST(Prove, AByteThatOnlyAnIndexReachesHasAName) {
  Machine machine;
  machine.work.Write("m.plc",
                     "DDB 10 3\nDDB 11 7\n:MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n:MOD PM 9\n:L\n: K 0\n:L IB 2\n"
                     ":JU FM 8\n: K 1\n:JU FM 15\n: DB 10\n: K 0\n:T DB 31\n:END PM 9\n");
  machine.ExpectShown("DB31 in 0..20");
  EXPECT_THAT(machine.work.Read("found/property-1.yaml"), HasSubstr("- set: {DB10: "));
}

// Inputs at random hold what a count needs for a few pulses only; the run is told by what comes again.
TEST(Prove, ACountOfCountsIsFoundByPulsesThatComeAgain) {
  const Machine machine(
      "$\nP1=I0A3\nC1Z=I0A4\nC1I(10)=P1*I0A1*/I0A2\nDOF: C1R\nW30K0=[W30K0+1]\nENDF\nU4A0=[W30K0>2]\n");
  machine.ExpectShown("never U4A0");
  const Ran ran = machine.Prove("never U4A0\n");
  EXPECT_THAT(ran.out, HasSubstr(" times ("));
}

// All words of host50 have a sign.
TEST(Prove, AWordMayBeBelowZero) {
  const Workplace work;
  work.Write("m.il", "SLOW\nNETWORK\n  LD %I1\n  SUBW 0, %IW5, %W120\nEND_SLOW\n");
  work.Write("m.prop", "never %W120 < 0\nnever %W120 = -5\n%W120 in -2147483648..2147483647\n");
  const Ran ran = work.Run("prove m.il --property m.prop --counterexamples found");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never %W120 < 0")) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never %W120 = -5"));
  EXPECT_THAT(ran.out, HasSubstr("proved       %W120 in -2147483648..2147483647"));
  for (const char* found : {"property-1", "property-2"}) {
    const Ran again = work.Run("test --engine sim found/" + std::string(found) + ".yaml");
    EXPECT_EQ(again.code, 1) << again;
  }
  // What comes out is the smallest number, which is its own opposite.
  work.Write("m.prop", "never %W120 = -2147483648\n");
  EXPECT_THAT(work.Run("prove m.il --property m.prop").out, HasSubstr("IW5=-2147483648"));
}

TEST(Prove, AFloatIsSetAsTheNumberThatItIs) {
  const Workplace work;
  work.Write("m.il",
             "SLOW\nNETWORK\n  LD 1\n  GT %IF10, 1.0\n  AND %I1\n  OUT %Q0\n  LD 1\n  LT %IF10, 2.0\n"
             "  AND %Q0\n  OUT %Q1\nEND_SLOW\n");
  work.Write("m.prop", "never %Q1\n");
  const Ran ran = work.Run("prove m.il --property m.prop --counterexamples found");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never %Q1")) << ran;
  EXPECT_THAT(ran.out, HasSubstr("IF10=1."));
  EXPECT_EQ(work.Run("test --engine sim found/property-1.yaml").code, 1);
}

TEST(Prove, WhatHoldsInReachableStatesOnlyNeedsInvariants) {
  // A ring of three steps that I0A0 moves on: from a state with two of them, any two may meet.
  const Machine machine(
      "$\n"
      "U4A20=U4A13\n"
      "U4A13=U4A12*I0A0+U4A13*/I0A0\n"
      "U4A12=U4A11*I0A0+U4A12*/I0A0\n"
      "U4A11=U4A20*I0A0+U4A11*/I0A0+/U4A12*/U4A13\n");
  const Ran ran = machine.Prove("never U4A11 and U4A12\n");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("by induction over 1 period, with "));
}

TEST(Prove, InputsChangeBetweenSlices) {
  // Between the slices I0A0 changes, and U4A0 is 1 for a pass.
  std::string between;
  for (int i = 0; i < 12; ++i)
    between += "U" + std::to_string(110 + i) + "K0=I1A" + std::to_string(i) + "*I2A" + std::to_string(i) + "\n";
  const Machine machine("$\nU100K0=I0A0\n" + between + "U4A0=I0A0&U100K0\n");
  machine.work.Write("p.prop", "never U4A0\n");
  const Ran whole = machine.work.Run("prove m.plc --property p.prop");
  EXPECT_EQ(whole.code, 0) << whole;
  EXPECT_THAT(whole.out, Not(HasSubstr("slices")));
  const Ran sliced = machine.work.Run("prove m.plc --property p.prop --set slices=2 --counterexamples found");
  EXPECT_EQ(sliced.code, 1) << sliced;
  EXPECT_THAT(sliced.out, HasSubstr("1 violated"));
  EXPECT_EQ(machine.work.Run("test --engine sim found/property-1.yaml").code, 1);
  // What is read once, or is latched for the pass, cannot change in between.
  const Ran latched = machine.work.Run("prove m.plc --property p.prop --set slices=2 --set latch-slow-inputs=on");
  EXPECT_EQ(latched.code, 0) << latched;
  EXPECT_THAT(latched.out, Not(HasSubstr("between")));
}

TEST(Prove, AFixedScenarioPasses) {
  const Machine machine("$\nU4A8=I0A0\nU4A9=I0A1\n");
  machine.ExpectShown("never U4A8 and U4A9");
  machine.work.Write("m.plc", kMachine);
  EXPECT_EQ(machine.work.Run("test --engine sim found/property-1.yaml").code, 0);
}

TEST(Prove, PropertiesStandInScenarios) {
  const Machine machine;
  machine.work.Write(
      "s.yaml",
      "sources: [m.plc]\nproperties:\n- never U4A8 and U4A9\n- \"U4A1 is I0A2\"\nsteps:\n- set: {I0A0: 1}\n- "
      "run: {slow: 2}\n");
  const Ran proved = machine.work.Run("prove s.yaml");
  EXPECT_EQ(proved.code, 0) << proved;
  EXPECT_THAT(proved.out, HasSubstr("2 properties: 2 proved"));
  EXPECT_EQ(machine.work.Run("test --engine sim s.yaml").code, 0);
  machine.work.Write("wrong.yaml", "sources: [m.plc]\nproperties:\n- never U4A8 and\nsteps:\n- run: {slow: 2}\n");
  const Ran wrong = machine.work.Run("prove wrong.yaml");
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_THAT(wrong.errors, HasSubstr("wrong.yaml:3:17: error: the end of the line stands where"));
  const Ran test = machine.work.Run("test --engine sim wrong.yaml");
  EXPECT_EQ(test.code, 2) << test;
  EXPECT_THAT(test.errors, HasSubstr("wrong.yaml:3:17: the end of the line stands where"));
}

TEST(Prove, WrongPropertiesAreErrorsWithTheirPlaces) {
  const Machine machine;
  const Ran ran = machine.Prove("never U4A8 and U4B9\n# fine\nW4K3 = 256\n");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("m.prop:1:16: error: 'U4B9' is no location of dialect nc110 [plcxx-51]"));
  EXPECT_THAT(ran.errors, HasSubstr("m.prop:3:8: error: value 256 does not fit 'W4K3' [plcxx-54]"));
  EXPECT_EQ(machine.Prove("# nothing\n").code, 2);
  EXPECT_EQ(machine.work.Run("prove m.plc").code, 2);
  EXPECT_EQ(machine.work.Run("prove m.plc --property none.prop").code, 2);
  EXPECT_EQ(machine.work.Run("prove m.plc --property m.prop --time soon").code, 2);
}

TEST(Prove, AProgramWithErrorsIsNotProved) {
  const Machine machine(kBadProgram);
  EXPECT_EQ(machine.Prove("never U4A8 and U4A9\n").code, 1);
}

TEST(Prove, ResultsForPipelines) {
  const Machine machine;
  const Ran ran = machine.Prove("never U4A8 and U4A9\nnever U4A5\n", "--format json --junit proofs.xml");
  EXPECT_EQ(ran.code, 1) << ran;
  const auto report = nlohmann::json::parse(ran.out);
  ASSERT_EQ(report["properties"].size(), 2U);
  EXPECT_EQ(report["properties"][0]["verdict"], "proved");
  EXPECT_EQ(report["properties"][1]["verdict"], "violated");
  EXPECT_EQ(report["properties"][1]["line"], 2);
  EXPECT_EQ(report["properties"][1]["replayed"], true);
  EXPECT_THAT(machine.work.Read("proofs.xml"), HasSubstr("<testcase classname=\"m.prop\" name=\"never U4A5\">"));
}

// The interlocks of the lathe, and a version in which one of them was forgotten.
TEST(Prove, InterlocksOfTheLathe) {
  const Workplace work;
  work.Write("lathe.prop",
             "never !CHKVCL and !CHKVUN\nnever !TURFWD and !TURREV\nnever !TSVFWD and !TSVBACK\n"
             "at most one of !RNGV1, !RNGV2, !RNGV3\n");
  const Ran ran = work.Run("prove " PLCXX_ROOT "/samples/nc110/lathe_16k20/tool_change.yaml --property lathe.prop");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("4 properties: 4 proved"));
}

TEST(Prove, InterlocksOfTheSecondLathe) {
  const Workplace work;
  work.Write("lathe.prop", "never CHUCK_CL and CHUCK_OP\nnever TUR_FWD and TUR_REV\nnever CHIP_FWD and CHIP_REV\n");
  const Ran ran = work.Run("prove " PLCXX_ROOT "/samples/host50/ck6150/turret_change.yaml --property lathe.prop");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("3 properties: 3 proved"));
}

}  // namespace
}  // namespace plcxx::driver
