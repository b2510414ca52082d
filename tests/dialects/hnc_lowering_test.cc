// What C becomes: operations, loops and their bounds, index checks, calls, the checks that need flow.
#include <string>
#include <utility>
#include <vector>

#include "hnc_lowered.h"
#include "transpiler/dialects/hnc/control/locate.h"

namespace plcxx::hnc {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> Body(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements(statements));
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << statements;
  return lowered.Routine("plc1");
}

bool HasLine(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

// covers: HNC-213
TEST(HncLowering, ABitOfAByteIsAnOperationOfBytes) {
  const std::vector<std::string> lines = Body("Y[2] |= 0x80; Y[2] &= ~0x80;");
  EXPECT_TRUE(HasLine(lines, "or.i8")) << testing::PrintToString(lines);
  EXPECT_TRUE(HasLine(lines, "and.i8")) << testing::PrintToString(lines);
}

// covers: HNC-197
TEST(HncLowering, DivisionIsCheckedOnlyWhereItCanTrap) {
  EXPECT_TRUE(HasLine(Body("a = a / b;"), "call record_fault"));
  EXPECT_FALSE(HasLine(Body("a = a / 3;"), "record_fault"));
  EXPECT_FALSE(HasLine(Body("a = a / (b & 7 | 8);"), "record_fault"));
}

// covers: HNC-278
TEST(HncLowering, AnIndexIsCheckedOnlyWhereItCanLeave) {
  EXPECT_TRUE(HasLine(Body("a = table[b];"), "record_fault"));
  EXPECT_FALSE(HasLine(Body("a = table[b & 7];"), "record_fault"));
  EXPECT_FALSE(HasLine(Body("int k; for (k = 0; k < 8; k++) table[k] = 0;"), "record_fault"));
  EXPECT_FALSE(HasLine(Body("if (X[0] < 128) a = R[X[0] + 5];"), "record_fault"));
  EXPECT_TRUE(HasLine(Body("int k; for (k = 0; k <= 8; k++) table[k] = 0;"), "record_fault"));
}

// covers: HNC-244, HNC-247, HNC-249, HNC-251, HNC-253, HNC-256, HNC-357
TEST(HncLowering, LoopsAreProvedOrRefused) {
  const std::vector<std::pair<std::string, bool>> loops = {
      {"for (i = 0; i < 10; i++) a++;", true},
      {"for (i = 10; i > 0; i -= 2) a++;", true},
      {"for (c = 0; c < 255; c++) a++;", true},
      {"for (c = 0; c < 300; c++) a++;", false},
      {"for (c = 0; c <= 255; c++) a++;", false},
      {"for (u = 10; u >= 0; u--) a++;", false},
      {"for (i = 0; i < n; i++) a++;", true},
      {"for (i = 0; i <= n; i++) a++;", false},
      {"if (n > 10) n = 10; for (i = 0; i <= n; i++) a++;", true},
      {"for (i = 0; i < n; i++) n++;", false},
      {"for (i = 0; i != 10; i += 2) a++;", true},
      {"for (i = 0; i != 9; i += 2) a++;", false},
      {"for (u = 0; u != 9; u += 2) a++;", false},
      {"for (c = 0; c != 4; c += 12) a++;", true},
      {"while (n) n--;", true},
      {"while (n--) a++;", true},
      {"while (--n > 0) a++;", true},
      {"while (i++ < 10) a++;", true},
      {"while (X[0] == 0) a++;", false},
      {"while (i < 10 && X[0]) i++;", true},
      {"while (i < 10 || X[0]) i++;", false},
      {"i = 0; while (i < 10) { if (a) i++; }", false},
      {"i = 0; while (i < 10) { if (a) continue; i++; }", false},
      {"i = 0; while (i < 10) { i++; if (a) continue; b++; }", true},
      {"i = 0; do i++; while (i < 5);", true},
      {"for (;;) { a++; break; }", true},
      {"for (;;) { a++; if (a) break; }", false},
      {"do { a++; } while (0);", true},
      {"for (R[5] = 0; R[5] < 10; R[5]++) a++;", true},
      {"for (R[5] = 0; R[5] < 10; R[5]++) R[a & 15] = 0;", false},
      {"i = 0; again: i++; if (i < 5) goto again;", true},
      {"again: if (X[0]) goto again;", false},
  };
  for (const auto& [loop, accepted] : loops) {
    const std::vector<std::string> errors = Errors(loop);
    if (accepted) {
      EXPECT_THAT(errors, IsEmpty()) << loop;
    } else {
      EXPECT_THAT(errors, ElementsAre("3 E032")) << loop;
    }
  }
}

// How often such a loop goes round nobody knows; its own error is the cause.
TEST(HncLowering, OfALoopInWhichSomethingIsWrongNothingElseIsSaid) {
  const auto reported = [](const std::string& loop) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements(loop + " Y[0] = (unsigned char)(a + b + u + l + c + table[0] + i + n);"));
    std::vector<std::string> lines = lowered.Reported();
    std::erase_if(
        lines, [](const std::string& line) { return !line.ends_with("W7") && line.find(" E") == std::string::npos; });
    return lines;
  };
  EXPECT_THAT(reported("for (i = 0; i < 4; k++) a++;"), ElementsAre("3 E010"));
  EXPECT_THAT(reported("for (int k = 0; k < 4; k++) a++;"), ElementsAre("3 E054"));
  EXPECT_THAT(reported("for (i = 0; i < 4;) i += k;"), ElementsAre("3 E010"));
  EXPECT_THAT(reported("a = k; for (i = 0; i < 4;) a++;"), ElementsAre("3 E010", "3 E032"));
  EXPECT_THAT(reported("a = k; for (i = 0; i < 30000; i++) a++;"), ElementsAre("3 E010", "3 W7"));
}

