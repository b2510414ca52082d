// The tick, power-on, alarms, and the slow part in slices (specification 4.3, 8, 9).

#include "host50_lowered.h"

namespace plcxx::host50 {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

// covers: HOST50-028..030
TEST(Host50Schedule, ATick) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOWDIV 100\n" + Slow("LD %I0\nOUT %Q0\n")});
  EXPECT_THAT(
      lowered.Routine("period"),
      ElementsAre("host read_inputs ()", "call fast ()", "%0 = load tick", "%1 = const i32 99", "%2 = eq.i32 %0 %1",
                  "if %2 {", "call slow ()", "%3 = load slow_done", "%4 = const i32 1", "%5 = add.i32 %3 %4",
                  "store slow_done %5", "%6 = const i32 0", "store tick %6", "} else {", "%7 = load tick",
                  "%8 = const i32 1", "%9 = add.i32 %7 %8", "store tick %9", "}", "host write_outputs ()"));
  EXPECT_EQ(lowered.program.schedule.period_ms, 1u);
  EXPECT_TRUE(lowered.program.schedule.retention);
}

// covers: HOST50-027
TEST(Host50Schedule, EveryTickIsASlowOne) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOWDIV 1\n" + Slow("LD %I0\nOUT %Q0\n")});
  EXPECT_THAT(lowered.Routine("period"),
              ElementsAre("host read_inputs ()", "call fast ()", "call slow ()", "%0 = load slow_done",
                          "%1 = const i32 1", "%2 = add.i32 %0 %1", "store slow_done %2", "host write_outputs ()"));
}

// covers: HOST50-032 HOST50-096 HOST50-097
TEST(Host50Schedule, PowerOnPresetsEdgesBehindTheInputs) {
  const std::string program =
      "SLOW\nNETWORK\nLD %I0\nANDP %I1\nOUT %Q0\nEND_SLOW\n"
      "SUB SR1\nNETWORK\nLDF %B7\nOUT %Q1\nEND_SUB\n";
  LoweredProgram image, off;
  LowerInto(image, {program});
  EXPECT_THAT(image.Routine("init"),
              ElementsAre("host retentive_load ()", "host read_inputs ()", "%0 = load I1",
                          "step.preset_edge I1_edge %0", "%1 = load B7", "step.preset_edge B7_edge %1"));
  LowerInto(off, {program}, {{"EDGEINIT", "OFF"}});
  EXPECT_THAT(off.Routine("init"), ElementsAre("host retentive_load ()", "host read_inputs ()"));
}

// covers: HOST50-218 HOST50-232
TEST(Host50Schedule, AlarmsThatTheProgramDrives) {
  LoweredProgram lowered;
  LowerInto(lowered, {"ALARMS\n%Q405 WARNING \"five\"\n%Q403 CAUTION \"three\"\nEND_ALARMS\n" +
                      Slow("LD %I0\nOUT %Q404\nOUT %B406\nWTOB %W0, %Q402, 2\n")});
  const Text period = lowered.Routine("period");
  EXPECT_THAT(period, IsSupersetOf({"%10 = load Q402", "%11 = load Q402_was", "%12 = xor.bit %10 %11", "if %12 {",
                                    "%13 = const i32 2", "%14 = load Q402", "host alarm (%13, %14)", "%15 = load Q402",
                                    "store Q402_was %15"}));
  EXPECT_THAT(period, Contains("%16 = load Q403"));
  EXPECT_THAT(period, Contains("%22 = load Q404"));
  EXPECT_THAT(period, Not(Contains(HasSubstr("Q405"))));
  EXPECT_THAT(period, Not(Contains(HasSubstr("Q406"))));  // a bit that has an alarm's number is none
  EXPECT_THAT(lowered.Printed(), HasSubstr("message 3 colour 1 \"three\"\nmessage 5 colour 2 \"five\"\n"));
  EXPECT_THAT(lowered.Printed(), HasSubstr("message_bits Q 50 first 0 count 100\n"));
}

const std::string kFour =
    "SLOWDIV 2\nOPTION SLICES=SLICED\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nNETWORK\nLD %I0\nOUT %Q1\nNETWORK\nLD %I0\n"
    "OUT %Q2\nNETWORK\nLD %I0\nOUT %Q3\nEND_SLOW\n";

// covers: HOST50-034
TEST(Host50Schedule, SlicesAreAChoice) {
  LoweredProgram lowered;
  LowerInto(lowered, {kFour});
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("%0 = load slice", "switch %0 {", "case 0 {", "stmt Q0", "%0 = load I0", "store Q0 %0",
                          "stmt Q1", "%0 = load I0", "store Q1 %0", "}", "case 1 {", "stmt Q2", "%0 = load I0",
                          "store Q2 %0", "stmt Q3", "%0 = load I0", "store Q3 %0", "}", "}"));
  EXPECT_THAT(lowered.Routine("period"), IsSupersetOf({"%0 = load tick", "call slow (%0)"}));
}

// covers: HOST50-034
TEST(Host50Schedule, JumpsInsideASliceStayInTheChoice) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOWDIV 2\nOPTION SLICES=SLICED\nSLOW\nNETWORK\nLD %I0\nLBL J1\nNETWORK\nLD %I0\nOUT %Q1\n"
                      "NETWORK\nLD %I0\nOUT %Q2\nNETWORK\nLD %I0\nOUT %Q3\nEND_SLOW\n"});
  EXPECT_THAT(lowered.Routine("slow"), IsSupersetOf({"switch %0 {", "jump L1 if %0", "label L1"}));
}

// covers: HOST50-042
TEST(Host50Schedule, JumpsAcrossSlicesNeedACursor) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOWDIV 2\nOPTION SLICES=SLICED\nSLOW\nNETWORK\nLD %I0\nLBL J3\nNETWORK\nLD %I0\nOUT %Q1\n"
                      "NETWORK\nLD %I0\nOUT %Q2\nNETWORK\nLD %I0\nOUT %Q3\nEND_SLOW\n"});
  EXPECT_THAT(
      lowered.Routine("slow"),
      ElementsAre("%0 = load slice", "%1 = const i32 0", "%2 = eq.i32 %0 %1", "if %2 {", "%3 = const i32 0",
                  "store next_network %3", "}", "%4 = load next_network", "%5 = const i32 4", "store next_network %5",
                  "%6 = const i32 2", "%7 = eq.i32 %4 %6", "jump L2 if %7", "%8 = const i32 3", "%9 = eq.i32 %4 %8",
                  "jump L3 if %9", "%10 = eq.i32 %4 %5", "jump L4 if %10", "stmt LBL", "%0 = load I0", "jump L3 if %0",
                  "stmt Q1", "%0 = load I0", "store Q1 %0", "label L2", "stmt", "%0 = load slice", "%1 = const i32 1",
                  "%2 = ult.i32 %0 %1", "if %2 {", "%3 = const i32 2", "store next_network %3", "jump L4", "}",
                  "stmt Q2", "%0 = load I0", "store Q2 %0", "label L3", "stmt", "%0 = load slice", "%1 = const i32 1",
                  "%2 = ult.i32 %0 %1", "if %2 {", "%3 = const i32 3", "store next_network %3", "jump L4", "}",
                  "stmt Q3", "%0 = load I0", "store Q3 %0", "label L4"));
}

}  // namespace
}  // namespace plcxx::host50
