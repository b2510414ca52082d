// What the instructions of a module become.

#include "tests/dialects/prostep_lowered.h"

namespace plcxx::prostep {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

// covers: PS-050, PS-052, PS-090
TEST(ProstepLowering, ASequenceIsOneExpression) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:O I 0.1\n:AN I 0.2\n:= O 0.7\n"),
              ElementsAre("stmt O0_7", "%0 = load I0_0", "%1 = load I0_1", "%2 = or.bit %0 %1", "%3 = load I0_2",
                          "%4 = not.bit %3", "%5 = and.bit %2 %4", "store O0_7 %5", "store s %5"));
}

// covers: PS-053, PS-055, PS-065
TEST(ProstepLowering, OperandlessOJoinsStrings) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:O\n:A I 0.1\n:A I 0.2\n:O I 0.3\n:= O 0.7\n"),
              ElementsAre("stmt O0_7", "%0 = load I0_0", "%1 = load I0_1", "%2 = load I0_2", "%3 = and.bit %1 %2",
                          "%4 = load I0_3", "%5 = or.bit %0 %3", "%6 = or.bit %5 %4", "store O0_7 %6", "store s %6"));
}

// covers: PS-056, PS-058, PS-059
TEST(ProstepLowering, BracketsAndComparisons) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:O(\n:L DW 20\n:>\n: K 8\n:)\n:= O 0.7\n"),
              ElementsAre("stmt O0_7", "%0 = load I0_0", "%1 = load DW20", "%2 = const i16 8", "%3 = sgt.i16 %1 %2",
                          "%4 = or.bit %0 %3", "store O0_7 %4", "store s %4", "store ax %1"));
}

// covers: PS-070, PS-071, PS-083
TEST(ProstepLowering, SettingInstructionsShareAStatement) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:= O 0.0\n:S F 1.0\n:R F 1.1\n:A I 0.1\n:= O 0.1\n"),
              ElementsAre("stmt O0_0", "%0 = load I0_0", "store O0_0 %0", "%1 = load F1_0", "%2 = or.bit %1 %0",
                          "store F1_0 %2", "%3 = load F1_1", "%4 = not.bit %0", "%5 = and.bit %3 %4", "store F1_1 %5",
                          "store s %0", "stmt O0_1", "%0 = load I0_1", "store O0_1 %0", "store s %0"));
}

// covers: PS-160, PS-161
TEST(ProstepLowering, ALoadAndItsTransfersAreOneStatement) {
  EXPECT_THAT(LoopModule(":L FB 5\n:T FB 6\n:T FW 8\n"), ElementsAre("stmt FB6", "%0 = load FB5", "%1 = zext.i8.i16 %0",
                                                                     "store FB6 %0", "store FW8 %1", "store ax %1"));
  // Behind a word the high byte stays.
  EXPECT_THAT(LoopModule(":L FW 2\n:L FB 5\n:T FW 8\n"),
              ElementsAre("stmt FW8", "%0 = load FW2", "%1 = load FB5", "%2 = with_low_byte.i16 %0 %1", "store FW8 %2",
                          "store ax %2"));
}

// covers: PS-082, PS-089
TEST(ProstepLowering, BehindAnUntakenJumpSIs0) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:JC DALEJ\n:O I 0.1\n:= O 0.0\nDALEJ :\n"),
              ElementsAre("stmt PM9", "%0 = load I0_0", "store s %0", "jump L0 if %0", "stmt O0_0", "%0 = load I0_1",
                          "%1 = const bit 0", "%2 = or.bit %1 %0", "store O0_0 %2", "store s %2", "label L0"));
}

// covers: PS-084, PS-086
TEST(ProstepLowering, RegistersSurviveLabelsInTheirPlaces) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:JC X\n:A I 0.1\nX :O I 0.2\n:= O 0.0\n"),
              ElementsAre("stmt PM9", "%0 = load I0_0", "store s %0", "jump L4 if %0", "stmt PM9", "%0 = load I0_1",
                          "%1 = const bit 0", "%2 = and.bit %1 %0", "store s %2", "label L4", "stmt O0_0",
                          "%0 = load I0_2", "%1 = load s", "%2 = or.bit %1 %0", "store O0_0 %2", "store s %2"));
}