TEST(HncLowering, FactsAreExecutedWhereTheyAreAskedFor) {
  const std::string text =
      "#include \"plc.h\"\nint table[8], n;\nvoid init() { plc1_time = 16; plc2_time = 16; }\n"
      "void plc1() { int k; for (k = 0; k < 8; k++) table[k] = 0; n = k > 8; }\nvoid plc2() { }\n";
  for (const ir::Facts facts : {ir::Facts::kTrusted, ir::Facts::kChecked}) {
    LoweredProgram lowered;
    LowerInto(lowered, text, {}, facts);
    const std::vector<std::string> lines = lowered.Routine("plc1");
    // That the index is inside, that k is at most 8 after the loop.
    EXPECT_EQ(HasLine(lines, "false_fact"), facts == ir::Facts::kChecked) << testing::PrintToString(lines);
  }
}

// The user's own macro names a cell before one of the header does, one with parameters never does.
TEST(HncLowering, ACellHasTheNameOfAMacroThatIsAllOfIt) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\n#define FEED ch_feedover(0)\n#define LAMP Y[3]\n#define LAMP_AT(i) Y[i]\nint a;\n"
            "void plc1() { a = *ch_feedover(0); *FEED = 4; a = *ch_rapidover(0); LAMP_AT(4) = 1; LAMP_AT(3) = 1; LAMP "
            "= 2; }\n"
            "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n");
  const std::vector<std::string> lines = lowered.Routine("plc1");
  for (const std::string name : {"load FEED", "store FEED", "load ch_rapidover_0", "store Y4", "store LAMP"}) {
    EXPECT_TRUE(HasLine(lines, name)) << name << testing::PrintToString(lines);
  }
  EXPECT_FALSE(HasLine(lines, "store Y3")) << testing::PrintToString(lines);
}

// What a byte cannot be needs no assertion: its type says so.
TEST(HncLowering, TheBoundsOfAByteAreNoFact) {
  const auto states_facts = [](const std::string& statements) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements(statements), {}, ir::Facts::kChecked);
    return HasLine(lowered.Routine("plc1"), "false_fact");
  };
  EXPECT_FALSE(states_facts("a = X[0] < 300;"));
  EXPECT_FALSE(states_facts("l = X[0]; a = X[0] / 3;"));
  EXPECT_TRUE(states_facts("if (b > 5) a = b < 3;"));
}

TEST(HncLowering, TheStepOfAForStandsInItsHead) {
  const std::vector<std::string> lines = Body("int k; for (k = 0; k < 8; k++) a += k;");
  EXPECT_TRUE(HasLine(lines, "loop")) << testing::PrintToString(lines);
  EXPECT_TRUE(HasLine(lines, "step {")) << testing::PrintToString(lines);
  const std::string head = "n = 0;\n//@loop_bound 10\n";
  EXPECT_TRUE(HasLine(Body(head + "for (i = 0; n < 5; table[3] += 2) n++;"), "step {"));
  // A value that is asked for twice would be computed twice there.
  EXPECT_FALSE(HasLine(Body(head + "for (i = 0; n < 5; table[n & 7] += 2) n++;"), "step {"));
  EXPECT_FALSE(HasLine(Body(head + "for (i = 0; n < 5; i = b = 2) n++;"), "step {"));
}

