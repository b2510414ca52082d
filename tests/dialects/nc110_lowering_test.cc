#include "tests/dialects/nc110_lowered.h"

namespace plcxx::nc110 {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Text = std::vector<std::string>;

// covers: NC110-048 NC110-063 NC110-064 NC110-069 NC110-073 NC110-075 NC110-076
TEST(Nc110Lowering, SignalsAreBitsOfOneMemory) {
  EXPECT_THAT(SlowBody("U4A8=I0A7+U4A8*/I4A8"),
              ElementsAre("stmt U4A8", "%0 = load I0A7", "%1 = load U4A8", "%2 = load I4A8", "%3 = not.bit %2",
                          "%4 = and.bit %1 %3", "%5 = or.bit %0 %4", "store U4A8 %5"));
  EXPECT_THAT(SlowBody("/U4A8=1"), ElementsAre("stmt U4A8", "%0 = const bit 1", "%1 = not.bit %0", "store U4A8 %1"));
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A8=I4A8"});
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("place U4A8 bit A[17].0\n"));
  EXPECT_THAT(text, HasSubstr("place I4A8 bit A[17].0\n"));
}

// covers: NC110-049 NC110-052 NC110-053
TEST(Nc110Lowering, BytesAndBitsOfThePackages) {
  LoweredProgram lowered;
  LowerInto(lowered, {"W0A3=W15T3 U10K9=I0A31 U255N31=0"}, {{"t-init", "01=F4,64=0A"}});
  const std::string text = ir::Print(lowered.program());
  for (const char* line :
       {"place W0A3 i8 A[3]\n", "place W15T3 i8 T[63]\n", "place U10K9 bit K[41].1\n", "place I0A31 bit A[3].7\n",
        "place U255N31 bit N[1023].7\n", "initial T 0 0xf4\n", "initial T 63 0xa\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

// covers: NC110-077 NC110-078 NC110-080 NC110-081 NC110-084 NC110-110 NC110-111 NC110-116 NC110-117 NC110-106
TEST(Nc110Lowering, WordsFunctionsAndArithmetic) {
  EXPECT_THAT(
      SlowBody("W12K0=/ENC(W1K0+W2K0)*[W3K0-ABS(W4K0)+0FFH]"),
      ElementsAre("stmt W12K0", "%0 = load W1K0", "%1 = load W2K0", "%2 = or.i8 %0 %1", "%3 = highest_bit.i8 %2",
                  "%4 = not.i8 %3", "%5 = load W3K0", "%6 = load W4K0", "%7 = abs.i8 %6", "%8 = sub.i8 %5 %7",
                  "%9 = const i8 0xff", "%10 = add.i8 %8 %9", "%11 = and.i8 %4 %10", "store W12K0 %11"));
  const std::pair<const char*, const char*> functions[] = {{"DEC", "one_hot.i8"},    {"BCD", "to_bcd.i8"},
                                                           {"BIN", "from_bcd.i8"},   {"HIG", "high_nibble.i8"},
                                                           {"LOW", "low_nibble.i8"}, {"XCH", "swap_nibbles.i8"}};
  for (const auto& [name, op] : functions) {
    EXPECT_THAT(SlowBody("W12K0=" + std::string(name) + "(W1K0)"),
                ElementsAre("stmt W12K0", "%0 = load W1K0", "%1 = " + std::string(op) + " %0", "store W12K0 %1"));
  }
  EXPECT_THAT(SlowBody("W12K0=W1K0&7"), Contains("%2 = xor.i8 %0 %1"));
}

// covers: NC110-089 NC110-091 NC110-092 NC110-112 NC110-113
TEST(Nc110Lowering, ComparatorsAndSign) {
  EXPECT_THAT(SlowBody("U4A0=/[W3K0=33H]*[5<W1K0]+SGN[W1K0-W2K0]"),
              ElementsAre("stmt U4A0", "%0 = load W3K0", "%1 = const i8 0x33", "%2 = eq.i8 %0 %1", "%3 = not.bit %2",
                          "%4 = const i8 5", "%5 = load W1K0", "%6 = ult.i8 %4 %5", "%7 = and.bit %3 %6",
                          "%8 = load W1K0", "%9 = load W2K0", "%10 = sub.i8 %8 %9", "%11 = sign_bit.i8 %10",
                          "%12 = or.bit %7 %11", "store U4A0 %12"));
  EXPECT_THAT(SlowBody("U4A0=[W1K0>C5W]"), Contains("%2 = ugt.i8 %0 %1"));
}

// covers: NC110-120 NC110-121 NC110-122 NC110-124 NC110-125
TEST(Nc110Lowering, MuxWritesTheFirstSelectedWord) {
  EXPECT_THAT(SlowBody("C5W=MUX(W1K0,C5W),(I0A1,/I0A2)"),
              ElementsAre("stmt C5", "%0 = load I0A1", "if %0 {", "%1 = load W1K0", "store C5W %1", "} else {",
                          "%2 = load I0A2", "%3 = not.bit %2", "if %3 {", "%4 = load C5W", "store C5W %4", "}", "}"));
}

// covers: NC110-183 NC110-185 NC110-186 NC110-187 NC110-201 NC110-202
TEST(Nc110Lowering, ChainsAreNestedInTheirElseArms) {
  EXPECT_THAT(SlowBody("DOF A: I0A1 U4A1=1 ENDF A DOE: I0A2 DOF: I0A3 ENDF ENDE DOE:\nU4A2=1 ENDE U4A3=1"),
              ElementsAre("stmt A", "%0 = load I0A1", "if %0 {", "stmt U4A1", "%0 = const bit 1", "store U4A1 %0",
                          "stmt", "} else {", "stmt block", "%0 = load I0A2", "if %0 {", "stmt block", "%0 = load I0A3",
                          "if %0 {", "stmt", "}", "stmt", "} else {", "stmt block", "%0 = const bit 1", "if %0 {",
                          "stmt U4A2", "%0 = const bit 1", "store U4A2 %0", "stmt", "}", "}", "}", "stmt U4A3",
                          "%0 = const bit 1", "store U4A3 %0"));
  LoweredProgram lowered;
  LowerInto(lowered, {"DOF: I0A1 ENDF"});
  ASSERT_EQ(lowered.program().statements.size(), 2u);
  EXPECT_TRUE(lowered.program().statements[ir::StatementId(0)].opens_block);
  EXPECT_TRUE(lowered.program().statements[ir::StatementId(1)].closes_block);
}

// covers: NC110-203 NC110-220
TEST(Nc110Lowering, DowIsALoopOfAtMost255Rounds) {
  const Text body = SlowBody("DOW: [C5W<3] C5W=[C5W+1] ENDW", {{"enable-dow", "on"}});
  EXPECT_THAT(body, Contains(HasSubstr("255")));
  EXPECT_THAT(body, Contains(HasSubstr("host fault")));
  EXPECT_THAT(body, Contains("store C5W %2"));
}

// covers: NC110-133 NC110-134 NC110-136 NC110-137 NC110-138 NC110-146 NC110-147 NC110-153
TEST(Nc110Lowering, TimersTakeTheirDelayInMilliseconds) {
  EXPECT_THAT(SlowBody("T5I(30)=T5A"), ElementsAre("stmt T5", "%0 = load T5A", "%1 = const i32 3000", "%2 = load now",
                                                   "step.on_delay T5 %0 %1 %2"));
  EXPECT_THAT(SlowBody("T48I(255)=1"), Contains("%1 = const i32 2550"));
  EXPECT_THAT(SlowBody("T63I(1)=1"), Contains("%1 = const i32 10"));
  EXPECT_THAT(SlowBody("T64I(1)=1"), Contains("%1 = const i32 100"));
  EXPECT_THAT(SlowBody("T254I(W30K3)=I0A1"),
              ElementsAre("stmt T254", "%0 = load I0A1", "%1 = load W30K3", "%2 = load W31K0", "%3 = pair.i16 %1 %2",
                          "%4 = zext.i16.i32 %3", "%5 = const i32 20", "%6 = mul.i32 %4 %5", "%7 = load now",
                          "step.on_delay T254 %0 %6 %7"));
  EXPECT_THAT(SlowBody("T50I(W0T0)=1", {{"tim", "8"}}), Contains("%5 = const i32 8"));
  EXPECT_THAT(SlowBody("T50I(W0T0)=1", {{"tim", "1"}}), Not(Contains(HasSubstr("mul"))));
  EXPECT_THAT(SlowBody("T5A=T5I+T5U+T5D"), Contains("store T5A %4"));
}

// covers: NC110-157 NC110-161 NC110-162 NC110-166 NC110-167 NC110-168 NC110-174 NC110-246
TEST(Nc110Lowering, CountersStampTheirCarry) {
  EXPECT_THAT(SlowBody("C5I(3)=C5R"), ElementsAre("stmt C5", "%0 = load C5R", "%1 = const i16 3",
                                                  "%2 = load slow_cycle", "%3 = step.count_slow C5 %0 %1 %2"));
  EXPECT_THAT(SlowBody("C5I(W30K0)=I0A1"),
              ElementsAre("stmt C5", "%0 = load I0A1", "%1 = load W30K0", "%2 = load W30K1", "%3 = pair.i16 %1 %2",
                          "%4 = load slow_cycle", "%5 = step.count_slow C5 %0 %3 %4", "%6 = not.bit %5", "if %6 {",
                          "%7 = const i32 5", "%8 = const i8 0", "host fault (%8, %7)", "}"));
  EXPECT_THAT(SlowBody("C5I(3)=1", {{"carry", "input"}}), Contains("%2 = step.count_carry_while_input C5 %0 %1"));
  EXPECT_THAT(SlowBody("C5I(3)=1", {{"carry", "next"}}), Contains("%2 = step.count_carry_until_next C5 %0 %1"));
  EXPECT_THAT(SlowBody("C5Z=C5I"), Contains("step.reset_counter C5 %0"));
  EXPECT_THAT(SlowBody("C5A=C5Z"), Contains("store C5A %0"));
  LoweredProgram fast;
  LowerInto(fast, {"C5I(3)=I0A1"});
  EXPECT_THAT(fast.Routine("fast"),
              ElementsAre("prologue {", "%0 = load fast_count", "%1 = const i32 1", "%2 = add.i32 %0 %1",
                          "store fast_count %2", "}", "body {", "stmt C5", "%0 = load I0A1", "%1 = const i16 3",
                          "%2 = load fast_count", "%3 = step.count_fast C5 %0 %1 %2", "}", "epilogue {",
                          "%0 = load fast_count", "step.expire_counter_fast C5 %0", "}", "}"));
}

// covers: NC110-176 NC110-180 NC110-181 NC110-248
TEST(Nc110Lowering, OneShotsExpireInTheirOwnPart) {
  LoweredProgram lowered;
  LowerInto(lowered, {"P1=I0A1 $\nP1=I0A2 P2=P1"});
  EXPECT_THAT(lowered.Routine("fast"), ElementsAre("body {", "stmt P1", "%0 = load I0A1", "%1 = load slow_done",
                                                   "%2 = const i8 0", "step.pulse_fast P1 %0 %1 %2", "}", "epilogue {",
                                                   "%0 = load slow_done", "step.expire_pulse_fast P1 %0", "}", "}"));
  EXPECT_THAT(
      lowered.Routine("slow"),
      ElementsAre("prologue {", "%0 = load slow_cycle", "%1 = const i32 1", "%2 = add.i32 %0 %1", "store slow_cycle %2",
                  "}", "body {", "stmt P1", "%0 = load I0A2", "%1 = load slow_cycle", "step.pulse_slow P1 %0 %1",
                  "stmt P2", "%0 = load P1", "%1 = load slow_cycle", "step.pulse_slow P2 %0 %1", "}", "epilogue {",
                  "%0 = load slow_done", "%1 = const i32 1", "%2 = add.i32 %0 %1", "store slow_done %2",
                  "%3 = load slow_cycle", "step.expire_pulse_slow P1 %3", "%4 = load slow_cycle",
                  "step.expire_pulse_slow P2 %4", "}", "}"));
}

// covers: NC110-099 NC110-100 NC110-102 NC110-104
TEST(Nc110Lowering, AsciiLiteralsShareOneFlag) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=\"GO\" $\nU4A1=\"GO\"+\"go 1\""});
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("state operator_text text_inbox\n"));
  EXPECT_THAT(text, HasSubstr("place TEXT_GO bit field TEXT_GO flag\n"));
  EXPECT_THAT(lowered.Routine("slow"), Contains("text.update TEXT_GO operator_text \"GO\""));
  EXPECT_THAT(lowered.Routine("slow"), Contains("step.clear_text operator_text"));
  EXPECT_EQ(lowered.program().texts.size(), 2u);
}