// covers: PS-087
TEST(ProstepLowering, DynamicFirstCheck) {
  const std::vector<std::string> lines =
      LoopModule(":A I 0.0\n:JU X\n:A I 0.1\n:= O 0.1\nX :A I 0.2\n:= O 0.0\n", {{"first-check", "dynamic"}});
  EXPECT_THAT(lines, Contains("store first %1"));
  // S AND v, or v alone: (s or first) and v.
  EXPECT_THAT(lines, testing::IsSupersetOf({"%1 = load first", "%2 = load s", "%3 = or.bit %2 %1"}));
}

// covers: PS-171, PS-193
TEST(ProstepLowering, ABackwardJumpHasABudget) {
  EXPECT_THAT(LoopModule("PETLA :L FW 0\n:JU FM 13\n:T FW 0\n:<\n: K 10\n:JC PETLA\n"),
              ElementsAre("label L1", "stmt FM13", "%0 = load FW0", "%1 = const i16 1", "%2 = add.i16 %0 %1",
                          "store FW0 %2", "store ax %2", "stmt PM9", "%0 = load ax", "%1 = const i16 10",
                          "%2 = slt.i16 %0 %1", "store s %2", "jump L1 if %2 budget rounds_left refused {",
                          "%3 = const i8 4", "%4 = const i32 9", "host fault (%3, %4)", "jump L0", "}", "label L0"));
}

// covers: PS-100, PS-112, PS-113, PS-114
TEST(ProstepLowering, TimersGiveTheirOutput) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:SR T 5\n: K 1020D\n:= O 0.1\n:A T 5\n:R T 6\n:L T 5\n:T DW 0\n"),
              ElementsAre("stmt T5", "%0 = load I0_0", "%1 = const i16 0x1020", "%2 = step.start_on_delay T5 %0 %1",
                          "store O0_1 %2", "store s %2", "stmt T6", "%0 = load T5_out", "step.reset_timer T6 %0",
                          "store s %0", "stmt DW0", "%0 = step.time_left T5", "store DW0 %0", "store ax %0"));
}

// covers: PS-130, PS-134, PS-136, PS-137
TEST(ProstepLowering, Counters) {
  EXPECT_THAT(
      LoopModule(":A I 0.0\n:CU C 4\n:S C 4\n: DW 8\n:A C 4\n:= O 0.0\n:LD C 4\n:T DW 0\n", {{"counter-set", "edge"}}),
      ElementsAre("stmt C4", "%0 = load I0_0", "%1 = step.count_up C4 %0", "%2 = load DW8",
                  "step.set_counter_on_edge C4 %1 %2", "store s %1", "stmt O0_0", "%0 = load C4_count",
                  "%1 = const i16 0", "%2 = ne.i16 %0 %1", "store O0_0 %2", "store s %2", "stmt DW0",
                  "%0 = load C4_count", "%1 = to_bcd.i16 %0", "store DW0 %1", "store ax %1"));
}

// covers: PS-240, PS-241
TEST(ProstepLowering, DirectPortsGoThroughTheLatch) {
  EXPECT_THAT(LoopModule(":A P 3.1\n:= P 0.3\n:S P 0.4\n"),
              ElementsAre("stmt P0_3", "%0 = const i32 3", "%1 = host read_port (%0)", "%2 = const i8 1",
                          "%3 = test_bit.i8 %1 %2", "store P0_3 %3", "%4 = const i32 0", "%5 = load PB0",
                          "host write_port (%4, %5)", "if %3 {", "%6 = const bit 1", "store P0_4 %6",
                          "%7 = const i32 0", "%8 = load PB0", "host write_port (%7, %8)", "}", "store s %3"));
}

