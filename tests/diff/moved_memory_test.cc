// plcxx diff: a variable that is added moves all that stand behind it, and changes nothing.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

/// An array with computed indices, and a loop of which nobody knows how often it goes round.
std::string CProgram(const std::string& added, const std::string& body) {
  return "#include \"plc.h\"\n" + added +
         "static unsigned int speeds[4];\n"
         "static unsigned int total;\n"
         "void init() { plc1_time = 1; plc2_time = 1; }\n"
         "void plc1() {\n"
         "  unsigned int n;\n"
         "  n = 0;\n"
         "  while (n < X[0]) { total += speeds[n & 3]; n++; }\n"
         "  speeds[X[1] & 3] = X[2];\n" +
         body +
         "}\n"
         "void plc2() { }\n";
}

TEST(MovedMemory, AVariableOfCMovesArraysAndWhatLoopsRead) {
  const std::string same = "  Y[0] = total & 255;\n";
  const Diff moved =
      ComparedTexts({"hnc", ".cld"}, CProgram("", same), CProgram("static unsigned char added;\n", same));
  EXPECT_EQ(NamesIn(moved), "");
  const Diff changed = ComparedTexts({"hnc", ".cld"}, CProgram("", same),
                                     CProgram("static unsigned char added;\n", "  Y[0] = total & 127;\n"));
  EXPECT_EQ(NamesIn(changed), "Y[0] ");
  EXPECT_EQ(changed.items.front().verdict, ItemVerdict::kDifferent);
}

TEST(MovedMemory, TwoArraysOfOneShapeThatChangePlacesStayWhatTheyAre) {
  const std::string loop =
      "void init() { plc1_time = 1; plc2_time = 1; }\n"
      "void plc1() {\n"
      "  unsigned char i;\n"
      "  for (i = 0; i < 4; i++) { a[i] += X[i]; b[i] -= X[i]; }\n"
      "  Y[0] = a[1];\n"
      "}\n"
      "void plc2() { }\n";
  const std::string include = "#include \"plc.h\"\n";
  const Diff diff = ComparedTexts({"hnc", ".cld"}, include + "unsigned char a[4], b[4];\n" + loop,
                                  include + "unsigned char b[4], a[4];\n" + loop);
  EXPECT_EQ(NamesIn(diff), "");
  // The other array is another one, though it lies where the first one was.
  std::string other = loop;
  other.replace(other.find("a[1]"), 1, "b");
  const Diff changed = ComparedTexts({"hnc", ".cld"}, include + "unsigned char a[4], b[4];\n" + loop,
                                     include + "unsigned char b[4], a[4];\n" + other);
  EXPECT_EQ(NamesIn(changed), "Y[0] ");
}

TEST(MovedMemory, WhatIsNoLongerKeptWithoutPowerIsADifference) {
  // The name stands at an address beyond those that the control keeps: the old address is kept all the same, and
  // unused.
  const std::string counts = R"(SYMBOLS
@ PARTS
END_SYMBOLS
SLOW
NETWORK "parts"
LDP %I0
ADDW PARTS, 1, PARTS
LD 1
COMP PARTS > 3
OUT %Q0
END_SLOW
)";
  const std::string kept = With(counts, "%W10");
  EXPECT_EQ(NamesIn(ComparedTexts(kHost50, kept, kept)), "");
  const Diff diff = ComparedTexts(kHost50, kept, With(counts, "%W110"), {.time_ms = 20'000});
  const DiffItem* const word = ItemNamed(diff, "W10");
  ASSERT_NE(word, nullptr) << NamesIn(diff);
  EXPECT_EQ(word->verdict, ItemVerdict::kDifferent);
  EXPECT_TRUE(word->counterexample.has_value());
}

TEST(MovedMemory, AnEdgeByHandIsPairedWithTheFlagThatIsLookedAtLater) {
  // The first flag holds the same as the last one after each pass, and is written anew before it is read.
  const std::string counts = "  W4T0 = [W4T0+1]\nENDF\n";
  const std::string one_shot = "$\nP33 = I4K18*[W3K0=30H]\nDOF: P33\n" + counts,
                    by_hand =
                        "$\nU110K0 = I4K18*[W3K0=30H]\nU110K1 = U110K0*/U110K2\nU110K2 = U110K0\n"
                        "DOF: U110K1\n" +
                        counts;
  EXPECT_EQ(NamesIn(ComparedTexts(kNc110, one_shot, by_hand, {.time_ms = 20'000})), "");
  const std::string late =
      With("$\nU110K0 = I4K18*[W3K0=30H]\nU110K2 = U110K0\n@DOF: U110K1\n" + counts, "U110K1 = U110K0*/U110K2\n");
  EXPECT_NE(NamesIn(ComparedTexts(kNc110, one_shot, late, {.time_ms = 20'000})), "");
}

}  // namespace
}  // namespace plcxx::review::diff