// covers: HNC-227
TEST(HncLowering, ASwitchStaysOneAndFallsThrough) {
  const std::vector<std::string> lines = Body("switch (a) { case 1: b = 1; case 2: b = 2; break; default: b = 3; }");
  EXPECT_TRUE(HasLine(lines, "case 1 falls_through {")) << testing::PrintToString(lines);
  EXPECT_TRUE(HasLine(lines, "default {")) << testing::PrintToString(lines);
  EXPECT_FALSE(HasLine(lines, "jump")) << testing::PrintToString(lines);
}

TEST(HncLowering, LabelsOfASwitchAreSpelledAsTheyWereWritten) {
  EXPECT_TRUE(HasLine(Body("switch (a) { case 0x01: case 0X20: case 12: b = 1; break; case 0xFFFF: b = 2; }"),
                      "case 0x1 0x20 12 {"));
  EXPECT_TRUE(HasLine(Body("switch (a) { if (b) { case 0x10: b = 1; } case 7: b = 2; }"), "case 0x10 {"));
}

// covers: HNC-237
TEST(HncLowering, ASwitchStaysOneWhereAGotoLeavesNoArm) {
  const auto jumps = [](const std::string& arms) {
    const std::vector<std::string> lines = Body("switch (a) { " + arms + " }");
    return std::ranges::count_if(lines, [](const std::string& line) { return line.starts_with("jump "); });
  };
  EXPECT_EQ(jumps("case 1: b = 1; if (n) goto on; b = 2; on: b = 3; break; case 2: b = 4;"), 1);
  EXPECT_GT(jumps("case 1: b = 1; if (n) goto on; b = 2; break; case 2: b = 4; on: b = 3;"), 1);
}

// An int reads as it was written; the lowest one has no number without its sign.
TEST(HncLowering, NegativeNumbersAreNegated) {
  EXPECT_TRUE(HasLine(Body("a = -32767;"), "neg.i16"));
  EXPECT_FALSE(HasLine(Body("a = -32767 - 1;"), "neg.i16"));
  EXPECT_TRUE(HasLine(Body("l = -2147483647L;"), "neg.i32"));
  EXPECT_FALSE(HasLine(Body("l = -2147483647L - 1;"), "neg.i32"));
}

// Errors of the arguments are reported beside that of the call, the first argument's too.
TEST(HncLowering, WhatIsCalledThoughItIsNotThereHasItsArgumentsChecked) {
  EXPECT_THAT(Errors("a = nowhere(a / 0, b / 0);"), ElementsAre("3 E016", "3 E053", "3 E053"));
}

// covers: HNC-092, HNC-093
TEST(HncLowering, RecursionIsRefusedAtTheCallThatClosesIt) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nvoid f();\nvoid g() { f(); }\nvoid f() { g(); }\n"
            "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1() { f(); }\nvoid plc2() { }\n");
  EXPECT_THAT(lowered.Reported(), Contains("3 E031"));
}

// covers: HNC-218
TEST(HncLowering, PointersToOneObjectAreOffsets) {
  const std::vector<std::string> lines = Body("int *p; p = &table[2]; *p = 5; p[1] = 6;");
  EXPECT_FALSE(HasLine(lines, "record_fault")) << testing::PrintToString(lines);
  EXPECT_FALSE(HasLine(lines, "switch")) << testing::PrintToString(lines);
}

// covers: HNC-263
TEST(HncLowering, APointerToOneObjectHasNoRoomForWhichItIs) {
  const auto bytes = [](const std::string& text) {
    LoweredProgram lowered;
    LowerInto(lowered,
              "#include \"plc.h\"\nint table[8], other, *p;\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
              "void plc1() { " +
                  text + " *p = 1; }\nvoid plc2() { }\n");
    const auto pointers = std::ranges::find(lowered.program().spaces, "pointers", &ir::Space::name);
    return pointers == lowered.program().spaces.end() ? 0U : pointers->bytes;
  };
  EXPECT_EQ(bytes("p = table + X[0];"), 4U);
  EXPECT_EQ(bytes("p = table + X[0]; if (X[1]) p = &other;"), 6U);
}

