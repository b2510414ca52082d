// The scheduler around the modules, and what declarations become.

#include "tests/dialects/prostep_lowered.h"

namespace plcxx::prostep {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

std::string ModuleText(int number, const std::string& statements) {
  const std::string name = "PM " + std::to_string(number);
  return ":MOD " + name + "\n" + statements + ":END " + name + "\n";
}

// covers: PS-182, PS-190
TEST(ProstepSchedule, InitIsPm0) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(0, ":A I 20.1\n:S F 251.0\n"));
  EXPECT_THAT(lowered.Routine("init"), Contains("host retentive_load () exchange"));
  EXPECT_THAT(lowered.Routine("init"), Contains("stmt F251_0"));
  EXPECT_THAT(lowered.program().spaces[ir::SpaceId(0)].initial,
              ElementsAre(testing::FieldsAre(20, 2)));  // I 20.1, already in PM 0
}

// covers: PS-183, PS-185, PS-186, PS-188
TEST(ProstepSchedule, FastRunsActiveModulesInOrder) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(3, ":A I 0.0\n:= O 0.0\n") + ModuleText(1, ":JU PM 3\n"));
  // PM 3 is called, too: it shares S and AX with whoever enters it.
  EXPECT_THAT(lowered.Routine("fast"),
              ElementsAre("%0 = load F250_0", "if %0 {", "call PM1 ()", "}", "%1 = load F250_2", "if %1 {",
                          "%2 = const bit 0", "store s %2", "%3 = const i16 0", "store ax %3", "call PM3 ()", "}"));
}

// covers: PS-184, PS-191
TEST(ProstepSchedule, ASliceIsOneLoopModule) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(10, ":A I 0.0\n:= O 0.0\n") + ModuleText(12, ""));
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("%0 = load slice", "switch %0 {", "case 1 {", "%1 = load F251_1", "if %1 {", "call PM10 ()",
                          "}", "}", "case 3 {", "%2 = load F251_3", "if %2 {", "call PM12 ()", "}", "}", "case 7 {",
                          "%3 = load slow_done", "%4 = const i32 1", "%5 = add.i32 %3 %4", "store slow_done %5", "}",
                          "default {", "}", "}"));
  EXPECT_THAT(lowered.Routine("slow_pass"), ElementsAre("%0 = const i8 1", "call slow (%0)", "%1 = const i8 3",
                                                        "call slow (%1)", "%2 = const i8 7", "call slow (%2)"));
}

// covers: PS-193
TEST(ProstepSchedule, TheBudgetOfASlowPassIsSharedByItsSlices) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(10, "X :JU X\n"), {{"loop-budget", "50"}});
  EXPECT_THAT(lowered.Routine("slow"), testing::IsSupersetOf({"%3 = const i32 50", "store slow_rounds %3",
                                                              "%4 = load slow_rounds", "store rounds_left %4"}));
  EXPECT_THAT(lowered.Routine("slow_pass"), Contains("%0 = const i8 0"));
}

// covers: PS-189, PS-270
TEST(ProstepSchedule, TheTickInItsOrder) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(1, ":A I 0.0\n:SP T 3\n: K 5\n"));
  EXPECT_THAT(lowered.Routine("tick"),
              ElementsAre("%0 = load elapsed_ms~2", "call advance (%0)", "call refresh_inputs ()", "%1 = const bit 0",
                          "store I20_0 %1", "%2 = const bit 1", "store I20_1 %2", "%3 = load ms_of_second",
                          "%4 = const i32 500", "%5 = uge.i32 %3 %4", "store I20_7 %5", "host nc_to_plc () exchange",
                          "call fast ()", "call refresh_outputs ()", "host plc_to_nc () exchange"));
  EXPECT_THAT(lowered.Routine("advance"), Contains("step.pass_time T3 %0"));
  const ir::Schedule& schedule = lowered.program().schedule;
  EXPECT_EQ(schedule.period_ms, 12u);
  EXPECT_TRUE(schedule.period_ends_its_time);
  EXPECT_FALSE(schedule.elapses_every_ms);
  EXPECT_THAT(lowered.Routine("elapse"), Not(Contains("call refresh_inputs ()")));
}

TEST(ProstepSchedule, RefreshEveryMillisecond) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(1, ""), {{"io-refresh", "1ms"}, {"tick", "10"}});
  EXPECT_TRUE(lowered.program().schedule.elapses_every_ms);
  EXPECT_EQ(lowered.program().schedule.period_ms, 10u);
  EXPECT_THAT(lowered.Routine("elapse"), testing::IsSupersetOf({"call refresh_inputs ()", "call refresh_outputs ()"}));
}

