// Warnings that need no control flow.
#include "tests/dialects/prostep_parsing.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/machine/signals.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> InModuleWarnings(std::string_view lines) { return WarningsOf(InModule(lines)); }

/// A program that activates PM 9 with these lines in it; the first is line 6.
std::vector<std::string> InProgram(const std::string& lines, const std::string& declarations = "") {
  return WarningsOf(":MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n:MOD PM 9\n" + lines + "\n:END PM 9\n" + declarations,
                    Checks::kWholeProgram);
}

TEST(ProstepWarnings, Comments) {
  EXPECT_THAT(InModuleWarnings(":O I think\n:O dw x\n:L K is\n:K 1\n:O lub\n:O ;I x\n:O zz x"),
              ElementsAre("2:4 W02", "3:4 W02", "4:4 W02"));
  EXPECT_THAT(
      InModuleWarnings(":A I 0.0 I 0.1\n:A I 0.0 :x\n:A I 0.0 A I 0.1\n:NOP K5\n:A I 0.0 razy 5\n:A I 0.0 ;K 5"),
      ElementsAre("2:10 W03", "3:10 W03", "4:10 W03", "5:6 W03"));
  EXPECT_THAT(InModuleWarnings(":L\n:K 5 K 6"), ElementsAre("3:6 W03"));
}

TEST(ProstepWarnings, OperandsOnTheWrongLine) {
  EXPECT_THAT(InModuleWarnings(":L K 5\n:!= DB 20\n:L DB 5\n:L\n:DB 5"), ElementsAre("2:4 W04", "3:5 W04"));
}

TEST(ProstepWarnings, DecimalTimes) {
  EXPECT_THAT(InModuleWarnings(":SP T 1\n:K 16\n:S C 1\n:K 9\n:S C 1\n:K 153\n:S C 1\n:K 99H"),
              ElementsAre("3:2 W16", "7:2 W16"));
}

TEST(ProstepWarnings, Border) {
  EXPECT_THAT(InModuleWarnings(":L DW 499\n:T DW 498\n:L DB 499\n:JU FM 16\n:DW 499\n:K 1"), ElementsAre("2:4 W21"));
}

TEST(ProstepWarnings, FunctionalModules) {
  EXPECT_THAT(InModuleWarnings(":JU FM 44\n:DB 1\n:K 1\n:DB 4"), ElementsAre("3:2 W24"));
  EXPECT_THAT(InModuleWarnings(":JU FM 44\n:K 99\n:K 1\n:DB 4\n:JU FM 42\n:K 0\n:K 1\n:DB 4\n:JU FM 54\n:DB 4\n:K 2\n"
                               ":K 1"),
              ElementsAre("3:2 W25", "7:2 W25", "12:2 W25"));
  EXPECT_THAT(InModuleWarnings(":JU FM 44\n:K 41\n:K 1\n:DB 4\n:JU FM 41\n:K 41\n:K 1\n:DB 4\n:JU FM 54\n:DB 4\n:K 0\n"
                               ":K 1"),
              IsEmpty());
  EXPECT_THAT(InModuleWarnings(":JU FM 60\n:K 1\n:DB 4\n:K 8"), ElementsAre("3:2 W26", "5:2 W26"));
  EXPECT_THAT(InModuleWarnings(":JU FM 66\n:DB 0\n:DB 4"), ElementsAre("2:2 W27"));
}

TEST(ProstepWarnings, Calls) {
  EXPECT_THAT(WarningsOf(":MOD PM 20\n:JU PM 9\n:END PM 20\n:MOD PM 9\n:END PM 9\n"), ElementsAre("2:2 W31"));
  std::string deep;
  for (int i = 0; i <= 17; ++i) {
    const std::string number = std::to_string(20 + i);
    deep += ":MOD PM " + number + "\n" + (i < 17 ? ":JU PM " + std::to_string(21 + i) + "\n" : "") + ":END PM " +
            number + "\n";
  }
  EXPECT_THAT(WarningsOf(deep), ElementsAre("50:2 W32"));
}

TEST(ProstepWarnings, NothingIsMissing) { EXPECT_THAT(InProgram(":A I 0.0\n:= O 0.0"), IsEmpty()); }

TEST(ProstepWarnings, Activity) {
  EXPECT_THAT(WarningsOf(":MOD PM 9\n:END PM 9\n", Checks::kWholeProgram),
              ElementsAre("1:2 W30", "1:2 W30", "1:2 W35"));
  EXPECT_THAT(WarningsOf(":MOD PM 0\n:END PM 0\n", Checks::kWholeProgram), IsEmpty()) << "nothing to activate";
  EXPECT_THAT(WarningsOf(":MOD PM 0\n:R F 251.0\n:END PM 0\n:MOD PM 9\n:END PM 9\n", Checks::kWholeProgram),
              ElementsAre("1:2 W30", "4:2 W35"));
  for (const char* write :
       {":T FB 251", ":T FW 250", ":T FW 251", "= F 251.0", ":JU FM 17\n:FB 0\n:DW 2", ":JU FM 70\n:DB 0\n:FB 248"}) {
    const std::string line = std::string(write).starts_with("=") ? ":" + std::string(write) : write;
    EXPECT_THAT(WarningsOf(":MOD PM 0\n" + line + "\n:END PM 0\n:MOD PM 9\n:END PM 9\n", Checks::kWholeProgram),
                IsEmpty())
        << write;
  }
}