// Of pointers into different objects there is no difference and no order; one that refers to nothing has no object.
TEST(HncLowering, OnlyPointersWithObjectsAreIntoDifferentOnes) {
  for (const char* operation : {"p - q", "q - p", "p < q", "q >= p"}) {
    const std::string stored = std::string("a = ") + operation + ";";
    EXPECT_THAT(Errors("int *p, *q; p = table; q = &table[3]; " + stored), testing::IsEmpty()) << operation;
    EXPECT_THAT(Errors("int *p, *q; p = table; q = 0; " + stored), testing::IsEmpty()) << operation;
    EXPECT_THAT(Errors("int *p, *q; p = 0; q = 0; " + stored), testing::IsEmpty()) << operation;
    EXPECT_THAT(Errors("int *p, *q; p = table; q = &b; " + stored), testing::ElementsAre(testing::StartsWith("3 E")))
        << operation;
  }
  EXPECT_THAT(Errors("int *p, *q; p = table; q = &b; a = p == q;"), testing::IsEmpty());
}

TEST(HncLowering, PointersToSeveralObjectsChoose) {
  EXPECT_TRUE(HasLine(Body("int *p; if (a) p = table; else p = R_i; *p = 5;"), "switch"));
}

// covers: HNC-331
TEST(HncLowering, HandlersAreNumbers) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nvoid on_m(int ch) { mod_M_code(ch) = -1; }\n"
            "void init() { plc1_time = 16; plc2_time = 32; set_mst_func(0, 'M', on_m); }\n"
            "void plc1() { }\nvoid plc2() { }\n");
  EXPECT_THAT(lowered.Reported(), IsEmpty());
  EXPECT_TRUE(HasLine(lowered.Routine("dispatch"), "call on_m"));
}

// covers: HNC-126, HNC-127
TEST(HncLowering, LocationsByName) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nstruct axis { int speed; unsigned char on; } axes[3];\n"
            "void init() { plc1_time = 16; plc2_time = 32; }\n"
            "void plc1() { static int count; count++; axes[1].speed = count; }\nvoid plc2() { }\n");
  for (const char* name : {"X0.1", "F162.5", "R[612]", "B[0]", "R_i[1]", "F_l[1]", "G_i[170]", "axes[1].speed",
                           "axes[2].on", "plc1.count", "HW[0]", "MODAL[3]", "FAULT.code", "FAULT.line", "plc1_time"}) {
    EXPECT_TRUE(Locate(ir::NameIndex(lowered.program()), name)) << name;
  }
  for (const char* name :
       {"X0.8", "F162.16", "R[768]", "F_l[255]", "axes[3].speed", "axes", "count", "HW[4]", "Q1", ""}) {
    EXPECT_FALSE(Locate(ir::NameIndex(lowered.program()), name)) << name;
  }
}

// covers: HNC-127, HNC-349
TEST(HncLowering, VariablesHaveTheirSignTheirValueAndTheirComment) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nint a = -3; /* of the\naxis */ unsigned u; signed char s; unsigned char c; long l; "
            "float f;\n"
            "struct { int field : 3; unsigned other : 4; } r;\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
            "void plc1() { u = a; s = c; l = u; f = s; r.field = 1; r.other = 2; }\nvoid plc2() { }\n");
  std::map<std::string, bool> signs;
  for (const ir::Symbol& symbol : lowered.program().symbols) signs[symbol.name] = symbol.has_sign;
  for (const char* name : {"a", "s", "l", "r.field"}) EXPECT_TRUE(signs.at(name)) << name;
  for (const char* name : {"u", "c", "f", "r.other"}) EXPECT_FALSE(signs.at(name)) << name;
  std::map<std::string, std::string> meanings;
  for (const ir::Documentation& known : lowered.program().documentation) meanings[known.symbols] = known.meaning;
  EXPECT_THAT(meanings.at("a"), HasSubstr(" = -3; "));
  EXPECT_THAT(meanings.at("a"), HasSubstr("of the axis"));
}

// covers: HNC-308
TEST(HncLowering, AHandlerThatIsChosenHasASlotOfItsName) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nvoid on(int ch) { mod_M_code(ch) = -1; mod_T_code(ch) = -1; }\nvoid init() { "
            "plc1_time = 16; plc2_time = 32;\n"
            "if (P[0]) { set_mst_func(0, 'T', on); set_mst_func(1, 'M', on); } }\nvoid never() { plc1_time = 500; }\n"
            "void plc1() { }\nvoid plc2() { }\n");
  std::vector<std::string> names;
  for (const ir::Place& place : lowered.program().places) names.push_back(place.name);
  EXPECT_THAT(names, Contains("handler_T0"));
  EXPECT_THAT(names, Contains("handler_M1"));
  // What no part reaches sets no period.
  EXPECT_EQ(lowered.program().schedule.fast_every_ms, 16u);
  EXPECT_EQ(lowered.program().schedule.slow_every_ms, 32u);
}

