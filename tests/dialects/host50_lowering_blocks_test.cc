// Blocks: arithmetic, conversions, fields of bits, comparisons, expressions, timers, counters, ROT, axes, calls and
// jumps (specification 6.3 to 6.8, 7).

#include "host50_lowered.h"

namespace plcxx::host50 {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::ElementsAreArray;

/// The block of `LD 1` and one instruction, without its statement and the constant of LD.
Text Block(const std::string& instruction, const OptionMap& options = {}) {
  Text body = SlowBody("LD 1;" + instruction, options);
  if (body.size() >= 2) body.erase(body.begin(), body.begin() + 2);
  return body;
}

// covers: HOST50-110..118
TEST(Host50Blocks, IntegerArithmetic) {
  const std::pair<std::string, std::string> rows[] = {
      {"ADDW", "add.i32"}, {"SUBW", "sub.i32"}, {"MULW", "mul.i32"}, {"DIVW", "sdiv_or_dividend.i32"},
      {"WAND", "and.i32"}, {"WOR", "or.i32"},   {"WXOR", "xor.i32"}};
  for (const auto& [block, op] : rows) {
    EXPECT_THAT(Block(block + " %W1, %IW2, %QW3"),
                ElementsAre("%1 = load W1", "%2 = load IW2", "%3 = " + op + " %1 %2", "store QW3 %3"));
  }
  EXPECT_THAT(Block("WAND %W1, $FF, %W1"),
              ElementsAre("%1 = load W1", "%2 = const i32 0xff", "%3 = and.i32 %1 %2", "store W1 %3"));
}

// covers: HOST50-121..124
TEST(Host50Blocks, FloatArithmetic) {
  const std::pair<std::string, std::string> rows[] = {
      {"ADDF", "add.f32"}, {"SUBF", "sub.f32"}, {"MULF", "mul.f32"}, {"DIVF", "div_or_dividend.f32"}};
  for (const auto& [block, op] : rows) {
    EXPECT_THAT(Block(block + " %F1, %IF2, %QF3"),
                ElementsAre("%1 = load F1", "%2 = load IF2", "%3 = " + op + " %1 %2", "store QF3 %3"));
  }
}

// covers: HOST50-119 HOST50-120
TEST(Host50Blocks, Negation) {
  EXPECT_THAT(Block("NEG %W1"), ElementsAre("%1 = load W1", "%2 = const i32 0", "%3 = sub.i32 %2 %1", "store W1 %3"));
  EXPECT_THAT(Block("NEG %F1"), ElementsAre("%1 = load F1", "%2 = neg.f32 %1", "store F1 %2"));
}

// covers: HOST50-125..131
TEST(Host50Blocks, Conversions) {
  EXPECT_THAT(Block("MOV %W1, %W2"), ElementsAre("%1 = load W1", "store W2 %1"));
  EXPECT_THAT(Block("MOV %W1, %F2"), ElementsAre("%1 = load W1", "%2 = sint_to_f32 %1", "store F2 %2"));
  EXPECT_THAT(Block("MOV %F1, %W2"), ElementsAre("%1 = load F1", "%2 = f32_to_sint %1", "store W2 %2"));
  EXPECT_THAT(Block("FTOW %F1, %W2", {{"FTOW", "ROUND"}}),
              ElementsAre("%1 = load F1", "%2 = f32_to_nearest_sint %1", "store W2 %2"));
  EXPECT_THAT(Block("WTOF %W1, %F2"), ElementsAre("%1 = load W1", "%2 = sint_to_f32 %1", "store F2 %2"));
  // A constant beside a float is one: 2 is 0x40000000 in binary32.
  EXPECT_THAT(Block("MULF %F1, 2, %F1"),
              ElementsAre("%1 = load F1", "%2 = const f32 1073741824", "%3 = mul.f32 %1 %2", "store F1 %3"));
}

// covers: HOST50-132..135
TEST(Host50Blocks, FieldsOfBits) {
  EXPECT_THAT(Block("BTOW %I310, %W0, 2"),
              ElementsAre("%1 = load I310", "%2 = const i32 0", "%3 = bit_at.i32 %1 %2", "%4 = load I311",
                          "%5 = const i32 1", "%6 = bit_at.i32 %4 %5", "%7 = or.i32 %3 %6", "store W0 %7"));
  EXPECT_THAT(Block("BTOW %B0, %W0, 1", {{"BTOW", "KEEP"}}),
              ElementsAre("%1 = const i32 0xfffffffe", "%2 = load W0", "%3 = and.i32 %2 %1", "%4 = load B0",
                          "%5 = const i32 0", "%6 = bit_at.i32 %4 %5", "%7 = or.i32 %3 %6", "store W0 %7"));
  EXPECT_THAT(Block("WTOB %W0, %Q8, 2"),
              ElementsAre("%1 = load W0", "%2 = const i32 0", "%3 = test_bit.i32 %1 %2", "store Q8 %3",
                          "%4 = const i32 1", "%5 = test_bit.i32 %1 %4", "store Q9 %5"));
}

// covers: HOST50-150..157
TEST(Host50Blocks, Comparisons) {
  const std::pair<std::string, std::string> rows[] = {{"EQ", "eq"},  {"NE", "ne"},  {"GT", "sgt"},
                                                      {"GE", "sge"}, {"LT", "slt"}, {"LE", "sle"}};
  for (const auto& [block, op] : rows) {
    EXPECT_THAT(SlowBody("LD %I0;" + block + " %W1, -1;OUT %Q0"),
                ElementsAre("stmt Q0", "%0 = load I0", "%1 = load W1", "%2 = const i32 4294967295",
                            "%3 = " + op + ".i32 %1 %2", "%4 = and.bit %0 %3", "store Q0 %4"));
  }
  EXPECT_THAT(SlowBody("LD 1;LT %W1, %F2;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = const bit 1", "%1 = load W1", "%2 = sint_to_f32 %1", "%3 = load F2",
                          "%4 = lt.f32 %2 %3", "store Q0 %4"));
}

// covers: HOST50-138..143 HOST50-160..162
TEST(Host50Blocks, Expressions) {
  EXPECT_THAT(Block("OPRT %F2 = (%F0 + %W3) * 0.5"),
              ElementsAre("%1 = load F0", "%2 = load W3", "%3 = sint_to_f32 %2", "%4 = add.f32 %1 %3",
                          "%5 = const f32 1056964608", "%6 = mul.f32 %4 %5", "store F2 %6"));
  EXPECT_THAT(Block("OPRT %F0 := %W1 / 2"),
              ElementsAre("%1 = load W1", "%2 = const i32 2", "%3 = sdiv_or_dividend.i32 %1 %2", "%4 = sint_to_f32 %3",
                          "store F0 %4"));
  EXPECT_THAT(Block("OPRT %C1.V = -%W1 - -5"),
              ElementsAre("%1 = load W1", "%2 = const i32 0", "%3 = sub.i32 %2 %1", "%4 = const i32 4294967291",
                          "%5 = sub.i32 %3 %4", "store C1.V %5"));
  EXPECT_THAT(SlowBody("LD %I0;COMP %W1 & $0F <> %I3 + 1;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = load I0", "%1 = load W1", "%2 = const i32 0xf", "%3 = and.i32 %1 %2",
                          "%4 = load I3", "%5 = zext.bit.i32 %4", "%6 = const i32 1", "%7 = add.i32 %5 %6",
                          "%8 = ne.i32 %3 %7", "%9 = and.bit %0 %8", "store Q0 %9"));
}

// covers: HOST50-180..182 HOST50-186 HOST50-188 HOST50-189 HOST50-193
TEST(Host50Blocks, TimersByUnitAndOption) {
  const std::pair<std::string, std::string> rows[] = {
      {"TONMS %TM1, 3", "ton_100ms"}, {"TONS %TM1, 3", "ton_1s"}, {"TONM %TM1, 3", "ton_1min"},
      {"TOFMS %TM1, 3", "tof_100ms"}, {"TOFS %TM1, 3", "tof_1s"}, {"TOFM %TM1, 3", "tof_1min"},
      {"TPMS %TM1, 3", "tp_100ms"},   {"TPS %TM1, 3", "tp_1s"},   {"TP %TM1, MIN, 3", "tp_1min"}};
  for (const auto& [block, op] : rows) {
    EXPECT_THAT(SlowBody("LD %I0;" + block), ElementsAre("stmt TM1", "%0 = load I0", "%1 = const i32 3",
                                                         "%2 = const i32 8", "%3 = step." + op + " TM1 %0 %1 %2"));
  }
  EXPECT_THAT(SlowBody("LD %I0;TPS %TM1, 3", {{"TP", "IEC"}}), Contains("%3 = step.pulse_1s TM1 %0 %1 %2"));
  EXPECT_THAT(
      SlowBody("LD %I0;TON %TM1, S, %W5", {{"slowdiv", "100"}}),
      ElementsAre("stmt TM1", "%0 = load I0", "%1 = load W5", "%2 = const i32 100", "%3 = step.ton_1s TM1 %0 %1 %2"));
}

// covers: HOST50-191
TEST(Host50Blocks, TimersInFastHaveItsPeriod) {
  LoweredProgram lowered;
  LowerInto(lowered, {"FAST\nNETWORK\nLD %I0\nTONS %TM1, 3\nEND_FAST\nSLOW\nNETWORK\nLD 1\nCALL SR1\nEND_SLOW\n"
                      "SUB SR1\nNETWORK\nLD %I1\nTONS %TM2, 3\nEND_SUB\n"});
  EXPECT_THAT(lowered.Routine("fast"), Contains("%2 = const i32 1"));
  EXPECT_THAT(lowered.Routine("SR1"), Contains("%2 = const i32 8"));
}

// covers: HOST50-195..201
TEST(Host50Blocks, Counters) {
  EXPECT_THAT(
      SlowBody("LD %I0;CNUD %C1, 8, P=0, M=1, N=1;OUT %Q0"),
      ElementsAre("stmt C1", "%0 = load I0", "%1 = const i32 8", "%2 = const bit 0", "%3 = const bit 1",
                  "%4 = const bit 1", "%5 = counter_pins %2 %3 %4", "%6 = step.count_ring C1 %0 %1 %5", "store Q0 %6"));
  EXPECT_THAT(SlowBody("LD %I0;LD %I1;OR %I2;CNUD %C1, %W8, M=!%B3, N=1;OUT %Q0", {{"CNUD", "HOLD"}}),
              ElementsAre("stmt C1", "%0 = load I0", "%1 = load W8", "%2 = load I1", "%3 = load I2",
                          "%4 = or.bit %2 %3", "%5 = load B3", "%6 = not.bit %5", "%7 = const bit 1",
                          "%8 = counter_pins %4 %6 %7", "%9 = step.count_hold C1 %0 %1 %8", "store Q0 %9"));
}

// covers: HOST50-163..168
TEST(Host50Blocks, Rotation) {
  EXPECT_THAT(
      SlowBody("LD %I0;ROT 8, %W1, %W2, %W3, M=1;OUT %Q0"),
      ElementsAre("stmt W3", "%0 = load I0", "%1 = const i32 8", "%2 = load W1", "%3 = const i32 1",
                  "%4 = sub.i32 %2 %3", "%5 = load W2", "%6 = const i32 1", "%7 = sub.i32 %5 %6", "%8 = const bit 1",
                  "%9 = on_ring %1 %4 %7", "%10 = ring_forward %1 %4 %7", "%11 = and.bit %0 %9",
                  "%12 = and.bit %11 %10", "if %0 {", "if %9 {", "%13 = ring_steps %1 %4 %7", "store W3 %13",
                  "} else {", "%14 = const i8 1", "%15 = const i32 4294967295", "%16 = const i32 0",
                  "host fault (%14, %15, %16)", "}", "}", "store Q0 %12"));
  EXPECT_THAT(
      SlowBody("LD 1;ROT 8, 0, %W2, %W3, M=%I1;OUT %Q0", {{"ROTBASE", "0"}, {"ROTQ", "REVERSE"}}),
      ElementsAre("stmt W3", "%0 = const bit 1", "%1 = const i32 8", "%2 = const i32 0", "%3 = load W2", "%4 = load I1",
                  "%5 = on_ring %1 %2 %3", "%6 = ring_forward %1 %2 %3", "%7 = not.bit %6", "%8 = and.bit %5 %7",
                  "if %5 {", "if %4 {", "%9 = ring_steps %1 %2 %3", "store W3 %9", "} else {",
                  "%10 = ring_before %1 %2 %3", "store W3 %10", "}", "} else {", "%11 = const i8 1",
                  "%12 = const i32 4294967295", "%13 = const i32 0", "host fault (%11, %12, %13)", "}", "store Q0 %8"));
}

// covers: HOST50-211 HOST50-214 HOST50-217
// The speed is a constant: while the block is active it is what was sent.
TEST(Host50Blocks, AKnownAxis) {
  const Text body = SlowBody("LD %I0;POSA 3, %W5, 100");
  const Text expected = {"stmt POSA",
                         "%0 = load I0",
                         "if %0 {",
                         "%1 = const i32 0",
                         "%2 = load W5",
                         "%3 = sint_to_f32 %2",
                         "%4 = const f32 1120403456",
                         "%5 = const bit 1",
                         "store Q1002 %5",
                         "%6 = const bit 1",
                         "store Q1022 %6",
                         "%7 = const bit 1",
                         "store Q1032 %7",
                         "%8 = const bit 0",
                         "store Q1042 %8",
                         "store QF2 %4",
                         "store QF12 %3",
                         "%9 = const i32 2",
                         "%10 = load POSA_3.active",
                         "%11 = not.bit %10",
                         "%12 = load POSA_3.position",
                         "%13 = bits.f32 %3",
                         "%14 = bits.f32 %12",
                         "%15 = ne.i32 %13 %14",
                         "%16 = or.bit %11 %15",
                         "if %16 {",
                         "%17 = const i8 1",
                         "%18 = const bit 1",
                         "host axis_command (%9, %17, %18, %1, %3, %4)",
                         "store POSA_3.position %3",
                         "%19 = const bit 1",
                         "store POSA_3.active %19",
                         "}",
                         "} else {",
                         "%20 = load POSA_3.active",
                         "if %20 {",
                         "%21 = const bit 0",
                         "store Q1002 %21",
                         "%22 = const i32 2",
                         "%23 = const bit 0",
                         "store POSA_3.active %23",
                         "%24 = const i8 1",
                         "%25 = const bit 0",
                         "%26 = const i32 0",
                         "%27 = const f32 0",
                         "host axis_command (%22, %24, %25, %26, %27, %27)",
                         "}",
                         "}"};
  EXPECT_THAT(body, ElementsAreArray(expected));
}

// covers: HOST50-217
TEST(Host50Blocks, TwoNansAreOneRequest) {
  const Text body = SlowBody("LD %I0;VELP 3, %F1");
  EXPECT_EQ(
      std::ranges::count_if(body, [](const std::string& line) { return line.find(" = eq.f32 ") != std::string::npos; }),
      2);
  const Text numbers = SlowBody("LD %I0;POSA 3, %W5, 100");  // never a NaN: the bit patterns alone are compared
  EXPECT_EQ(
      std::ranges::count_if(numbers, [](const std::string& line) { return line.find("eq.f32") != std::string::npos; }),
      0);
}

// covers: HOST50-215 HOST50-216
TEST(Host50Blocks, AComputedAxisIsAChoice) {
  const Text body = SlowBody("LD %I0;VELN %W5, %F1", {{"AXISBASE", "0"}});
  EXPECT_THAT(body, Contains("%3 = ult.i32 %1 %2"));
  EXPECT_EQ(std::ranges::count_if(body, [](const std::string& line) { return line.starts_with("case "); }), 20);
  const auto stores = [&body](const std::string& place) {
    return std::ranges::count_if(body,
                                 [&](const std::string& line) { return line.starts_with("store " + place + " "); });
  };
  for (const std::string signal : {"Q1000", "Q1009"}) EXPECT_EQ(stores(signal), 2) << "requested and withdrawn";
  for (const std::string signal : {"Q1020", "Q1039", "Q1049", "QF9"}) EXPECT_EQ(stores(signal), 1);
  EXPECT_EQ(stores("QF10"), 0);
  EXPECT_THAT(body, Contains(testing::HasSubstr("neg.f32")));
}

// covers: HOST50-035 HOST50-037
TEST(Host50Blocks, CallsAndForwardJumps) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOW\nNETWORK\nLD %I0\nOUT %Q0\nLBL J7\nOUT %Q1\nNETWORK\nLD 1\nCALL SR3\n"
                      "NETWORK L7\nLD 1\nLBL J8\nNETWORK L8\nEND_SLOW\n"
                      "SUB SR3 \"oil\"\nNETWORK\nLD %I1\nCALL SR4\nEND_SUB\nSUB SR4\nEND_SUB\n"});
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("stmt Q0", "%0 = load I0", "store Q0 %0", "%1 = load I0", "jump L2 if %1", "%2 = load I0",
                          "store Q1 %2", "stmt SR3", "%0 = const bit 1", "call SR3 ()", "label L2", "stmt LBL",
                          "%0 = const bit 1", "jump L3", "label L3", "stmt"));
  EXPECT_THAT(lowered.Routine("SR3"), ElementsAre("stmt SR4", "%0 = load I1", "if %0 {", "call SR4 ()", "}"));
  EXPECT_THAT(lowered.Printed(), testing::HasSubstr("routine SR3 subroutine \"SUB SR3: oil\" {"));
}

// covers: HOST50-038 HOST50-043
TEST(Host50Blocks, JumpsBackAreCounted) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOW\nNETWORK L5\nLD %I0\nLBL J5\nEND_SLOW\nSUB SR9\nNETWORK L5\nLD %I0\nLBL J5\nEND_SUB\n"});
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("%0 = const i32 10000", "store jumps_left %0", "label L0", "stmt LBL", "%0 = load I0",
                          "jump L0 if %0 budget jumps_left refused {", "%1 = const i8 0", "%2 = const i32 4294967295",
                          "%3 = const i32 5", "host fault (%1, %2, %3)", "jump L2", "}", "label L2"));
  EXPECT_THAT(lowered.Routine("SR9"), Contains("store SR9_jumps_left %0"));
  EXPECT_THAT(lowered.Routine("SR9"), Contains("%2 = const i32 9"));
  EXPECT_THAT(lowered.Printed(), testing::HasSubstr("place jumps_left i32 routine[0]"));
  EXPECT_THAT(lowered.Printed(), testing::HasSubstr("place SR9_jumps_left i32 system["));
}

}  // namespace
}  // namespace plcxx::host50
