// plcxx prove: runs that no solver reaches, loops, retentive memory, and answers that say little.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/review/properties/prove_text.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ProveRuns, AViolationAfterALongTimeIsFoundAndShortened) {
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", "$\nT1I(30)=I0A0*/I0A1\nU4A8=T1U\nU4A9=I0A2\n", "never U4A8\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never U4A8\n             after 301 periods: I0A0=1, 3010 ms"));
  ExpectShown(work);
}

// Fifty steps, each with three inputs of its own, of which a wrong pair leads back to the first: neither a scenario nor
// luck comes to the end, and no solver looks so far. Many runs side by side do, from ever farther on.
TEST(ProveRuns, ALongSequenceIsFollowedToItsEnd) {
  constexpr int kSteps = 50;
  std::string source = "$\n";
  for (int step = 0; step < kSteps; ++step) {
    const auto input = [step](int factor) { return std::to_string((step * factor + step / 7) % 8); };
    const std::string at = "*[W30K0=" + std::to_string(step) + "]\n  W30K1=";
    source +=
        "DOF: I0A" + input(3) + "*/I1A" + input(5) + "*I2A" + input(1) + at + std::to_string(step + 1) + "\nENDF\n";
    source += "DOF: I1A" + input(5) + "*I2A" + input(7) + at + "0\nENDF\n";
  }
  source += "DOF: [W30K1=W30K1]\n  W30K0=W30K1\nENDF\nU4A0=[W30K0=" + std::to_string(kSteps) + "]\n";
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", source, "never U4A0\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never U4A0"));
  ExpectShown(work);
}

// A proof is about whole periods. With a fast part alone no time of a property passes, and what is violated later may
// come from it.
TEST(ProveRuns, AFastPartAloneIsNoStepOfAProperty) {
  const Workplace work;
  const std::string source = "U100K0=I0A0\n$\nU4A1=U100K1\nU100K1=I0A0\n";
  const Ran proved = Prove(work, "m.plc", source, "I0A0 implies U4A1 within 2 slow\n");
  EXPECT_EQ(proved.code, 0) << proved;
  const std::string scenario =
      "sources: [m.plc]\nproperties: [I0A0 implies U4A1 within 2 slow, never U100K0 and I0A7]\nsteps:\n"
      "- set: {I0A0: 1}\n- run: {fast: 9}\n- run: {slow: 3}\n";
  work.Write("s.yaml", scenario);
  EXPECT_EQ(work.Run("test --engine sim s.yaml").code, 0);
  work.Write("s.yaml", scenario + "- set: {I0A7: 1}\n- run: {fast: 1}\n- run: {slow: 1}\n");
  const Ran violated = work.Run("test --engine sim s.yaml");
  EXPECT_EQ(violated.code, 1) << violated;
  EXPECT_THAT(violated.out + violated.errors,
              HasSubstr("does not hold; the fast part ran alone before, and a proof is about whole periods"));
}

// TECHNOL's fast part has a time of its own: its periods are those of the clock, and a slow part alone is none.
TEST(ProveRuns, ASlowPartWithoutItsFastPartsIsNoPeriod) {
  const Workplace work;
  const Ran proved = Prove(work, "m.plc",
                           "        DATA\nIN0: DFM KUS\nOUT0: DFM CHOD,RYCH\n        DATA_END\n        MODULE_FAST\n"
                           "        LDR KUS\n        WR RYCH\n        MODULE_FAST_END\n        MODULE_MAIN\n"
                           "        LDR KUS\n        WR CHOD\n        MODULE_MAIN_END\n        STOP\n",
                           "CHOD implies RYCH\n");
  EXPECT_EQ(proved.code, 0) << proved;
  const std::string scenario = "sources: [m.plc]\nproperties: [CHOD implies RYCH]\nsteps:\n- set: {KUS: 1}\n- run: ";
  work.Write("s.yaml", scenario + "{ms: 100}\n");
  EXPECT_EQ(work.Run("test --engine sim s.yaml").code, 0);
  work.Write("s.yaml", scenario + "{slow: 1}\n");
  const Ran violated = work.Run("test --engine sim s.yaml");
  EXPECT_EQ(violated.code, 1) << violated;
  EXPECT_THAT(violated.out + violated.errors,
              HasSubstr("does not hold; the slow part ran without the fast parts of its period, and a proof is about "
                        "whole periods"));
}