// covers: HNC-139
TEST(HncLowering, IndexedPlacesHaveNamesThatSayWhereTheyBegin) {
  const auto names = [](const std::string& statements) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements(statements));
    std::vector<std::string> found;
    for (const ir::Place& place : lowered.program().places) {
      if (place.indexed && lowered.program().spaces[place.space].name != "system") found.push_back(place.name);
    }
    return found;
  };
  EXPECT_THAT(names("table[a] = 1;"), Contains("table"));
  // A constant part that leads out of the object goes into the index.
  EXPECT_THAT(names("(table + 7)[a] = 1;"), Contains("table_from_14"));
  EXPECT_THAT(names("(table + 8)[a] = 1;"), Contains("table"));
  EXPECT_THAT(names("(table + 9)[a] = 1;"), Contains("table"));
  EXPECT_THAT(names("(table - 1)[a] = 1;"), Contains("table"));
  EXPECT_THAT(names("((unsigned char *)table)[a] = 1;"), Contains("table_from_0_by_1"));
  EXPECT_THAT(names("R[a] = 1;"), Contains("R"));
  EXPECT_THAT(names("R_ui[a] = 1;"), Contains("R_ui"));
  EXPECT_THAT(names("R_ul[a] = 1;"), Contains("R_ul"));
  EXPECT_THAT(names("P[a] = 1;"), Contains("P"));
  EXPECT_THAT(names("*G_uc[a] = 1;"), Contains("G_uc_by_2"));
}

TEST(HncLowering, BytesBetweenMembersAreNamedByTheirPlace) {
  LoweredProgram lowered;
  LowerInto(lowered, "struct gapped { unsigned char first; unsigned : 16; unsigned char last; } gapped;\n" +
                         WithStatements("((unsigned char *)&gapped)[0] = 1; ((unsigned char *)&gapped)[1] = 2; "
                                        "((unsigned char *)&gapped)[2] = 3; ((unsigned char *)&gapped)[3] = 4;"));
  std::vector<std::string> names;
  for (const ir::Place& place : lowered.program().places) {
    if (place.name.starts_with("gapped")) names.push_back(place.name + " " + place.address);
  }
  EXPECT_THAT(names, ElementsAre("gapped_first gapped.first", "gapped_byte_1 gapped_byte_1",
                                 "gapped_byte_2 gapped_byte_2", "gapped_last gapped.last"));
}

TEST(HncLowering, AMacroThatStandsForAWordOfATableNamesIt) {
  const auto is_named = [](const std::string& text, std::string_view name) {
    LoweredProgram lowered;
    LowerInto(lowered,
              "#include \"plc.h\"\n" + text + "}\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n");
    return std::ranges::any_of(lowered.program().places, [&](const ir::Place& place) { return place.name == name; });
  };
  EXPECT_TRUE(is_named("#define SPEED G_i[5]\nvoid plc1() { *SPEED = 3; ", "SPEED"));
  EXPECT_TRUE(is_named("#define SPEED (*G_i[5])\nvoid plc1() { SPEED = 3; ", "SPEED"));
  EXPECT_TRUE(is_named("#define LAMP Y[5]\nvoid plc1() { LAMP = 3; ", "LAMP"));
  EXPECT_FALSE(is_named("#define LAMP 5\nvoid plc1() { Y[LAMP] = 3; ", "LAMP"));
  // What a macro gives the address or the value of is not called so.
  EXPECT_FALSE(is_named("#define LAMP (&Y[5])\nvoid plc1() { *LAMP = 3; ", "LAMP"));
  EXPECT_FALSE(is_named("#define LAMP (Y[5] + 1)\nint n;\nvoid plc1() { n = LAMP; ", "LAMP"));
  // A variable has its own name, an element that is chosen when it is executed has none.
  EXPECT_FALSE(is_named("#define LAMP lamp\nint lamp;\nvoid plc1() { LAMP = 3; ", "LAMP"));
  EXPECT_FALSE(is_named("#define LAMP lamps[X[0]]\nint lamps[300];\nvoid plc1() { LAMP = 3; ", "LAMP"));
}

// Also where no statement names its first byte.
TEST(HncLowering, EachVariableIsDocumentedByItsName) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements("table[a] = b;"));
  std::map<std::string, std::string> symbols;
  for (const ir::Documentation& known : lowered.program().documentation) symbols[known.address] = known.symbols;
  EXPECT_EQ(symbols["table"], "table");
  EXPECT_EQ(symbols["a"], "a");
  EXPECT_EQ(symbols["n"], "n");
}

