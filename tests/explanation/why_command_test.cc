// plcxx why as a person meets it: a machine of a few statements in each language, and what is said of its signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kLamp = R"($
; request
U3A1=I0A3*/T5U+U3A1*I0A5
; the lamp
U4A8=U3A1*/I0A4*I0A7
T5I(30)=I0A6
)";

std::string Yaml(const std::string& steps) { return "dialect: nc110\nsources: [lamp.plc]\nsteps:\n" + steps; }

class Why : public ::testing::Test {
 protected:
  Why() { work.Write("lamp.plc", kLamp); }
  Ran Ask(const std::string& steps, const std::string& arguments) const {
    work.Write("s.yaml", Yaml(steps));
    return work.Run("why --scenario s.yaml " + arguments);
  }
  Workplace work;
};

TEST_F(Why, OneOfSeveralReasonsIsEnough) {
  // Both other conditions hold it off as well; each ends at one input.
  EXPECT_EQ(Ask("- set: {I0A4: 1}\n- run: {slow: 2}\n", "U4A8").out,
            "U4A8 is 0 at 10 ms: lamp.plc:5:1: U4A8=U3A1*/I0A4*I0A7  (the lamp)\n"
            "  I0A7 is 0: as at power-on\n");
}

TEST_F(Why, ThroughOtherCoilsToInputs) {
  EXPECT_EQ(Ask("- set: {I0A7: 1, I0A3: 0}\n- run: {slow: 1}\n", "U4A8").out,
            "U4A8 is 0 at 0 ms: lamp.plc:5:1: U4A8=U3A1*/I0A4*I0A7  (the lamp)\n"
            "  U3A1 is 0: lamp.plc:3:1: U3A1=I0A3*/T5U+U3A1*I0A5  (request)\n"
            "    I0A3 is 0: set by the scenario or the control at 0 ms\n"
            "    I0A5 is 0: as at power-on\n");
}

TEST_F(Why, WhatHoldsItselfCameOnInAnEarlierScan) {
  const std::string out =
      Ask("- set: {I0A7: 1, I0A3: 1, I0A5: 1}\n- run: {slow: 1}\n- set: {I0A3: 0}\n- run: {slow: 5}\n", "U4A8").out;
  EXPECT_THAT(out,
              AllOf(HasSubstr("U4A8 is 1 at 50 ms: lamp.plc:5:1"),
                    HasSubstr("U3A1 is 1: since 0 ms, by lamp.plc:3:1: U3A1=I0A3*/T5U+U3A1*I0A5"),
                    HasSubstr("I0A3 is 1: set by the scenario or the control at 0 ms"), HasSubstr("I0A5 is 1: set")));
}

TEST_F(Why, ATimerSaysWhatIsLeft) {
  EXPECT_THAT(Ask("- set: {I0A6: 1}\n- run: {ms: 1000}\n", "T5U").out,
              AllOf(HasSubstr("T5U is 0 at 990 ms: lamp.plc:6:1: T5I(30)=I0A6"), HasSubstr("of 3000 ms, "),
                    HasSubstr(" ms left")));
  EXPECT_THAT(Ask("- run: {ms: 1000}\n", "T5U").out,
              AllOf(HasSubstr("I0A6 is 0: as at power-on"), Not(HasSubstr("ms left"))));
}

// What an edge has of the scan before is told, not what this scan left in it, and in words that are a sentence.
TEST_F(Why, AnEdgeSaysWhatItHadBefore) {
  work.Write("edge.il", "SLOW\nNETWORK\nLDP %I0\nOUT %Q0\nEND_SLOW\n");
  const auto ask = [&](const std::string& steps) {
    work.Write("e.yaml", "dialect: host50\nsources: [edge.il]\nsteps:\n" + steps);
    return work.Run("why --scenario e.yaml Q0").out;
  };
  const std::string rises = "- run: {slow: 1}\n- set: {I0: 1}\n- run: {slow: 1}\n";
  EXPECT_THAT(ask(rises), AllOf(HasSubstr("Q0 is 1"), HasSubstr("I0_edge had 0: kept"), Not(HasSubstr("is was"))));
  EXPECT_THAT(ask(rises + "- run: {slow: 1}\n"), AllOf(HasSubstr("Q0 is 0"), HasSubstr("I0_edge had 1: kept")));
}

