// plcxx diff: what follows from a change is folded under it, and rows of locations are ranges.
#include "transpiler/review/diff/groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/diff/compared_texts.h"
#include "transpiler/driver/diff_output.h"
#include "transpiler/driver/diff_told_runs.h"

namespace plcxx::review::diff {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Groups, RowsOfNamesAreRanges) {
  EXPECT_EQ(NamesAsRanges({"F byte 0", "F byte 1", "F byte 2", "F byte 3", "Y[5]"}), "F byte 0..3, Y[5]");
  EXPECT_EQ(NamesAsRanges({"G[7]", "G[8]", "G[9]", "G[11]"}), "G[7..9], G[11]");
  EXPECT_EQ(NamesAsRanges({"U4A0", "U4A1"}), "U4A0, U4A1");
  EXPECT_EQ(NamesAsRanges({"DB 10", "DB 11", "DB 12"}), "DB 10..12");
  EXPECT_EQ(NamesAsRanges({"a", "b"}), "a, b");
  EXPECT_EQ(NamesAsRanges({"LABEL_MEM+5:8", "LABEL_MEM+6:8", "LABEL_MEM+7:8", "LABEL_MEM+8:16"}),
            "LABEL_MEM+5..7:8, LABEL_MEM+8:16");
  EXPECT_EQ(NamesAsRanges({"T5.done", "T6.done", "T7.done", "T7.timing"}), "T5..7.done, T7.timing");
  EXPECT_EQ(NamesAsRanges({"Y1.6", "Y1.7", "Y2.7", "Y3.7"}), "Y1.6, Y1..3.7");
}

TEST(Groups, OfManyRangesTheFirstOnesAreNamed) {
  std::vector<std::string> names;
  for (int i = 0; i < 60; ++i) names.push_back("G[" + std::to_string(3 * i) + "]");
  EXPECT_THAT(NamesAsRanges(names), testing::EndsWith(", G[69] and 36 more ranges"));
}

DiffItem Item(const std::string& name, ItemKind kind, ItemVerdict verdict, std::vector<std::string> through) {
  return {.name = name,
          .kind = kind,
          .verdict = verdict,
          .changed_itself = through.empty(),
          .through = std::move(through),
          .reason = verdict == ItemVerdict::kUndecided ? "nobody knows" : ""};
}

Diff Pump() {
  Diff diff{.changes_are_found = true};
  diff.items.push_back(Item("U4A0", ItemKind::kOutput, ItemVerdict::kUndecided, {"U100K0"}));
  diff.items.push_back(Item("U4A1", ItemKind::kOutput, ItemVerdict::kUndecided, {"U4A0"}));
  diff.items.push_back(Item("U4A2", ItemKind::kOutput, ItemVerdict::kUndecided, {"U4A1", "U4A0"}));
  diff.items.push_back(Item("U4A9", ItemKind::kOutput, ItemVerdict::kDifferent, {"U100K0"}));
  diff.items.push_back(Item("U100K0", ItemKind::kInternal, ItemVerdict::kDifferent, {}));
  diff.items.back().old_statements = {
      {.statement = ir::StatementId(3), .file = "p.plc", .line = 7, .text = "U100K0 = 1", .changed = true}};
  return diff;
}

TEST(Groups, WhatFollowsIsFoldedUnderItsCause) {
  const Diff diff = Pump();
  const std::vector<DiffGroup> groups = GroupsOf(diff);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(NamesOf(groups[0]), "U4A9");
  EXPECT_EQ(NamesOf(groups[1]), "U4A0..2");
  EXPECT_THAT(groups[1].causes, ElementsAre("U100K0"));
  EXPECT_EQ(NamesOf(groups[2]), "U100K0");
  EXPECT_TRUE(groups[2].causes.empty());
}

/// A row of registers that a computed index reaches: each reads all others.
TEST(Groups, ManyThatReadEachOtherAreOneGroup) {
  Diff diff;
  std::vector<std::string> names;
  for (int i = 0; i < 9; ++i) names.push_back("G[" + std::to_string(i) + "]");
  for (const std::string& name : names) {
    std::vector<std::string> others = names;
    std::erase(others, name);
    diff.items.push_back(Item(name, ItemKind::kOutput, ItemVerdict::kUndecided, std::move(others)));
  }
  const std::vector<DiffGroup> groups = GroupsOf(diff);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(NamesOf(groups[0]), "G[0..8]");
}

