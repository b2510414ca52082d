// plcxx why of a recorded trace: the run is that of the trace, in each language, and what it does not say is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kHeldLamp = R"($
; request
U3A1=I0A3+U3A1*I0A5
; the lamp
U4A8=U3A1*/I0A4
T5I(2)=I0A6
)";

std::string Vcd(const std::string& changes) {
  return "$timescale 1 us $end\n$var wire 1 a I0A3 $end\n$var wire 1 b I0A4 $end\n$var wire 1 c I0A5 $end\n"
         "$var wire 1 d U4A8 $end\n$var wire 1 e SPEED $end\n$enddefinitions $end\n" +
         changes;
}

class WhyInTrace : public ::testing::Test {
 protected:
  WhyInTrace() { work.Write("lamp.plc", kHeldLamp); }
  Ran Ask(const std::string& trace, const std::string& arguments) const {
    work.Write("t.vcd", trace);
    return work.Run("why " + arguments + " --vcd t.vcd lamp.plc");
  }
  Workplace work;
};

TEST_F(WhyInTrace, TheInputsOfTheTraceDecide) {
  const std::string trace = Vcd("#0\n0a 0b 0c 0d 0e\n#20000\n1a 1c 1d\n#50000\n0a\n#80000\n1b 0d\n#120000\n");
  const Ran early = Ask(trace, "U4A8 --at 60ms");
  EXPECT_THAT(early.out, AllOf(StartsWith("U4A8 is 1 at 60 ms: lamp.plc:5:1"), HasSubstr("U3A1 is 1: since 20 ms"),
                               HasSubstr("I0A5 is 1: set")));
  EXPECT_EQ(early.errors, "note: left out of the trace, for the program has no such location: SPEED\n");
  EXPECT_THAT(Ask(trace, "U4A8").out, AllOf(StartsWith("U4A8 is 0 at 120 ms"), HasSubstr("  I0A4 is 1: set")));
  EXPECT_THAT(Ask(trace, "U4A8 --at 10ms").out, StartsWith("U4A8 is 0 at 10 ms"));
}

TEST_F(WhyInTrace, WhereTheRunIsAnotherOneIsNamed) {
  // The coil was on before the recording began: what held it is not in the trace.
  const Ran ran = Ask(Vcd("#0\n0a 0b 1c 1d 0e\n#100000\n"), "U4A8");
  EXPECT_THAT(ran.errors,
              HasSubstr("note: the run is not that of the trace: U4A8 (at 0 ms 1 in the trace, 0 in the run)"));
  EXPECT_THAT(ran.out, StartsWith("U4A8 is 0 at 100 ms"));
}

TEST_F(WhyInTrace, ARecordingNeedNotBeginAtZero) {
  const Ran ran = Ask(Vcd("#5000000\n0a 0b 0c 0d 0e\n#5020000\n1a 1d\n#5100000\n"), "U4A8 --at 5030ms");
  EXPECT_THAT(ran.out, AllOf(StartsWith("U4A8 is 1 at 5030 ms"), HasSubstr("I0A3 is 1: set")));
  EXPECT_THAT(ran.errors, Not(HasSubstr("not that of the trace")));
}

TEST_F(WhyInTrace, TheJsonHasItsNotesAndDepartures) {
  const Ran ran = Ask(Vcd("#0\n0a 0b 1c 1d 0e\n#100000\n"), "U4A8 --format json");
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["notes"], nlohmann::json({"left out of the trace, for the program has no such location: SPEED",
                                           "the run is not that of the trace: U4A8 (at 0 ms 1 in the trace, 0 in the "
                                           "run)"}));
  EXPECT_EQ(json["departures"],
            nlohmann::json({{{"signal", "U4A8"}, {"timeMs", 0}, {"inTrace", "1"}, {"inRun", "0"}}}));
  EXPECT_EQ(ran.errors, "");
  const Ran same = Ask(Vcd("#0\n0a 0b 0c 0d\n#20000\n1a 1d\n#100000\n"), "U4A8 --format json");
  EXPECT_EQ(nlohmann::json::parse(same.out)["departures"], nlohmann::json::array()) << same;
}