// A cell of an area by its macro, or by what the generated code calls it; one of a variable as scenarios name it.
TEST(HncLowering, EachCellIsDocumentedByWhatItIsCalled) {
  LoweredProgram lowered;
  LowerInto(lowered, "#define LAMP Y[3]\n" + WithStatements("LAMP = X[4]; R_ui[2] = 7; table[5] = *G[7];"));
  std::map<std::string, std::string> symbols;
  for (const ir::Documentation& known : lowered.program().documentation) symbols[known.address] = known.symbols;
  EXPECT_EQ(symbols["Y[3]"], "LAMP");
  EXPECT_EQ(symbols["X[4]"], "X4");
  EXPECT_EQ(symbols["R_ui[2]"], "R_ui_2");
  EXPECT_EQ(symbols["G[7]"], "G7");
  EXPECT_EQ(symbols["table[5]"], "table[5]");
}

// Behind the name, or directly above its line; what an empty line separates is about more than one name.
TEST(HncLowering, ACellAndAVariableHaveWhatTheirCommentSays) {
  LoweredProgram lowered;
  LowerInto(
      lowered,
      "// all lamps\n\n#define LAMP Y[3]  /* door */\n// coolant\n// pump\n#define PUMP Y[4]\n#define HORN Y[5]\n"
      "/* of the\n   chuck */\nint grip;\nint turns;  // --- of the spindle ---\n\n/* not used */\n\nint rest;\n" +
          WithStatements("LAMP = grip; PUMP = turns; HORN = rest;"));
  std::map<std::string, std::string> meanings;
  for (const ir::Documentation& known : lowered.program().documentation) meanings[known.symbols] = known.meaning;
  EXPECT_EQ(meanings["LAMP"], "door");
  EXPECT_EQ(meanings["PUMP"], "coolant pump");
  EXPECT_EQ(meanings["HORN"], "");
  EXPECT_EQ(meanings["grip"], "int; of the chuck");
  EXPECT_EQ(meanings["turns"], "int; of the spindle");
  EXPECT_EQ(meanings["rest"], "int");
}

// Neither what the runtime keeps nor strings and automatic arrays.
TEST(HncLowering, OnlyAreasAndVariablesAreDocumented) {
  LoweredProgram lowered;
  LowerInto(lowered,
            WithStatements("char *s = \"ab\"; int own[3]; own[b & 1] = get_handwheel(0); own[2] = s[0]; Y[1] = own[2];"
                           "handwheel(0, 1, 2); a = own[b & 1];"));
  std::vector<std::string> addresses;
  for (const ir::Documentation& known : lowered.program().documentation) {
    if (known.address.find('[') != std::string::npos) addresses.push_back(known.address);
  }
  EXPECT_THAT(addresses, Contains("Y[1]"));
  EXPECT_THAT(addresses, testing::Each(testing::MatchesRegex("(X_ul|Y|F).[0-9]+.")));
}

// covers: HNC-346
TEST(HncLowering, APointerToWhatOutlivesTheFunctionIsGiven) {
  for (const auto& [function, errors] :
       std::vector<std::pair<std::string, size_t>>{{"int *f(int p) { static int s; return &s; }", 0},
                                                   {"int *f(int p) { static int s[3]; return s + 1; }", 0},
                                                   {"int *f(int p) { return &a; }", 0},
                                                   {"int *f(int p) { int s = p; return &s; }", 1},
                                                   {"int *f(int p) { return &p; }", 1},
                                                   {"int *f(int p) { int s[3]; return p ? s : &a; }", 1},
                                                   {"int *f(int p) { if (p) return &a; return 0; }", 0}}) {
    LoweredProgram lowered;
    LowerInto(lowered, "#include \"plc.h\"\nint a;\n" + function +
                           "\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
                           "void plc1() { int *q; q = f(3); *q = 1; }\nvoid plc2() { }\n");
    std::vector<std::string> reported = lowered.Reported();
    std::erase_if(reported, [](const std::string& line) { return !line.ends_with(" E049"); });
    EXPECT_EQ(reported.size(), errors) << function << testing::PrintToString(lowered.Reported());
  }
}