// Three codes in this order, with two seconds between them: nobody guesses that, a scenario knows it.
TEST(ProveRuns, AViolationBehindAStartUpIsFoundByItsScenario) {
  constexpr std::string_view kSource =
      "$\nU4A1=U4A1+[W3K0=5AH]\nT1I(20)=U4A1*[W3K0=0A5H]\nU4A2=U4A2+T1U\nT2I(20)=U4A2*[W3K0=3CH]\nU4A8=T2U*I0A3\n";
  const Workplace work;
  work.Write("start.yaml",
             "sources: [m.plc]\nsteps:\n- set: {W3K0: 0x5A}\n- run: {slow: 1}\n- set: {W3K0: 0xA5}\n- run: {ms: 2100}\n"
             "- set: {W3K0: 0x3C}\n- run: {ms: 2500}\n- expect: {U4A8: 0}\n");
  const Ran ran = Prove(work, "m.plc", kSource, "never U4A8\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never U4A8"));
  const std::string scenario = work.Read("found/property-1.yaml");
  EXPECT_THAT(scenario, HasSubstr("I0A3: 1"));
  ExpectShown(work);
}

// The parts wait 16 ms and 32 ms, and a period is 1 ms: what is counted are calls, not periods. Three codes one after
// the other, and eight bits in a row, are 49 and 113 periods away; random inputs do not meet them.
TEST(ProveRuns, AViolationSomeCallsAwayIsFoundThoughAPeriodIsMuchShorter) {
  constexpr std::string_view kSource = R"(#include "plc.h"
static int s; static unsigned char row;
void init() { plc1_time = 16; plc2_time = 32; }
void plc1() {
  switch (s) {
    case 0: if (X[1] == 0x5A) s = 1; break;
    case 1: s = X[1] == 0xA5 ? 2 : 0; break;
    case 2: s = X[1] == 0x77 ? 3 : 0; break;
    case 3: Y[1] = 1;
  }
  row = row << 1 | (X[2] & 1);
  Y[2] = row == 0xB7;
}
void plc2() { }
)";
  const Workplace work;
  work.Write("m.cld", kSource);
  work.Write("m.prop", "Y[1] is 0\nY[2] is 0\n");
  const Ran ran = work.Run("prove m.cld --property m.prop --counterexamples found --time 60s");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     Y[1] is 0\n             after 49 periods: "));
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     Y[2] is 0\n             after 113 periods: "));
  ExpectShown(work);
  // It says so of proved ones, too: with a last code that no byte is.
  std::string holds(kSource);
  holds.replace(holds.find("0x77"), 4, "0x177");
  work.Write("m.cld", holds);
  work.Write("m.prop", "Y[1] is 0\n");
  const Ran proved = work.Run("prove m.cld --property m.prop --time 60s");
  EXPECT_EQ(proved.code, 0) << proved;
}

// What is looked for around a state is what the output depends on, not what properties before it have asked for: the
// mill took 35 s in place of 0.2 s, with 74 invariants.
TEST(ProveRuns, AProofDoesNotDependOnThePropertiesBeforeIt) {
  const std::string mill = PLCXX_ROOT "/samples/prostep/mill_fnd32/", stuck = "'O 0.3' is never stuck\n";
  const auto last = [&](const std::string& properties) {
    const Workplace work;
    work.Write("some.prop", properties + stuck);
    const Ran ran = work.Run("prove --project " + mill + "plcxx.yaml --property some.prop --format json --time 600s");
    const auto property = nlohmann::json::parse(ran.out)["properties"].back();
    EXPECT_EQ(property["verdict"], "proved") << ran;
    return property["invariants"].get<int>();
  };
  EXPECT_EQ(last("'O 2.0' is 'F 4.3'\nnever 'O 1.5' and 'O 1.6'\n"), last(""));
}

