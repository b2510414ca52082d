// plcxx diff: times that stand in declared data, and what they change for a moment only.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

/// A step that takes too long: for one period, since what ends it lets it begin again.
std::string PressWithPreset(const std::string& time_word) {
  return "DDW 40 " + time_word +
         "\n:MOD PM 0\n:O I 0.0\n:ON I 0.0\n:S F 251.0\n:S F 251.1\n:END PM 0\n"
         ":MOD PM 9\n:A I 0.0\n:A I 0.1\n:AN I 3.7\n:S F 2.0\n:A I 1.0\n:O F 8.1\n:R F 2.0\n:A F 2.0\n:SR T 1\n: DW "
         "40\n"
         ":A T 1\n:= F 8.1\n:END PM 9\n"
         ":MOD PM 10\n:A F 8.1\n:= O 0.7\n:END PM 10\n";
}

TEST(DiffPresets, AreFoundInDeclaredData) {
  const Diff diff = ComparedUntilShown({"prostep", ".plc"}, PressWithPreset("3005D"), PressWithPreset("3006D"),
                                       {"O 0.7", "F 8.1", "T 1"});
  for (const char* name : {"O 0.7", "F 8.1", "T 1"}) {
    const DiffItem* const item = ItemNamed(diff, name);
    ASSERT_NE(item, nullptr) << name;
    EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << name;
    EXPECT_TRUE(item->counterexample.has_value()) << name;
  }
}

TEST(Presets, WhatIsShownIsWhatAScenarioSets) {
  // Before init has run, the new version alone has a value in the word; the run sets some bits of it, a scenario all.
  const std::string program = R"(#include "plc.h"
int table[2]@;
void init() { int i; plc1_time = 1; plc2_time = 1; )";
  const std::string parts = R"(}
void plc1() { Y[0] = table[X[0] & 1] == 5; }
void plc2() { }
)";
  const Diff diff = ComparedTexts({"hnc", ".cld"}, With(program, "") + "for (i = 0; i < 2; i++) table[i] = 5; " + parts,
                                  With(program, " = {5, 5}") + parts, {.time_ms = 10'000});
  const DiffItem* const word = ItemNamed(diff, "table[0]");
  ASSERT_NE(word, nullptr) << NamesIn(diff);
  ASSERT_TRUE(word->counterexample.has_value());
  const Counterexample& shown = *word->counterexample;
  EXPECT_EQ(shown.old_value, "5");
  EXPECT_NE(shown.steps.find("table[0]=" + shown.new_value + ","), std::string::npos)
      << shown.steps << ": " << shown.new_value;
}

}  // namespace
}  // namespace plcxx::review::diff