// covers: PS-164
TEST(ProstepLowering, ExtraCardsHaveNoLatch) {
  EXPECT_THAT(LoopModule(":L K 258\n:T PW 100\n"),
              ElementsAre("stmt PW100", "%0 = const i16 258", "%1 = low_byte.i16 %0", "%2 = const i32 100",
                          "host write_port (%2, %1)", "%3 = high_byte.i16 %0", "%4 = const i32 101",
                          "host write_port (%4, %3)", "store ax %0"));
}

// covers: PS-110, PS-111
TEST(ProstepLowering, APortGivesATimeOnlyAtTheStart) {
  EXPECT_THAT(
      LoopModule(":A I 0.0\n:SP T 1\n: PW 2\n"),
      ElementsAre("stmt T1", "%0 = load I0_0", "%1 = load T1_edge", "%2 = not.bit %1", "%3 = and.bit %0 %2",
                  "%4 = const i16 0", "store port_word %4", "if %3 {", "%5 = const i32 2", "%6 = host read_port (%5)",
                  "%7 = const i32 3", "%8 = host read_port (%7)", "%9 = pair.i16 %6 %8", "store port_word %9", "}",
                  "%10 = load port_word", "%11 = step.start_pulse T1 %0 %10", "store s %11"));
}

// covers: PS-200
TEST(ProstepLowering, AByteDestinationNeedsLowBytesOnly) {
  EXPECT_THAT(LoopModule(":JU FM 0\n: FB 1\n: DW 2\n: FB 3\n:JU FM 1\n: FB 1\n: K 2\n: DW 4\n"),
              ElementsAre("stmt FM0", "%0 = load FB1", "%1 = load DW2", "%2 = low_byte.i16 %1", "%3 = add.i8 %0 %2",
                          "store FB3 %3", "stmt FM1", "%0 = load FB1", "%1 = zext.i8.i16 %0", "%2 = const i16 2",
                          "%3 = sub.i16 %1 %2", "store DW4 %3"));
}

// covers: PS-202, PS-203
TEST(ProstepLowering, DivisionOfWords) {
  EXPECT_THAT(LoopModule(":JU FM 3\n: DB 8\n: K -3\n: DW 12\n"),
              ElementsAre("stmt FM3", "%0 = load DD8", "%1 = const i32 4294967293", "%2 = sdiv.i32 %0 %1",
                          "%3 = srem.i32 %0 %1", "%4 = const i32 4294934528", "%5 = slt.i32 %2 %4",
                          "%6 = const i32 32767", "%7 = sgt.i32 %2 %6", "%8 = or.bit %5 %7", "if %8 {",
                          "%9 = const i8 1", "%10 = const i32 9", "host fault (%9, %10)", "} else {",
                          "%11 = low_half.i32 %2", "store DW12 %11", "%12 = low_half.i32 %3", "store DW14 %12", "}"));
  EXPECT_THAT(LoopModule(":JU FM 3\n: DB 8\n: K 0\n: DW 12\n"),
              ElementsAre("stmt FM3", "%0 = load DD8", "%1 = const i32 0", "%2 = const i8 0", "%3 = const i32 9",
                          "host fault (%2, %3)"));
}

// covers: PS-204
TEST(ProstepLowering, ToBcdLeavesWhatDoesNotFit) {
  EXPECT_THAT(LoopModule(":L FW 0\n:JU FM 4\n:= O 0.0\n"),
              ElementsAre("stmt FM4", "%0 = load FW0", "%1 = const i16 9999", "%2 = ugt.i16 %0 %1", "store ax %0",
                          "%3 = not.bit %2", "if %3 {", "%4 = to_bcd.i16 %0", "store ax %4", "}", "store O0_0 %2",
                          "store s %2"));
}

// covers: PS-207
TEST(ProstepLowering, BytesActOnTheLowByte) {
  EXPECT_THAT(LoopModule(":L FW 0\n:JU FM 8\n: FB 2\n:JU FM 10\n: K 0FFH\n:T FW 4\n"),
              ElementsAre("stmt FM8", "%0 = load FW0", "%1 = load FB2", "%2 = low_byte.i16 %0", "%3 = and.i8 %2 %1",
                          "%4 = with_low_byte.i16 %0 %3", "%5 = const i16 0xff", "%6 = xor.i16 %4 %5", "store FW4 %6",
                          "store ax %6"));
}