// covers: NC110-099
TEST(Nc110Lowering, TextsThatDifferInWhatNoNameCanHoldHaveNamesOfTheirOwn) {
  const auto names = [](const std::string& statements) {
    LoweredProgram lowered;
    LowerInto(lowered, {"$\n" + statements});
    Text found;
    for (const ir::StateInstance& state : lowered.program().states) found.push_back(state.name);
    return found;
  };
  const Text both = names("U4A0=\"A-B\" U4A1=\"A B\"");
  ASSERT_EQ(both.size(), 3u);
  EXPECT_THAT(both[1], testing::StartsWith("TEXT_A_B_"));
  EXPECT_THAT(both[2], testing::StartsWith("TEXT_A_B_"));
  EXPECT_NE(both[1], both[2]);
  EXPECT_EQ(names("U4A1=\"A B\"").back(), both[2]) << "a text that is added renames no other one's flag";
  EXPECT_EQ(names("U4A1=\"AzZ09\"").back(), "TEXT_AzZ09");
}

// covers: NC110-035 NC110-042
TEST(Nc110Lowering, SymbolsNameTheirPlaces) {
  LoweredProgram lowered;
  LowerInto(lowered, {"*\nPUMP=U04A08\nPUMP2=U4A8\nLIMIT=W1T0\nRUNS=T5U\n", "!PUMP2=[!LIMIT>3]*I4A8*!RUNS"});
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("place PUMP bit A[17].0 address U4A8\n"));
  EXPECT_THAT(text, Not(HasSubstr("address I4A8")));  // the symbol's own place serves both spellings
  EXPECT_THAT(text, HasSubstr("place LIMIT i8 T[4] address W1T0\n"));
  EXPECT_THAT(text, HasSubstr("place RUNS bit field T5 done address T5U\n"));
}