// covers: HNC-346
TEST(HncLowering, AFunctionThatGivesNothingIsReportedButTheEntriesAreNot) {
  const auto reported = [](const std::string& functions) {
    LoweredProgram lowered;
    LowerInto(lowered, "#include \"plc.h\"\nint a, *q;\n" + functions);
    std::vector<std::string> lines = lowered.Reported();
    std::erase_if(lines, [](const std::string& line) { return !line.ends_with(" W25"); });
    return lines;
  };
  for (const char* body : {" a = 1; ", " if (a) return; a = 1; return; ", " if (a) return 1; a = 1; "}) {
    const std::string entries = std::string("int init() { plc1_time = 16; plc2_time = 32; ") + body +
                                "}\nint plc1() {" + body + "}\nint plc2() {" + body + "}\n";
    EXPECT_THAT(reported(entries), IsEmpty()) << body;
    EXPECT_THAT(
        reported("int other() {" + std::string(body) +
                 "}\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1() { a = other(); }\nvoid plc2() { }\n"),
        Contains("3 W25"))
        << body;
  }
  EXPECT_THAT(
      reported("int *other() { if (a > 2) return; return &a; }\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
               "void plc1() { q = other(); }\nvoid plc2() { }\n"),
      Contains("3 W25"));
}

TEST(HncLowering, OfAnIntegerTheInitialValueIsDocumented) {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\nfloat f = 2.5; int k = 7; int n;\nvoid init() { plc1_time = 16; plc2_time = 32; }\n"
            "void plc1() { f = k; n = f; }\nvoid plc2() { }\n");
  std::map<std::string, std::string> meanings;
  for (const ir::Documentation& known : lowered.program().documentation) meanings[known.address] = known.meaning;
  EXPECT_EQ(meanings["f"], "float");
  EXPECT_EQ(meanings["k"], "int = 7");
  EXPECT_EQ(meanings["n"], "int");
}

TEST(HncLowering, CommentsAreLinesWithoutTheirEdges) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements("\n/* one\n * two **\n ** three */\n// * four\na = 1;"));
  std::vector<std::string> lines;
  for (const ir::Statement& statement : lowered.program().statements) {
    for (const source::Range& range : statement.comments) lines.emplace_back(lowered.sources.Text(range));
  }
  EXPECT_THAT(lines, ElementsAre("one", "two", "three", "* four"));
}

// covers: HNC-344
TEST(HncLowering, AVariableIsReportedOnceAsReadBeforeWritten) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements("int x, y; a = x; b = x + y; a = y;"));
  const std::vector<std::string> reported = lowered.Reported();
  EXPECT_EQ(std::count(reported.begin(), reported.end(), "3 W4"), 2);
}

/// A program in which structures, unions and bit-fields are declared, initialised, passed and used.
constexpr std::string_view kRecords = R"(#include "plc.h"
struct axis { int a, b[2]; unsigned run : 1, : 0, dir : 2; } f = { 1, { 2, 3 }, 1, 2 };
union { unsigned u; long l; struct axis in; } w;
struct axis g[2];
struct axis h(struct axis x) { x.b[1]++; return x; }
void init() { plc1_time = 16; plc2_time = 16; }
void plc1() { struct axis *p = &g[1]; p->a += f.b[X[0] & 1]; g[0] = h(*p); w.in.dir = f.run ? 2 : f.dir--; w.l = h(f).a; }
void plc2() { }
)";

TEST(HncLowering, ASlipInARecordIsAnErrorAndNoCrash) {
  const size_t begin = kRecords.find("struct"), end = kRecords.find("void init");
  for (size_t at = begin; at < end; ++at) {
    for (const std::string_view slip : {"", "|", "in "}) {
      std::string text(kRecords);
      text.replace(at, slip.empty() ? 1 : 0, slip);
      LoweredProgram lowered;
      LowerInto(lowered, text);
    }
  }
  LoweredProgram lowered;
  LowerInto(lowered, std::string(kRecords));
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << testing::PrintToString(lowered.Reported());
}