TEST(ProstepWarnings, Unused) {
  EXPECT_THAT(InProgram("X:A I 0.0\nY:NOP\n:JU Y"), ElementsAre("6:1 W29"));
  EXPECT_THAT(InProgram(":NOP", ":MOD PM 20\n:END PM 20\n:MOD PM 3\n:END PM 3\n"), ElementsAre("8:2 W35", "10:2 W35"));
}

TEST(ProstepWarnings, Messages) {
  EXPECT_THAT(InProgram(":S F 213.0\n:= F 220.7\n:S F 213.0"), ElementsAre("6:4 W33", "7:4 W33"));
  EXPECT_THAT(InProgram(":S F 213.0\n:R F 213.1", "DM 1 .a\nDM 2 .b\n"),
              ElementsAre("9:1 W05", "10:1 W05", "10:1 W34"));
  EXPECT_THAT(InProgram(":T FB 213", "DM 1 .a\nDM 8 .b\n"), ElementsAre("8:1 W05", "9:1 W05"));
}

TEST(ProstepWarnings, TimersAndCounters) {
  EXPECT_THAT(InProgram(":A T 1\n:= O 0.0"), ElementsAre("6:4 W36"));
  EXPECT_THAT(InProgram(":L C 1"), ElementsAre("6:4 W36"));
  EXPECT_THAT(InProgram(":SP T 1\n:K 5D\n:A I 0.0"), ElementsAre("6:2 W36"));
  EXPECT_THAT(InProgram(":SP T 1\n:K 5D\n:= O 0.0"), IsEmpty()) << "S behind it is its output";
  EXPECT_THAT(InProgram(":R T 1\n:R C 1"), IsEmpty());
  EXPECT_THAT(InProgram(":CU C 1\n:CD C 1\n:= O 0.0\n:A C 1\n:SP T 2\n:K 1D\n:SE T 2\n:K 1D\n:A T 2"),
              ElementsAre("10:2 W17", "12:2 W17"));
  EXPECT_THAT(InProgram(":CU C 1\n:CU C 1\n:A C 1"), ElementsAre("6:2 W17", "7:2 W17"));
}

TEST(ProstepWarnings, RefreshedInputs) {
  EXPECT_THAT(InProgram(":= I 0.0\n:T IB 2\n:T IW 1\n:= I 2.0\n:A I 0.0", "DDW 496 2\n"),
              ElementsAre("6:4 W20", "8:4 W20", "12:1 W05"));
  EXPECT_THAT(InProgram(":T IB 44\n:T IB 20", "DDW 496 21\n"), ElementsAre("6:4 W20", "9:1 W05"));
}

TEST(ProstepOptions, Values) {
  const auto problems = [](const std::map<std::string, std::string>& options) {
    diag::Engine diagnostics;
    CheckOptions(options, diagnostics);
    return diagnostics.error_count();
  };
  EXPECT_EQ(problems({{"first-check", "dynamic"}, {"tick", "4"}, {"retentive", "256-383"}, {"strict", "on"}}), 0u);
  for (const auto& [key, value] : std::map<std::string, std::string>{{"first-check", "x"},
                                                                     {"tick", "0"},
                                                                     {"retentive", "5"},
                                                                     {"retentive", "9-5"},
                                                                     {"plc-axes", "6"},
                                                                     {"loop-budget", "-1"},
                                                                     {"muldiv", ""},
                                                                     {"nonsense", "1"}}) {
    EXPECT_EQ(problems({{key, value}}), 1u) << key << "=" << value;
  }
  const Settings settings = ReadSettings({{"retentive", "256-383"}, {"io-refresh", "1ms"}, {"tick", "x"}});
  EXPECT_EQ(settings.first_retentive, 256u);
  EXPECT_EQ(settings.last_retentive, 383u);
  EXPECT_EQ(settings.io_refresh, IoRefresh::kMillisecond);
  EXPECT_EQ(settings.tick_ms, 12u);
}

TEST(ProstepSignals, Table) {
  EXPECT_EQ(Signals().size(), 925u);
  ASSERT_EQ(SignalsAt(Space::kF, 250, 0, 1).size(), 1u);
  EXPECT_EQ(SignalsAt(Space::kF, 250, 0, 1)[0].name, "ActPm1");
  EXPECT_EQ(SignalsAt(Space::kI, 106, 0, 1)[0].meaning,
            "PLC axis 1: cause: time-out waiting for the feed enable (text repeats \"no mode selected\")");
  EXPECT_EQ(SignalsAt(Space::kI, 21, 4, 4)[0].name, "PanelSpindleOverride");
  EXPECT_EQ(SignalsAt(Space::kP, 0, 0, 8).size(), 2u) << "input and output";
  EXPECT_TRUE(SignalsAt(Space::kI, 250, 0, 1).empty());
}

}  // namespace
}  // namespace plcxx::prostep