TEST_F(Why, ACounterSaysWhatItHadBefore) {
  work.Write("count.il", "SLOW\nNETWORK\nLD %I0\nCNUD %C1, 2, P=0, M=0, N=0\nOUT %Q0\nEND_SLOW\n");
  work.Write("c.yaml",
             "dialect: host50\nsources: [count.il]\nsteps:\n- run: {slow: 1}\n- set: {I0: 1}\n- run: {slow: 1}\n");
  EXPECT_THAT(work.Run("why --scenario c.yaml Q0").out, HasSubstr("C1 had value 0, preset 2"));
}

TEST_F(Why, ForcedAndSetSignals) {
  EXPECT_THAT(Ask("- force: {U4A8: 1}\n- run: {slow: 1}\n", "U4A8").out, HasSubstr("U4A8 is 1 at 0 ms: forced"));
  EXPECT_THAT(Ask("- set: {I0A6: 1}\n- run: {slow: 1}\n", "I0A6").out,
              HasSubstr("I0A6 is 1 at 0 ms: set by the scenario or the control at 0 ms"));
}

TEST_F(Why, AStateInTheMiddle) {
  const std::string steps = "- set: {I0A7: 1, I0A3: 1}\n- run: {slow: 3}\n- set: {I0A4: 1}\n- run: {slow: 3}\n";
  EXPECT_THAT(Ask(steps, "U4A8").out, HasSubstr("U4A8 is 0 at 50 ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --step 2").out, HasSubstr("U4A8 is 1 at 20 ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --at 15ms").out, HasSubstr("U4A8 is 1 at 10 ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --step 1").out, HasSubstr("nothing has run since power-on"));
}

// The scan before a power cut says nothing of the state after it.
TEST_F(Why, AfterAPowerCycle) {
  const std::string steps = "- set: {I0A7: 1, I0A3: 1}\n- run: {slow: 3}\n- power_cycle: {}\n";
  EXPECT_EQ(Ask(steps, "U4A8").out, "U4A8 is 0: nothing has run since power-on\n");
  EXPECT_THAT(Ask(steps, "U4A8 --step 2").out, HasSubstr("U4A8 is 1 at 20 ms"));
  EXPECT_THAT(Ask(steps + "- set: {I0A7: 1, I0A3: 1}\n- run: {slow: 1}\n", "U4A8").out, HasSubstr("U4A8 is 1 at 0 ms"));
  work.Write("t.yaml", Yaml(steps + "- expect: {U4A8: 1}\n"));
  const Ran failed = work.Run("test --engine sim t.yaml");
  EXPECT_EQ(failed.code, 1);
  EXPECT_THAT(failed.out, AllOf(HasSubstr("nothing has written U4A8 since power-on"), Not(HasSubstr("why:"))));
}

// A scenario ends at the first step that fails: what is told then is no answer to what was asked, and has to say so.
// Of the one the program, of the other one the run.
TEST_F(Why, TheProgramMayBeNamedByAScenario) {
  work.Write("program.yaml", Yaml("- run: {slow: 1}\n"));
  work.Write("run.yaml",
             "dialect: nc110\nsteps:\n- set: {I0A7: 1}\n- run: {slow: 1}\n- set: {I0A3: 1}\n- run: {slow: 1}\n");
  const Ran ran = work.Run("why U4A8 program.yaml --scenario run.yaml");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, StartsWith("U4A8 is 1 at 10 ms: lamp.plc:5:1"));
  EXPECT_EQ(work.Run("why U4A8 program.yaml --can --scenario run.yaml").code, 0);
  EXPECT_EQ(work.Run("why U4A8 run.yaml --scenario run.yaml").code, 2);
}

TEST_F(Why, AStateThatTheScenarioDoesNotGetTo) {
  const std::string steps = "- set: {I0A7: 1, I0A3: 1}\n- run: {slow: 3}\n- expect: {U4A8: 0}\n- run: {s: 1}\n";
  const Ran step = Ask(steps, "U4A8 --step 4");
  EXPECT_EQ(step.code, 1) << step;
  EXPECT_THAT(step.out, StartsWith("the scenario fails before step 4 is done; the state in which it ends:\nU4A8 is 1"));
  const Ran time = Ask(steps, "U4A8 --at 500ms");
  EXPECT_EQ(time.code, 1) << time;
  EXPECT_THAT(time.out, StartsWith("the scenario fails before 500ms; the state in which it ends:\nU4A8 is 1 at 20 ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --at 15ms").out, StartsWith("U4A8 is 1 at 10 ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --step 2").out, StartsWith("U4A8 is 1 at 20 ms"));
  EXPECT_THAT(Ask(steps, "U4A8").out, StartsWith("U4A8 is 1 at 20 ms"));
}

