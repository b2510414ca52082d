// What the lowering of hnc knows of pointers, selectors and counters, where it decides on checks, bounds and periods.

#include <string>
#include <vector>

#include "hnc_lowered.h"

namespace plcxx::hnc {
namespace {

/// Whether an access of plc1() with these statements is checked when it is executed.
bool IsChecked(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements(statements));
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << statements << testing::PrintToString(lowered.Reported());
  const std::vector<std::string> lines = lowered.Routine("plc1");
  return std::ranges::any_of(lines, [](const std::string& line) { return line.starts_with("call record_fault"); });
}

TEST(HncKnownBounds, APointerKeepsWhatIsKnownOfTheIndexInIt) {
  const std::string inside = "int *p; if (b < 1 || b > 3) return; p = &table[b]; ";
  EXPECT_FALSE(IsChecked(inside + "a = p[-1];"));
  EXPECT_FALSE(IsChecked(inside + "a = p[4];"));
  EXPECT_TRUE(IsChecked(inside + "a = p[-2];"));
  EXPECT_TRUE(IsChecked(inside + "a = p[5];"));
  const std::string around = "int *p; if (b < -2 || b > 2) return; p = table + 4 + b; ";
  EXPECT_FALSE(IsChecked(around + "a = p[-2];"));
  EXPECT_FALSE(IsChecked(around + "a = p[1];"));
  EXPECT_TRUE(IsChecked(around + "a = p[-3];"));
  EXPECT_TRUE(IsChecked(around + "a = p[2];"));
}

// Of an element and of a byte in it: what is known of both is counted in bytes.
TEST(HncKnownBounds, BytesOfElementsAreCountedInBytes) {
  const std::string around = "if (b < -2 || b > 2) return; ";
  EXPECT_TRUE(IsChecked(around + "a = ((unsigned char *)(table + b))[X[0] & 3];"));
  EXPECT_TRUE(IsChecked(around + "a = ((unsigned char *)(table + 1 + b))[X[0] & 3];"));
  EXPECT_FALSE(IsChecked(around + "a = ((unsigned char *)(table + 2 + b))[X[0] & 3];"));
  EXPECT_FALSE(IsChecked(around + "a = ((unsigned char *)(table + 4 + b))[X[0] & 3];"));
  EXPECT_TRUE(IsChecked(around + "a = ((unsigned char *)(table + 5 + b))[X[0] & 3];"));
}

TEST(HncKnownBounds, OfAPointerThatMayBe0TheAccessIsChecked) {
  EXPECT_TRUE(IsChecked("int *p; p = 0; if (b) p = &table[1]; a = *p;"));
  EXPECT_TRUE(IsChecked("int *p; p = table; if (b) p = 0; a = *p;"));
  EXPECT_FALSE(IsChecked("int *p; p = table; if (b) p = &table[1]; a = *p;"));
}

// Each kind of loop, with the counter k: a local keeps what is known of it, a global may be forced to anything.
TEST(HncKnownBounds, ACounterThatMayBeForcedIsNoProofOfAnIndex) {
  for (const std::string loop : {
           "for (k = 0; k < 8; k++) table[k] = 1;",
           "for (k = 7; k >= 0; k--) table[k] = 1;",
           "k = 0; while (k < 8) { table[k] = 1; k++; }",
           "k = 0; do { table[k] = 1; k++; } while (k < 8);",
           "k = 7; do { table[k] = 1; k -= 3; } while (k > 0);",
       }) {
    EXPECT_FALSE(IsChecked("int k; " + loop)) << loop;
    std::string global = loop;
    std::ranges::replace(global, 'k', 'n');
    EXPECT_TRUE(IsChecked(global)) << global;
  }
}

TEST(HncKnownBounds, ASelectorThatTheSwitchChangesIsNotItsLabel) {
  EXPECT_FALSE(IsChecked("switch (b) { case 7: a = table[b]; break; }"));
  EXPECT_TRUE(IsChecked("switch (b++) { case 7: a = table[b]; break; }"));  // 8 by then
  EXPECT_TRUE(IsChecked("switch (b--) { case 0: a = table[b]; break; }"));
  EXPECT_TRUE(IsChecked("switch (b += 1) { case 8: a = table[b]; break; }"));
}

TEST(HncKnownBounds, WhatIsKnownInFrontOfALabelWithAWayBackIsKnownAfterIt) {
  const std::string known = "int k; k = 5; i = 0; ", access = "a = table[k];";
  EXPECT_FALSE(IsChecked(known + "again: i++; if (i < 4) goto again; " + access));
  // A jump back that is reached past the label brings what is known where it was entered: nothing is taken from there.
  EXPECT_TRUE(IsChecked(known + "if (X[0]) { k = 70; goto in; } again: i++; in: if (i < 4) goto again; " + access));
  EXPECT_TRUE(IsChecked(known + "if (X[0]) goto in; again: i++; in: if (i < 4) goto again; " + access));
  // What changes it further down is not repeated.
  EXPECT_FALSE(IsChecked(known + "again: i++; if (i < 4) goto again; " + access + " for (n = 0; n < 3; n++) k += 9;"));
  EXPECT_TRUE(IsChecked(known + "again: i++; k = i; if (i < 4) goto again; k += 5; " + access));
}

// What a store says of a cell in memory counts in a comparison, too: else the loop may have 65537 iterations.
TEST(HncKnownBounds, AComparisonNarrowsWhatWasStored) {
  const auto reported = [](const std::string& statements) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements(statements));
    return lowered.Reported();
  };
  EXPECT_THAT(reported("a = X[0] & 7; if (a != 0) do a--; while (a != 0);"), testing::Not(testing::Contains("3 W7")));
  EXPECT_THAT(reported("a = X[0] & 7; do a--; while (a != 0);"), testing::Contains("3 W7"));
}