TEST(Nc110Lowering, CommentsStandWithTheirStatements) {
  LoweredProgram lowered;
  LowerInto(lowered, {"; head of the file\n\n; above\nU4A0=1 ; behind\n$ slow logic\nU4A1=1\n"});
  const auto& statements = lowered.program().statements;
  ASSERT_EQ(statements.size(), 2u);
  const auto comments = [&](uint32_t index) {
    Text texts;
    for (const source::Range& range : statements[ir::StatementId(index)].comments) {
      texts.emplace_back(lowered.sources.Text(range));
    }
    return texts;
  };
  EXPECT_THAT(comments(0), ElementsAre(" head of the file", " above", " behind"));
  EXPECT_THAT(comments(1), ElementsAre(HasSubstr("slow logic")));
}

TEST(Nc110Lowering, CommentsAtTheEndOfAFileStandInFrontOfTheNextOne) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=1\n; end of the first\n", "; head of the second\nU4A1=1\n"});
  const auto& statements = lowered.program().statements;
  ASSERT_EQ(statements.size(), 2u);
  Text texts;
  for (const source::Range& range : statements[ir::StatementId(1)].comments) {
    texts.emplace_back(lowered.sources.Text(range));
  }
  EXPECT_THAT(texts, ElementsAre(" end of the first", " head of the second"));
}