// covers: PS-209, PS-211
TEST(ProstepLowering, IndirectAccess) {
  EXPECT_THAT(LoopModule(":JU FM 15\n: FB 10\n: K -3\n"),
              ElementsAre("stmt FM15", "%0 = load FB7", "%1 = zext.i8.i16 %0", "store ax %1"));
  EXPECT_THAT(LoopModule(":JU FM 16\n: FB 10\n: K 245\n"),
              ElementsAre("stmt FM16", "%0 = const bit 1", "%1 = const i16 0", "%2 = const i8 2", "%3 = const i32 9",
                          "host fault (%2, %3)", "store ax %1"));
  EXPECT_THAT(LoopModule(":JU FM 16\n: FB 10\n: FB 0\n"),
              ElementsAre("stmt FM16", "%0 = load FB0", "%1 = zext.i8.i32 %0", "%2 = const i32 10",
                          "%3 = add.i32 %1 %2", "%4 = const i32 254", "%5 = ugt.i32 %3 %4", "%6 = load FW0_any[%3]",
                          "if %5 {", "%7 = const i8 2", "%8 = const i32 9", "host fault (%7, %8)", "}", "store ax %6"));
}

// covers: PS-233
TEST(ProstepLowering, AnIndexIntoDataReachesAllItsParts) {
  EXPECT_THAT(LoopModule(":JU FM 17\n: DB 0\n: FB 0\n"),
              ElementsAre("stmt FM17", "%0 = load FB0", "%1 = zext.i8.i32 %0", "%2 = const i16 0", "%3 = const i8 0",
                          "store DB_from_0[%1] %3", "%4 = const i32 4294966796", "%5 = add.i32 %1 %4",
                          "store DB_from_500[%5] %3"));
}

// covers: PS-212
TEST(ProstepLowering, VariablesOfTheNc) {
  EXPECT_THAT(LoopModule(":JU FM 42\n: K 20\n: K 1\n: DB 4\n"),
              ElementsAre("stmt FM42", "%0 = const i16 20", "%1 = const i16 1", "%2 = const i32 2",
                          "%3 = host nc_read (%2, %0, %1) out nc_value", "if %3 {", "%4 = load nc_value",
                          "%5 = low_half.i32 %4", "store DW4 %5", "} else {", "%6 = const i8 3", "%7 = const i32 9",
                          "host fault (%6, %7)", "}"));
}

// covers: PS-214, PS-215, PS-228
TEST(ProstepLowering, DoubleWordsTellOfTheirResultInS) {
  EXPECT_THAT(LoopModule(":JU FM 62\n: DB 0\n: DB 4\n: DB 2\n:= O 0.0\n"),
              ElementsAre("stmt FM62", "%0 = load DD0", "%1 = sext.i32.i64 %0", "%2 = load DD4", "%3 = sext.i32.i64 %2",
                          "%4 = mul.i64 %1 %3", "%5 = low_half.i64 %4", "store DD2 %5", "%6 = high_half.i64 %4",
                          "store DD6 %6", "%7 = is_zero.i64 %4", "store O0_0 %7", "store s %7"));
}

// covers: PS-224
TEST(ProstepLowering, AConstantDisablesDoubleWords) {
  EXPECT_THAT(LoopModule(":JU FM 60\n: DB 0\n: K 4\n: DB 8\n:= O 0.0\n"),
              ElementsAre("stmt FM60", "%0 = const bit 1", "store O0_0 %0", "store s %0"));
}

// covers: PS-225
TEST(ProstepLowering, AConditionalFunctionGoesThroughThePlaces) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:JC FM 80\n: DB 0\n: DB 4\n:= O 0.0\n"),
              ElementsAre("stmt FM80", "%0 = load I0_0", "%1 = const i16 0", "store s %0", "if %0 {", "%2 = load DD0",
                          "%3 = load DD4", "%4 = eq.i32 %2 %3", "store s %4", "}", "%5 = load s", "store O0_0 %5"));
}