TEST_F(Why, AsJson) {
  const Ran ran = Ask("- set: {I0A4: 1, I0A3: 1, I0A7: 1}\n- run: {slow: 1}\n", "U4A8 --format json");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out,
              AllOf(HasSubstr("\"signal\": \"U4A8\""), HasSubstr("\"kind\": \"written\""), HasSubstr("\"line\": 5"),
                    HasSubstr("\"kind\": \"input\""), HasSubstr("\"because\": [\n")));
}

TEST_F(Why, WhetherItCanBeOnAtAll) {
  const Ran can = work.Run("why U4A8 lamp.plc --can");
  EXPECT_EQ(can.code, 0) << can;
  EXPECT_THAT(can.out, AllOf(HasSubstr("U4A8 can be on, after 1 period"), HasSubstr("sources: [lamp.plc]"),
                             HasSubstr("I0A3: 1")));
  work.Write("never.plc", "$\nU3A1=I0A3\nU4A8=U3A1*/I0A3\n");
  const Ran never = work.Run("why U4A8 never.plc --can");
  EXPECT_EQ(never.code, 0) << never;
  EXPECT_THAT(never.out, HasSubstr("U4A8 is never on: proved by induction"));
  EXPECT_THAT(work.Run("why U4A8 never.plc --can --format json").out, HasSubstr("\"can\": \"never\""));
}

TEST_F(Why, WrongUseHasARemedy) {
  const std::string steps = "- run: {slow: 1}\n";
  EXPECT_THAT(work.Run("why").errors, HasSubstr("SIGNAL is required"));
  EXPECT_THAT(work.Run("why U4A8").errors,
              HasSubstr("name a scenario with --scenario FILE or a trace with --vcd FILE, or ask with --can"));
  EXPECT_THAT(Ask(steps, "U4AA8").errors, HasSubstr("'U4AA8' is no location of nc110, did you mean 'U4A8'"));
  EXPECT_THAT(Ask(steps, "SOMETHING").errors,
              HasSubstr("'SOMETHING' is no location of nc110; 'plcxx report --print-symbols' lists those of the"));
  EXPECT_THAT(Ask(steps, "U4A8 --step 7").errors, HasSubstr("--step 7: s.yaml has the steps 1 to 1"));
  EXPECT_THAT(Ask(steps, "U4A8 --at soon").errors, HasSubstr("is no time: write it as in 1200ms"));
  EXPECT_THAT(Ask(steps, "U4A8 --step 1 --at 3s").errors, HasSubstr("leave one of them out"));
  EXPECT_THAT(Ask(steps, "U4A8 --can --step 1").errors, HasSubstr("--can asks about all states"));
  EXPECT_THAT(Ask(steps, "T9U").errors, HasSubstr("the program does not use it"));
  EXPECT_EQ(Ask(steps, "U4AA8").code, 2);
  EXPECT_EQ(work.Run("why U4A8 --scenario none.yaml").code, 2);
}

TEST_F(Why, AFileInPlaceOfTheSignalIsTold) {
  work.Write("s.yaml", Yaml("- run: {slow: 1}\n"));
  const auto refused = [&](const std::string& words) {
    const Ran ran = work.Run("why " + words);
    EXPECT_EQ(ran.code, 2) << ran;
    return ran.errors;
  };
  EXPECT_THAT(refused("s.yaml U4A8"),
              HasSubstr("'s.yaml' is a file, and the signal comes first: plcxx why U4A8 --scenario s.yaml"));
  EXPECT_THAT(refused("lamp.plc U4A8 --can"), HasSubstr("plcxx why U4A8 lamp.plc --can"));
  EXPECT_THAT(refused("lamp.plc --scenario s.yaml"), HasSubstr("'lamp.plc' is a file"));
  EXPECT_THAT(refused("U4A8 s.yaml"), HasSubstr("the run of 's.yaml' is named with --scenario s.yaml"));
}

TEST_F(Why, AFailedExpectationSaysWhy) {
  work.Write("s.yaml", Yaml("- set: {I0A7: 1}\n- run: {slow: 1}\n- expect: {U4A8: 1}\n"));
  EXPECT_THAT(work.Run("test s.yaml --engine sim").out,
              HasSubstr("  why:\n    U4A8 is 0 at 0 ms: lamp.plc:5:1: U4A8=U3A1*/I0A4*I0A7  (the lamp)\n"
                        "      U3A1 is 0: lamp.plc:3:1"));
}

constexpr const char* kContacts =
    "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n_FILE-rung_0.csv\n"
    "1-0-50/0 , 1-0-50/1 , 9-0-0/0 , 50-0-60/0\n_/FILE-rung_0.csv\n_/FILES_CLASSICLADDER\n";

struct Language {
  const char *dialect, *file, *text, *set, *signal, *because;
};