TEST(Nc110Lowering, NumbersOfStatementsComeFromTheirText) {
  LoweredProgram one, two;
  LowerInto(one, {"U4A0=I0A1 U4A1=I0A2 U4A1=I0A2"});
  LowerInto(two, {"U9A9=1\nU4A0 =; a comment\n\tI0A1\r\nU4A1=;one more\r\n\fI0A2\nU4A1=I0A2"});
  const auto id = [](const LoweredProgram& lowered, uint32_t index) {
    return lowered.program().statements[ir::StatementId(index)].id;
  };
  EXPECT_EQ(id(one, 0), id(two, 1));
  EXPECT_EQ(id(one, 1), id(two, 2));
  EXPECT_EQ(id(one, 2), id(two, 3));
  EXPECT_NE(id(one, 1), id(one, 2));
}

// covers: NC110-204 NC110-206 NC110-207
TEST(Nc110Lowering, TheFirstCycleMarkParts) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=1 $\nU4A1=1 $\n", "U4A2=1"});
  EXPECT_THAT(lowered.Routine("fast"), ElementsAre("stmt U4A0", "%0 = const bit 1", "store U4A0 %0", "}"));
  EXPECT_THAT(lowered.Routine("slow"), Contains("stmt U4A1"));
  EXPECT_THAT(lowered.Routine("slow"), Contains("stmt U4A2"));
}

}  // namespace
}  // namespace plcxx::nc110