// prostep's and technol's programs have loops of which nobody knows how often they go round.
TEST(ProveRuns, PropertiesOfTheSamples) {
  for (const std::string machine : {"nc110/lathe_16k20", "host50/ck6150", "prostep/mill_fnd32"}) {
    const Ran ran = Workplace().Run("prove " PLCXX_ROOT "/samples/" + machine + "/properties.yaml --time 600s");
    EXPECT_EQ(ran.code, 0) << ran;
    EXPECT_THAT(ran.out, Not(HasSubstr("not decided")));
  }
}

// Of millions of terms: without optimization that takes minutes.
TEST(ProveRuns, PropertiesOfTheLargeSamples) {
#ifndef NDEBUG
  GTEST_SKIP() << "a release build has it";
#endif
  for (const std::string machine : {"technol/mcv_750", "hnc/mill_xk7132"}) {
    const Ran ran = Workplace().Run("prove " PLCXX_ROOT "/samples/" + machine + "/properties.yaml --time 600s");
    EXPECT_EQ(ran.code, 0) << ran;
    EXPECT_THAT(ran.out, Not(HasSubstr("not decided")));
  }
}

// The NC sets the strobe of an M function by a routine of its own, which the program resets: it is an input all the
// same.
TEST(ProveRuns, WhatTheHostSetsByARoutineIsAnInput) {
  const Workplace work;
  work.Write("nc.prop", "never 'F 4.4'\n");
  const Ran ran =
      work.Run("prove " PLCXX_ROOT
               "/samples/prostep/mill_fnd32/emergency_stop.yaml --property nc.prop --format json --time 600s");
  EXPECT_EQ(ran.code, 1) << ran;
  const auto properties = nlohmann::json::parse(ran.out)["properties"];
  EXPECT_EQ(properties.back()["property"], "never 'F 4.4'");
  EXPECT_EQ(properties.back()["verdict"], "violated");
}

// The program takes the counts and clears the signal: in no state that it reaches by itself is there any.
TEST(ProveRuns, WhatTheControlWritesBesideTheProgramIsAnInput) {
  constexpr std::string_view kHandwheel =
      "#include \"plc.h\"\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
      "void plc1() { if (get_handwheel(0) > 5) Y[0] = 1; Y[1] = get_axis_pos(1) == 70000; }\nvoid plc2() { }\n";
  const Workplace work;
  const Ran counts = Prove(work, "m.cld", kHandwheel, "never 'Y[0]' > 0\nnever 'Y[1]' > 0\n");
  EXPECT_EQ(counts.code, 1) << counts;
  EXPECT_THAT(work.Read("found/property-1.yaml"), HasSubstr("HW[0]"));
  ExpectShown(work);
  // What the program reaches by an index alone has a name, too.
  EXPECT_THAT(work.Read("found/property-2.yaml"), HasSubstr("F[")) << counts;
}

// It clears a command, and never gives one.
TEST(ProveRuns, WhatTheControlTakesBackIsCleared) {
  constexpr std::string_view kAxis =
      ":MOD PM 0\n:A I 20.1\n:S F 251.0\n:S F 251.1\n:S F 250.0\n:END PM 0\n:MOD PM 9\n:A I 20.1\n:AN F 0.0\n:S O "
      "106.3\n"
      ":S F 0.0\n:A I 0.0\n:S O 106.1\n:R O 106.2\n:A F 0.0\n:AN O 106.3\n:S O 0.0\n:END PM 9\n";
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", kAxis, "never 'O 0.0'\nnever 'O 106.2'\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never 'O 0.0'"));
  EXPECT_THAT(ran.out, HasSubstr("proved       never 'O 106.2'"));
}