TEST_F(WhyInTrace, WrongWords) {
  const std::string trace = Vcd("#0\n0a\n#100000\n");
  EXPECT_THAT(Ask(trace, "U4A8 --at 3s").errors, HasSubstr("--at 3s: the trace has the times 0 to 100 ms"));
  EXPECT_THAT(Ask(trace, "U4A8 --can").errors, HasSubstr("leave --scenario, --step and --can out"));
  const Ran broken = Ask("no waveform\n", "U4A8");
  EXPECT_THAT(broken.errors, HasSubstr("t.vcd:1: error: 'no' where a declaration"));
  EXPECT_EQ(broken.code, 2);
  EXPECT_THAT(work.Run("why U4A8 --vcd none.vcd lamp.plc").errors, HasSubstr("cannot read 'none.vcd'"));
}

/// A program, and what is set and when, as `plcxx sim --at` takes it.
struct Recorded {
  std::string dialect, file, program, input, output;
  std::string start;  // what else has to be so, from the beginning
};

class WhyOfOwnTrace : public ::testing::TestWithParam<Recorded> {};

TEST_P(WhyOfOwnTrace, IsWhatTheSimulatorDid) {
  const Recorded& recorded = GetParam();
  Workplace work;
  work.Write(recorded.file, recorded.program);
  const std::string program = " --dialect " + recorded.dialect + " " + recorded.file;
  const std::string start = recorded.start.empty() ? "" : " --at 0ms:" + recorded.start + "=1";
  const std::string also = recorded.start.empty() ? "" : "," + recorded.start;
  const Ran sim = work.Run("sim" + program + start + " --for 400ms --at '96ms:" + recorded.input +
                           "=1' --at '208ms:" + recorded.input + "=0' --watch '" + recorded.input + "," +
                           recorded.output + also + "' --vcd t.vcd");
  ASSERT_EQ(sim.code, 0) << sim;
  for (const auto& [at, value] : {std::pair("60ms", "0"), std::pair("160ms", "1"), std::pair("350ms", "0")}) {
    const Ran why = work.Run("why '" + recorded.output + "' --vcd t.vcd --at " + std::string(at) + program);
    EXPECT_THAT(why.out, AllOf(StartsWith(recorded.output + " is " + value), HasSubstr(recorded.input))) << why;
    EXPECT_THAT(why.errors, IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Languages, WhyOfOwnTrace,
    ::testing::Values(Recorded{"nc110", "a.plc", "$\nU4A8=I0A3\n", "I0A3", "U4A8", ""},
                      Recorded{"host50", "a.il", "SLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n", "I0", "Q0", ""},
                      Recorded{"prostep", "a.plc", ":MOD PM 9\n:A F 1.1\n:= F 1.2\n:END PM 9\n", "F 1.1", "F 1.2",
                               "F251.0"},
                      Recorded{"technol", "a.plc",
                               "        DATA\nBITY: DFM A,Q\n        DATA_END\n        MODULE_MAIN\n        LDR A\n"
                               "        WR Q\n        MODULE_MAIN_END\n        STOP\n",
                               "A", "Q", ""},
                      Recorded{"classicladder", "a.clp",
                               "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n"
                               "_FILE-rung_0.csv\n1-0-50/0 , 50-0-60/0\n_/FILE-rung_0.csv\n_/FILES_CLASSICLADDER\n",
                               "I0", "Q0", ""},
                      Recorded{"hnc", "a.cld",
                               "#include \"plc.h\"\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
                               "void plc1() { Y[0] = X[3]; }\nvoid plc2() { }\n",
                               "X[3]", "Y[0]", ""}),
    [](const auto& test) { return test.param.dialect; });

}  // namespace
}  // namespace plcxx::driver