// covers: PS-242, PS-243
TEST(ProstepSchedule, RefreshOfOneByte) {
  LoweredProgram lowered;
  LowerInto(lowered, ModuleText(1, ""));
  const std::vector<std::string> inputs = lowered.Routine("refresh_inputs");
  EXPECT_THAT(std::vector<std::string>(inputs.begin(), inputs.begin() + 7),
              ElementsAre("%0 = load DW496", "%1 = const i16 0", "%2 = ugt.i16 %0 %1", "if %2 {", "%3 = const i32 0",
                          "%4 = host read_port (%3) exchange", "store IB0 %4"));
  EXPECT_THAT(inputs, Contains("store IB47 %96"));
  const std::vector<std::string> outputs = lowered.Routine("refresh_outputs");
  EXPECT_THAT(std::vector<std::string>(outputs.begin() + 4, outputs.begin() + 9),
              ElementsAre("%3 = load OB0", "store PB0 %3", "%4 = const i32 0", "%5 = load PB0",
                          "host write_port (%4, %5) exchange"));
}

// covers: PS-046, PS-192, PS-292
TEST(ProstepSchedule, TheRetentivePartOfD) {
  const auto bytes_of = [](const ir::Program& program) {
    std::vector<std::string> result;
    for (const ir::Space& space : program.spaces) {
      if (!space.name.starts_with("D")) continue;
      result.push_back(space.name + " " + std::to_string(space.bytes) +
                       (space.lifetime == ir::Lifetime::kRetentive ? " kept" : ""));
    }
    return result;
  };
  LoweredProgram usual, chosen;
  LowerInto(usual, "DDW 10 0102H\n" + ModuleText(1, ""));
  EXPECT_THAT(bytes_of(usual.program()), ElementsAre("D 500", "D_kept 500 kept"));
  EXPECT_THAT(usual.program().spaces[ir::SpaceId(3)].initial,
              ElementsAre(testing::FieldsAre(10, 2), testing::FieldsAre(11, 1)));
  LowerInto(chosen, "DDB 256 7\n" + ModuleText(1, ""), {{"retentive", "256-383"}});
  EXPECT_THAT(bytes_of(chosen.program()), ElementsAre("D 256", "D_kept 128 kept", "D_behind 616"));
  EXPECT_THAT(chosen.program().spaces[ir::SpaceId(4)].initial, ElementsAre(testing::FieldsAre(0, 7)));
}

// covers: PS-255, PS-271
TEST(ProstepSchedule, MFunctionsAreATableAndThePartOfTheNc) {
  LoweredProgram lowered;
  LowerInto(lowered, "DMF 3 S9 D2\nDMF 5\nDMF 30 D1\n" + ModuleText(1, ""));
  const ir::Table& table = lowered.program().tables.at(0);
  EXPECT_EQ(table.name, "m_functions");
  EXPECT_THAT(table.cells, ElementsAre(3, 0, 9, 2, 5, 1, 0, 0, 30, 1, 0, 1));
  EXPECT_THAT(lowered.Routine("m_begin"),
              ElementsAre("%0 = load number", "%1 = to_bcd.i8 %0", "store FB201 %1", "%2 = const bit 1",
                          "store F200_0 %2", "switch %0 {", "case 3 {", "%3 = const bit 1", "store F209_0 %3",
                          "%4 = const bit 1", "store F211_1 %4", "}", "case 30 {", "%5 = const bit 1",
                          "store F211_0 %5", "}", "default {", "}", "}"));
  EXPECT_THAT(lowered.Routine("m_end"),
              ElementsAre("%0 = const bit 0", "store F200_0 %0", "%1 = load number~2", "switch %1 {", "case 3 {",
                          "%2 = const bit 0", "store F211_1 %2", "}", "case 30 {", "%3 = const bit 0",
                          "store F211_0 %3", "}", "default {", "}", "}"));
}

TEST(ProstepSchedule, UsedAddressesAreDocumented) {
  LoweredProgram lowered;
  LowerInto(lowered, "DDW 20 5 ; czas smarowania\n" +
                         ModuleText(9, ":A I 28.0\n:SP T 5\n: DW 20\n:SP T 0\n: DW 20\n:CU C 0\n:CU C 63\n"));
  std::vector<std::string> rows;
  for (const ir::Documentation& row : lowered.program().documentation) {
    rows.push_back(row.address + "|" + row.predefined + "|" + row.meaning);
  }
  EXPECT_THAT(rows, ElementsAre("I 28.0|NcAlarm|NC alarm: drives stopped, references cleared", "DW 20||czas smarowania",
                                "T 0||", "T 5||", "C 0||", "C 63||"));
}

}  // namespace
}  // namespace plcxx::prostep