// The program clears it, and has nothing that sets it: a part program does, or a record of the control.
TEST(ProveRuns, WhatTheProgramOnlyTakesBackSomebodyElseSets) {
  const Workplace work;
  const Ran ran = Prove(work, "m.plc",
                        "$\nU50K3=U50K3*/I0A3\nU4A0=U50K3\nU4A5=I0A5\nU4A6=/I0A5\nU50K4=U50K4+U4A5*U4A6\nU4A1=U50K4\n",
                        "never U4A0\nnever U4A1\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("VIOLATED     never U4A0"));
  EXPECT_THAT(work.Read("found/property-1.yaml"), HasSubstr("U50K3: 1"));
  ExpectShown(work);
  // It has a statement that sets it; that this never happens is the program's own.
  EXPECT_THAT(ran.out, HasSubstr("proved       never U4A1"));
}

TEST(ProveRuns, RetentiveMemoryThatIsAnything) {
  // W4T0 is retentive: the program itself never makes it more than 5.
  constexpr std::string_view kUnguarded = "$\nDOF: I0A0\n  W4T0 = 5\nENDF\nU4A8=[W4T0>5]\n";
  constexpr std::string_view kGuarded = "$\nDOF: I0A0 + [W4T0>5]\n  W4T0 = 5\nENDF\nU4A8=[W4T0>5]\n";
  const Workplace work;
  const Ran zero = Prove(work, "m.plc", kUnguarded, "never U4A8\n");
  EXPECT_EQ(zero.code, 0) << zero;
  // The control keeps the package only while U10K0 is 1 when the machine goes off.
  const Ran any = Prove(work, "m.plc", kUnguarded, "never U4A8\n", "--any-retentive --set old=on");
  EXPECT_EQ(any.code, 1) << any;
  EXPECT_THAT(any.out, HasSubstr("VIOLATED     never U4A8"));
  EXPECT_THAT(work.Read("found/property-1.yaml"), HasSubstr("- set: {U10K0: 1}\n- power_cycle: {}\n"));
  ExpectShown(work);
  const Ran guarded = Prove(work, "m.plc", kGuarded, "never U4A8\n", "--any-retentive --set old=on");
  EXPECT_EQ(guarded.code, 0) << guarded;
}

TEST(ProveRuns, ProofsThatSayLittleSaySo) {
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", "$\nU4A8=I0A0\n",
                        "I0A1 and not I0A1 implies U4A8\nI0A0 implies U4A8\nnever U4A9\n", "--format json");
  EXPECT_EQ(ran.code, 1) << ran;
  const auto properties = nlohmann::json::parse(ran.out)["properties"];
  EXPECT_EQ(properties[0]["note"], "what stands before 'implies' is never true");
  EXPECT_FALSE(properties[1].contains("note"));
  // An output that no statement writes keeps what the host's side puts there.
  EXPECT_EQ(properties[2]["verdict"], "violated");
  EXPECT_EQ(properties[2]["note"], "the program does not write 'U4A9': anybody may set it");
}

TEST(ProveRuns, TestCasesForPipelines) {
  const Workplace work;
  Prove(work, "m.plc", "$\nU4A8=I0A0\n", "U4A8 is I0A0\nnever U4A8\n", "--junit out/proofs.xml");
  const std::string xml = work.Read("out/proofs.xml");
  EXPECT_THAT(xml, HasSubstr("tests=\"2\""));
  EXPECT_THAT(xml, HasSubstr("failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"m.prop\" name=\"never U4A8\">"));
  EXPECT_THAT(xml, HasSubstr("after 1 period: I0A0=1, 10 ms"));
}

}  // namespace
}  // namespace plcxx::driver