// covers: PS-173
TEST(ProstepLowering, ACallSharesSAndAx) {
  LoweredProgram lowered;
  LowerInto(lowered, ":MOD PM 9\n:A I 0.0\n:JC PM 20\n:= O 0.0\n:END PM 9\n:MOD PM 20\n:= O 0.1\n:END PM 20\n");
  EXPECT_THAT(lowered.Routine("PM9"), ElementsAre("%0 = const bit 0", "%1 = const i16 0", "store s %0", "store ax %1",
                                                  "stmt PM20", "%0 = load I0_0", "store s %0", "if %0 {",
                                                  "call PM20 ()", "}", "%1 = load s", "store O0_0 %1"));
  EXPECT_THAT(lowered.Routine("PM20"), ElementsAre("stmt O0_1", "%0 = load s", "store O0_1 %0"));
}

// covers: PS-177, PS-178, PS-179
TEST(ProstepLowering, LeavingAModule) {
  EXPECT_THAT(LoopModule(":A I 0.0\n:EMC\n:A I 0.1\n:= O 0.0\n:EM\n"),
              ElementsAre("stmt PM9", "%0 = load I0_0", "store s %0", "jump L0 if %0", "stmt O0_0", "%0 = load I0_1",
                          "store O0_0 %0", "store s %0", "stmt PM9", "label L0"));
}

TEST(ProstepLowering, AWordAcrossTheRetentiveBorder) {
  EXPECT_THAT(
      LoopModule(":L DW 499\n:T DW 99\n", {{"retentive", "100-499"}}),
      ElementsAre("stmt DW99", "%0 = load DB499", "%1 = load DB500", "%2 = pair.i16 %0 %1", "%3 = low_byte.i16 %2",
                  "store DB99 %3", "%4 = high_byte.i16 %2", "store DB100 %4", "store ax %2"));
}

TEST(ProstepLowering, NoStatementHasTheNumber0) {
  // The hash of a statement's text is its number; that of the second one is 0.
  LoweredProgram lowered;
  LowerInto(lowered, ":MOD PM 9\n:A F 0.1\n:= F 0.2\n:A F 19.5\n:A F 39.1\n:A F 38.4\n:= F 9.1\n:END PM 9\n");
  std::vector<uint32_t> numbers;
  for (const ir::Statement& statement : lowered.program().statements) numbers.push_back(statement.id);
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_EQ(numbers[0], 0x6611F5DEu);  // FNV-1a of its words with an end after each
  EXPECT_NE(numbers[1], 0u);
}

TEST(ProstepLowering, StatementsShowTheirLines) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "; glowa\n\n:MOD PM 9   modul\n; zawor\nX  :A I 0.0   otwarty\n; w srodku\n   := O 0.0\n:A I 0.1\n:= F "
            "0.1\n; koniec\n:END PM "
            "9 ; gotowe\n:MOD PM 1\n:JU PM 20\n:END PM 1\n:MOD PM 20\n:END PM 20\n; wszystko\n; razem\n");
  const auto text = [&](uint32_t statement) {
    return std::string(lowered.sources.Text(lowered.program().statements[ir::StatementId(statement)].range));
  };
  const auto comments = [&](uint32_t statement) {
    std::vector<std::string> result;
    for (const source::Range& range : lowered.program().statements[ir::StatementId(statement)].comments) {
      result.emplace_back(lowered.sources.Text(range));
    }
    return result;
  };
  EXPECT_EQ(text(0), "X  :A I 0.0   otwarty\n; w srodku\n   := O 0.0");
  EXPECT_THAT(comments(0), ElementsAre("; glowa", ":MOD PM 9   modul", "; zawor"));
  EXPECT_EQ(text(1), ":A I 0.1\n:= F 0.1");
  EXPECT_EQ(text(2), "");
  EXPECT_THAT(comments(2), ElementsAre("; koniec", "; gotowe"));
  const auto last = static_cast<uint32_t>(lowered.program().statements.size()) - 1;
  EXPECT_THAT(comments(last), ElementsAre(":MOD PM 20", "; wszystko", "; razem"));
}

}  // namespace
}  // namespace plcxx::prostep