class WhyLanguage : public ::testing::TestWithParam<Language> {};

TEST_P(WhyLanguage, SaysWhatKeepsACoilOff) {
  const Workplace work;
  work.Write(GetParam().file, GetParam().text);
  work.Write("s.yaml", std::string("dialect: ") + GetParam().dialect + "\nsources: [" + GetParam().file +
                           "]\nsteps:\n- set: {" + GetParam().set + "}\n- run: {slow: 2}\n");
  const Ran ran = work.Run(std::string("why '") + GetParam().signal + "' --scenario s.yaml");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, AllOf(HasSubstr(" is 0 at "), HasSubstr(GetParam().file), HasSubstr(GetParam().because))) << ran;
}

INSTANTIATE_TEST_SUITE_P(
    All, WhyLanguage,
    ::testing::Values(
        Language{"nc110", "a.plc", "$\nU4A8=I0A3*I0A4\n", "I0A3: 1", "U4A8", "I0A4 is 0"},
        Language{"technol", "a.plc",
                 "        DATA\nBITY: DFM A,B,Q\n        DATA_END\n        MODULE_MAIN\n        LDR A\n"
                 "        LA B\n        WR Q\n        MODULE_MAIN_END\n        STOP\n",
                 "A: 1", "Q", "(B) is 0"},
        Language{"prostep", "a.plc", ":MOD PM 9\n:A F 1.0\n:A F 1.1\n:= F 1.2\n:END PM 9\n", "F1.0: 1, F251.0: 1",
                 "F1.2", "F 1.1 is 0"},
        Language{"host50", "a.il", "SLOW\nNETWORK\nLD %I0\nAND %I1\nOUT %Q0\nEND_SLOW\n", "I0: 1", "Q0", "I1 is 0"},
        Language{"classicladder", "a.clp", kContacts, "I0: 1", "Q0", ": %I0 %I1 (%Q0)\n  I1 is 0: as at power-on"},
        Language{"hnc", "a.cld",
                 "#include \"plc.h\"\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
                 "void plc1() { Y[0] = X[0] & X[1]; }\nvoid plc2() { }\n",
                 "\"X[0]\": 255", "Y[0]", "is 0: as at power-on"}),
    [](const auto& named) { return std::string(named.param.dialect); });

// Of a sequential page it is not known how often it is gone through; the recorded scan is.
TEST(WhyOfLoops, TheRoundsOfTheScanAreFollowed) {
  const Workplace work;
  const Ran ran = work.Run("why UNCLAMP --step 6 --scenario " PLCXX_ROOT "/samples/classicladder/turret/change.yaml");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("UNCLAMP is 1 at 10 ms: "), HasSubstr(": %X2.A (%Q1); %X3.A +; "),
                             HasSubstr("X2.A is 1"), HasSubstr("I2 (CHANGE: of iocontrol: tool-change) is 1")));
}

// One document of all programs: what reads JSON or SARIF reads one value.
TEST(DiagnosticsOfAllPrograms, AreOneDocument) {
  const Workplace work;
  work.Write("a.plc", "$\nU4A8=I0A3\nU4A8=I0A4\n");
  work.Write("b.plc", "$\nU5A8=I0A3\nU5A8=I0A4\nU5A9=IOA7\n");
  work.Write(
      "plcxx.yaml",
      "programs:\n- {name: a, dialect: nc110, sources: [a.plc]}\n- {name: b, dialect: nc110, sources: [b.plc]}\n");
  const Ran as_json = work.Run("check --all --diagnostics=json"),
            as_sarif = work.Run("check --all --diagnostics=sarif");
  EXPECT_EQ(as_json.code, 1) << as_json;
  EXPECT_EQ(as_sarif.code, 1) << as_sarif;
  std::set<std::string> files, rules;
  for (const auto& message : nlohmann::json::parse(as_json.out)) files.insert(message["file"]);
  EXPECT_THAT(files, ElementsAre("a.plc", "b.plc"));
  const auto runs = nlohmann::json::parse(as_sarif.out)["runs"];
  ASSERT_EQ(runs.size(), 1U);
  const auto& listed = runs[0]["tool"]["driver"]["rules"];
  for (const auto& rule : listed) rules.insert(rule["id"]);
  EXPECT_EQ(rules.size(), listed.size());  // each once
  EXPECT_FALSE(runs[0]["results"].empty());
  for (const auto& result : runs[0]["results"])
    EXPECT_EQ(listed[result["ruleIndex"].get<size_t>()]["id"], result["ruleId"]);
}

}  // namespace
}  // namespace plcxx::driver