/// Of each kind one line, with all that they may follow from, though each follows from something else.
TEST(Groups, ManyUndecidedOnesOfOneKindAreOneGroup) {
  Diff diff{.changes_are_found = true};
  for (const char* const cause : {"a", "b", "c"}) {
    diff.items.push_back(Item("U_" + std::string(cause), ItemKind::kOutput, ItemVerdict::kUndecided, {cause}));
    diff.items.push_back(Item(cause, ItemKind::kInternal, ItemVerdict::kUndecided, {}));
  }
  std::vector<DiffGroup> groups = GroupsOf(diff);
  ASSERT_FALSE(groups.empty());
  EXPECT_EQ(NamesOf(groups[0]), "U_a, U_b, U_c");
  EXPECT_THAT(groups[0].causes, ElementsAre("a", "b", "c"));
  // Nobody looked which have a change of their own: then nothing is claimed.
  diff.changes_are_found = false;
  groups = GroupsOf(diff);
  EXPECT_EQ(NamesOf(groups[0]), "U_a, U_b, U_c");
  EXPECT_THAT(groups[0].causes, testing::IsEmpty());
}

/// A reader reads a run once, and then what another one adds to it.
TEST(Groups, EachRunIsToldOnce) {
  const std::string start = "W0A0=7FH, W0A1=7FH, I6K21=1, slow 1, !KEYON=0, 1500 ms, I0K2=1, slow 1";
  DiffGroup group;
  std::vector<DiffItem> items;
  const auto add = [&](const std::string& name, const std::string& steps, const std::string& value) {
    items.push_back(Item(name, ItemKind::kOutput, ItemVerdict::kDifferent, {"a"}));
    items.back().counterexample = Counterexample{
        .scenario = "x", .steps = steps, .old_value = value, .new_value = "0", .replay = Replay::kSimulator};
  };
  add("U4A1", start, "1");
  add("U4A2", start + ", 500 ms", "1");
  add("U4A3", start + ", 500 ms", "1");
  add("U4A4", start + ", 500 ms", "1");
  add("W4K0", start + ", 500 ms", "12");
  add("U4A9", "I0A0=1, slow 1", "1");
  for (const DiffItem& item : items) group.items.push_back(&item);
  driver::ToldRuns runs;
  EXPECT_THAT(runs.Of(group),
              ElementsAre("U4A1: " + start + ": 1 in the old version, 0 in the new one",
                          "U4A2..4: after the run of U4A1, then 500 ms: 1 in the old version, 0 in the new one",
                          "W4K0: after the same run: 12 in the old version, 0 in the new one",
                          "U4A9: I0A0=1, slow 1: 1 in the old version, 0 in the new one"));
  group.items = {&items.front()};
  EXPECT_THAT(runs.Of(group), ElementsAre("after the run of U4A1: 1 in the old version, 0 in the new one"));
}

TEST(Groups, TheChangesStandInFrontWhereTheFirstDifferenceDoesNotShowThem) {
  Diff diff = Pump();
  diff.old_statements = diff.items.back().old_statements;
  const driver::DiffNames names{"a", "b"};
  EXPECT_THAT(driver::DiffText(diff, names, diag::Colour::kOff),
              HasSubstr("\n\nChanged\n      old * p.plc:7  U100K0 = 1\n\nOutputs\n"));
  EXPECT_THAT(driver::DiffMarkdown(diff, names), HasSubstr("```diff\n- p.plc:7  U100K0 = 1\n```\n"));
  EXPECT_EQ(driver::ChangesAsPatch(diff), "- p.plc:7  U100K0 = 1\n");
  std::ranges::rotate(diff.items, diff.items.end() - 1);
  diff.items.front().kind = ItemKind::kOutput;
  EXPECT_EQ(driver::ChangesAsPatch(diff), "");
}

TEST(Groups, EachFormSaysThem) {
  const Diff diff = Pump();
  const driver::DiffNames names{"a", "b"};
  const std::string text = driver::DiffText(diff, names, diag::Colour::kOff);
  EXPECT_THAT(text, HasSubstr("  U4A0..2 (3)  not decided, at most through U100K0; nobody knows\n"));
  EXPECT_THAT(text, HasSubstr("      old * p.plc:7  U100K0 = 1\n"));
  EXPECT_THAT(text, Not(HasSubstr("  U4A1")));
  EXPECT_THAT(driver::DiffMarkdown(diff, names),
              HasSubstr("| `U4A0..2` (3) | not decided, at most through U100K0; nobody knows |"));
  EXPECT_THAT(driver::DiffSarif(diff, names), HasSubstr("U4A0..2 (3) are not proved to behave as before"));
  const std::string json = driver::DiffJson(diff, names);
  EXPECT_THAT(json, HasSubstr("\"names\": \"U4A0..2\""));
  EXPECT_THAT(json, HasSubstr("\"name\": \"U4A1\""));
}

}  // namespace
}  // namespace plcxx::review::diff
