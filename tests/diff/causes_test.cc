// plcxx diff: which statements are shown as the cause, and what locations are called.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

std::string ChangedTexts(const std::vector<ItemStatement>& statements) {
  std::string texts;
  for (const ItemStatement& statement : statements) {
    if (statement.changed) texts += statement.text + "\n";
  }
  return texts;
}

TEST(Causes, AConditionAroundAnAssignmentIsShown) {
  const std::string inner = "DOF: I0A4\nW4A0=7\nENDF\nENDF\n";
  const Diff diff = ComparedTexts({"nc110", ".plc"}, "$\nDOF: I0A3\n" + inner, "$\nDOF: I0A3*I0A5\n" + inner);
  ASSERT_EQ(diff.items.size(), 1U);
  EXPECT_EQ(diff.items[0].name, "W4A0");
  EXPECT_EQ(ChangedTexts(diff.items[0].old_statements), "DOF: I0A3\n");
  EXPECT_EQ(ChangedTexts(diff.items[0].new_statements), "DOF: I0A3*I0A5\n");
}

TEST(Causes, AConditionOfACallIsShown) {
  const auto program = [](const std::string& condition) {
    return "#include \"plc.h\"\nvoid work() { Y[0] = X[0]; }\nvoid init() { plc1_time = 1; plc2_time = 1; }\n"
           "void plc1() { if (" +
           condition + ") work(); }\nvoid plc2() { }\n";
  };
  const Diff diff = ComparedTexts({"hnc", ".cld"}, program("X[1]"), program("X[2]"));
  ASSERT_EQ(diff.items.size(), 1U);
  EXPECT_EQ(ChangedTexts(diff.items[0].old_statements), "if (X[1])\n");
}

TEST(Causes, AByteBehindAComputedIndexHasItsNameAndItsScenario) {
  const auto program = [](const std::string& mask) {
    return "#include \"plc.h\"\nstatic void put(int byte, int value) { Y[byte] = value; }\n"
           "void init() { plc1_time = 1; plc2_time = 1; }\nvoid plc1() { put(5, X[0] & " +
           mask + "); put(6, X[1]); }\nvoid plc2() { }\n";
  };
  const Diff diff = ComparedTexts({"hnc", ".cld"}, program("3"), program("7"));
  ASSERT_EQ(diff.items.size(), 1U);
  EXPECT_EQ(diff.items[0].name, "Y[5]");
  ASSERT_TRUE(diff.items[0].counterexample.has_value());
  EXPECT_EQ(diff.items[0].counterexample->replay, Replay::kSimulator);
}

}  // namespace
}  // namespace plcxx::review::diff