/// Whether table[f() - 1] is checked where f() is left in these ways.
bool IsCheckedBehind(const std::string& ways) {
  LoweredProgram lowered;
  LowerInto(lowered, "#include \"plc.h\"\nint a, table[8];\nint f() { " + ways +
                         " }\nvoid plc1() { a = table[f() - 1]; }\nvoid plc2() { }\n"
                         "void init() { plc1_time = 16; plc2_time = 32; }\n");
  const std::vector<std::string> lines = lowered.Routine("plc1");
  return std::ranges::any_of(lines, [](const std::string& line) { return line.starts_with("call record_fault"); });
}

TEST(HncKnownBounds, AFunctionThatIsLeftWithoutAValueMayGive0) {
  EXPECT_FALSE(IsCheckedBehind("if (X[0]) return 1; return 8;"));
  EXPECT_TRUE(IsCheckedBehind("if (X[0]) return 1; return 9;"));
  EXPECT_TRUE(IsCheckedBehind("if (X[0]) return; return 5;"));
  EXPECT_TRUE(IsCheckedBehind("if (X[0]) return 5; return;"));
  EXPECT_TRUE(IsCheckedBehind("if (X[0]) return 5;"));
}

/// The period of the fast part that a program with this text around it promises.
uint32_t FastEvery(const std::string& more, const std::string& init = "plc1_time = 16; plc2_time = 32;") {
  LoweredProgram lowered;
  LowerInto(lowered,
            "#include \"plc.h\"\n" + more + "void init() { " + init + " }\nvoid plc1() { }\nvoid plc2() { }\n");
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << testing::PrintToString(lowered.Reported());
  return lowered.program().schedule.fast_every_ms;
}

TEST(HncKnownBounds, ThePeriodIsThatOfFunctionsThatAreCalled) {
  EXPECT_EQ(FastEvery(""), 16U);
  EXPECT_EQ(FastEvery("void set() { plc1_time = 48; }\n", "set(); plc2_time = 32;"), 48U);
  EXPECT_EQ(FastEvery("void never() { plc1_time = 48; }\n"), 16U);
  EXPECT_EQ(FastEvery("void never() { plc1_time = P[0]; }\n"), 16U);
  EXPECT_EQ(FastEvery("void set() { plc1_time = P[0]; }\n", "set(); plc2_time = 32;"), 0U);
}