// The comparison is refused as a whole, and assigns nothing: the pointer's own error is not one of its consequences.
TEST(HncLowering, ARefusedAssignmentHasNoSecondErrorAndARefusedComparisonHas) {
  EXPECT_THAT(Errors("int *p; if (p == nowhere) a = 1; a = *p;"), ElementsAre("3 E010", "3 E050"));
  EXPECT_THAT(Errors("int *p; p = nowhere; a = *p;"), ElementsAre("3 E010"));
  EXPECT_THAT(Errors("int *p; if (nowhere == p\n) a = 1; a = *p;"), ElementsAre("3 E010", "4 E050"));
  EXPECT_THAT(Errors("a = *(int *)0x1234; *(char *)16 = 1;"), ElementsAre("3 E048", "3 E048"));
  // The line of the error may end with the name, or with one that begins like it.
  EXPECT_THAT(Errors("int *p, *pq; pq = nowhere, a = (int)p\n; a = *p; a = *pq;"), ElementsAre("3 E010", "4 E050"));
  EXPECT_THAT(Errors("int *p, *pq; a = nowhere == p\n; a = *p; a = *pq;"), ElementsAre("3 E010", "4 E050", "4 E050"));
  EXPECT_THAT(Errors("int *p, *qp; qp = nowhere; a = *p; a = *qp;"), ElementsAre("3 E010", "3 E050"));
  EXPECT_THAT(Errors("int *p, *q; p   = nowhere; a = *p; a = *q;"), ElementsAre("3 E010", "3 E050"));
  // What was refused where it is declared is not refused where it is used as well.
  EXPECT_THAT(Errors("struct s { int *p; } q; q.p = &a; *q.p = 1; a = q.p[1];"), ElementsAre("3 E050"));
  EXPECT_THAT(Errors("int *t[2]; a = *t[0]; if (t[0] == t[1]) a = 1;"), ElementsAre("3 E050"));
}

// covers: HNC-346
TEST(HncLowering, AnAddressIsAlwaysTrue) {
  for (const char* pointer : {"table", "&a", "table + 1", "(char *)&a", "&table[2]"}) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements("if (" + std::string(pointer) + ") b = 1;"));
    EXPECT_THAT(lowered.Reported(), Contains("3 W13")) << pointer;
  }
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements("if (a ? &b : 0) b = 1;"));
  EXPECT_THAT(lowered.Reported(), Not(Contains("3 W13")));
}

// covers: HNC-269
TEST(HncLowering, AnAddressOfAPointerIsRefused) {
  for (const char* statement : {"(*&p) = &a;", "(*&p)++;", "*(b ? &p : &q) = &a;", "(*(int **)&p)++;", "q = *&p;",
                                "memset(&p, 0, 2);", "if (&p) a = 1;", "q = (int *)*words;", "a = **words;",
                                "a = *((char *)words);", "a = *(*(words + 1));", "b = &p == &q;"}) {
    LoweredProgram lowered;
    LowerInto(lowered,
              "#include <string.h>\n#include \"plc.h\"\nint a, b, *p = &a, *q = &b; char *const words[] = { \"on\", "
              "\"off\" };\n"
              "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1() {\n" +
                  std::string(statement) + " a = *p + *q; }\nvoid plc2() { }\n");
    std::vector<std::string> reported = lowered.Reported();
    std::erase_if(reported, [](const std::string& line) { return line.find(" W") != std::string::npos; });
    EXPECT_THAT(reported, testing::AllOf(testing::Not(IsEmpty()), testing::Each("6 E050"))) << statement;
  }
  EXPECT_THAT(Errors("char *const words[] = { \"on\", \"off\" }; a = words[1][1]; a = *words[b & 1]; b = sizeof(&a);"),
              IsEmpty());
}

// However many loops and switches are around its label.
TEST(HncLowering, AJumpIntoSomethingIsRefusedOnce) {
  for (const char* around : {"for (i = 0; i < 5; i++) { for (n = 0; n < 5; n++) { in: a = 1; } }",
                             "switch (b) { case 1: for (n = 0; n < 5; n++) { if (b) { in: a = 1; } } }",
                             "for (i = 0; i < 5; i++) { switch (b) { case 1: switch (c) { case 2: in: a = 1; } } }"}) {
    EXPECT_THAT(Errors(std::string("if (a) goto in; ") + around), ElementsAre("3 E033")) << around;
  }
}

TEST(HncLowering, ARefusedRecordIsRefusedOnce) {
  const std::pair<const char*, const char*> records[] = {{"nowhere", "elsewhere"},
                                                         {"*(struct s *)0x1234", "*(struct s *)0x1234"},
                                                         {"a ? r : nowhere", "a ? r : elsewhere"},
                                                         {"(a, nowhere)", "(a, elsewhere)"},
                                                         {"none()", "none()"}};
  for (const auto& [first, second] : records) {
    EXPECT_THAT(
        Errors("struct s { int x, y; } r, t; t = " + std::string(first) + "; r = t; a = (t = " + second + ").x;"),
        testing::SizeIs(2))
        << first;
  }
}

}  // namespace
}  // namespace plcxx::hnc