// Where a signed number is known not to be negative it is widened as if it had no sign: that is a fact.
TEST(HncKnownBounds, ThatANumberIsNotNegativeIsAFactWhereItIsWidened) {
  const auto facts = [](const std::string& statements) {
    LoweredProgram lowered;
    LowerInto(lowered, WithStatements("int k = X_i[0]; { " + statements + " }"), {}, ir::Facts::kChecked);
    const std::vector<std::string> lines = lowered.Routine("plc1");
    return std::ranges::count_if(lines, [](const std::string& line) { return line.find("false_fact") != line.npos; });
  };
  EXPECT_EQ(facts("l = k;"), 0);
  EXPECT_GT(facts("long w = X_l[0]; if (w < 0 || w > 7) return; table[w] = 1;"), 0);
  EXPECT_EQ(facts("if (k < 0) return; l = k;"), facts("if (k < 0) return; i = k;") + 1);
}

// 6.5: an address of a local is refused, not that of a string or of an area of the same number.
TEST(HncKnownBounds, OnlyTheAddressOfALocalIsTakenForOne) {
  constexpr int kTables = 14, kStrings = 10;
  std::string text = "#include \"plc.h\"\nchar *kept;\n";
  for (int table = 0; table < kTables; ++table) {
    text += "char *const t" + std::to_string(table) + "[] = {";
    for (int i = 0; i < kStrings; ++i) text += "\"s" + std::to_string(table * kStrings + i) + "\", ";
    text += "};\n";
  }
  std::string calls;
  for (int table = 0; table < kTables; ++table) {
    const std::string number = std::to_string(table);
    text += "char *f" + number +
            "(int i) { int a, b, c, d, e, f, g, h, k; a = b = c = d = e = f = g = h = k = i; "
            "return t" +
            number + "[a + b + c + d + e + f + g + h + k & 7]; }\n";
    calls += "R[" + number + "] = *f" + number + "(X[0]); ";
  }
  LoweredProgram lowered;
  LowerInto(lowered, text +
                         "unsigned char *area() { int n; n = X[0]; return &R[n]; }\nvoid init() { plc1_time = 16; "
                         "plc2_time = 32; }\nvoid plc1() { " +
                         calls + "*area() = 1; }\nvoid plc2() { }\n");
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << testing::PrintToString(lowered.Reported());
  EXPECT_THAT(Errors("int k; static int *p; p = &k; k = *p;"), testing::ElementsAre("3 E049"));
}

TEST(HncKnownBounds, TheAreasOfInputsAndOutputsAreWholeAreas) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements("Y[0] = X[0];"));
  size_t areas = 0;
  for (const ir::Space& space : lowered.program().spaces) {
    if (space.name.size() != 1) continue;
    ++areas;
    ASSERT_FALSE(space.zones.empty()) << space.name;
    EXPECT_EQ(space.zones.front().begin, 0U) << space.name;
    EXPECT_EQ(space.zones.front().end, 8 * space.bytes) << space.name;
    const bool input = space.name == "X" || space.name == "F" || space.name == "P";
    const bool output = space.name == "Y" || space.name == "G";
    EXPECT_EQ(space.zones.front().direction, input    ? ir::Direction::kInput
                                             : output ? ir::Direction::kOutput
                                                      : ir::Direction::kInternal)
        << space.name;
    // What the control writes, too, is said beside it, and only of the commands to the NC.
    for (size_t i = 1; i < space.zones.size(); ++i) EXPECT_EQ(space.name, "G") << space.zones[i].begin;
  }
  EXPECT_EQ(areas, 7U);  // 5.1: X Y R F G P B
}

}  // namespace
}  // namespace plcxx::hnc
