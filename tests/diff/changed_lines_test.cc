// plcxx diff: of a statement of several lines the one that was changed is shown, wherever else such a line stands.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

std::string Changed(const std::vector<ItemStatement>& statements) {
  std::string text;
  for (const ItemStatement& statement : statements) {
    if (statement.changed) text += std::to_string(statement.line) + ": " + statement.text;
  }
  return text;
}

std::string Program(const std::string& lines) {
  return "        DATA\n"
         "IN0: DFM A,B,C\n"
         "OUT0: DFM P,Q\n"
         "        DATA_END\n"
         "        MODULE_MAIN\n"
         "        LDR B\n"
         "        LA C\n"
         "        LO A\n"
         "        WR P\n" +
         lines +
         "        WR Q\n"
         "        MODULE_MAIN_END\n"
         "        STOP\n";
}

TEST(ChangedLines, AnotherStatementHasBothLines) {
  const Diff diff = ComparedTexts(kTechnol, Program("        LDR A\n        LA B\n        LA C\n"),
                                  Program("        LDR A\n        LA B\n        LO A\n"));
  const DiffItem* const item = ItemNamed(diff, "Q");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(Changed(item->old_statements), "12: LA C");
  EXPECT_EQ(Changed(item->new_statements), "12: LO A");
}

TEST(ChangedLines, ALineThatWasTakenOut) {
  const Diff diff = ComparedTexts(kTechnol, Program("        LDR A\n        LA B\n        LA C\n"),
                                  Program("        LDR A\n        LA B\n"));
  const DiffItem* const item = ItemNamed(diff, "Q");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(Changed(item->old_statements), "12: LA C");
  EXPECT_EQ(Changed(item->new_statements), "10: LDR A");
}

/// A rung says in other lines what its boxes compare and how long its timers wait, a page what its transitions do.
std::string Project(const std::string& expression, const std::string& timer, const std::string& transitions,
                    const std::string& steps = "S0,1,1,0,1,1\nS1,0,2,0,1,3\n") {
  return "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n001,1,-1,0,0,0\n_/FILE-sections.csv\n"
         "_FILE-timers_iec.csv\n1,9,0\n" +
         timer + "\n_/FILE-timers_iec.csv\n_FILE-arithmetic_expressions.csv\n#VER=2.0\n0000,@270/1@<9\n0001," +
         expression + "\n_/FILE-arithmetic_expressions.csv\n_FILE-sequential.csv\n#VER=1.0\n" + steps + transitions +
         "_/FILE-sequential.csv\n_FILE-rung_0.csv\n"
         "99-0-0/0 , 99-0-0/0 , 20-0-0/1 , 50-0-60/0\n"
         "1-0-50/0 , 99-0-0/0 , 13-0-0/1 , 50-0-60/1\n"
         "99-0-0/0 , 99-0-0/0 , 20-0-0/0 , 50-0-60/2\n"
         "1-0-30/2 , 50-0-60/3\n"
         "_/FILE-rung_0.csv\n_/FILES_CLASSICLADDER\n";
}

std::string Transition(const std::string& number, const std::string& begins, const std::string& ends,
                       const std::string& condition) {
  const std::string none = ",-1,-1,-1,-1,-1,-1,-1,-1,-1";
  std::string links;
  for (int i = 0; i < 20; ++i) links += ",-1";
  return "T" + number + "," + begins + none + "," + ends + none + links + ",0,1,2\nC" + number + ",0," + condition +
         "\n";
}

/// The changed statements as "old / new", whatever else is found out in a moment.
std::string Shown(const std::string& old_text, const std::string& new_text) {
  const Diff diff = ComparedTexts(kClassicladder, old_text, new_text, {.time_ms = 1000});
  return Changed(diff.old_statements) + " / " + Changed(diff.new_statements);
}

TEST(ChangedLines, OfARungTheExpressionOfItsBox) {
  EXPECT_EQ(Shown(Project("@270/0@=5", "1,3,0", ""), Project("@270/0@>=5", "1,3,0", "")), "13: %IW0=5 / 13: %IW0>=5");
}

TEST(ChangedLines, OfARungTheBaseOfItsTimer) {
  EXPECT_EQ(Shown(Project("@270/0@=5", "1,3,0", ""), Project("@270/0@=5", "2,3,0", "")), "8: 1,3,0 / 8: 2,3,0");
}

TEST(ChangedLines, OfAPageTheTransition) {
  const std::string back = Transition("1", "0", "1", "50/2");
  const auto page = [&](const std::string& first) { return Project("@270/0@=5", "1,3,0", first + back); };
  EXPECT_EQ(Shown(page(Transition("0", "1", "0", "50/0")), page(Transition("0", "1", "0", "50/1"))),
            "20: C0: %I0 / 20: C0: %I1");
  EXPECT_EQ(Shown(page(Transition("0", "1", "0", "50/0")), page(Transition("0", "1", "-1", "50/0"))),
            "19: T0: S0 -> S1 / 19: T0: nothing -> S1");
}

TEST(ChangedLines, OfAPageTheStep) {
  const auto page = [](const std::string& steps, const std::string& condition = "50/0") {
    const std::string both = Transition("0", "1", "0", condition) + Transition("1", "0", "1", "50/2");
    return Project("@270/0@=5", "1,3,0", both, steps);
  };
  const std::string plain = page("S0,1,1,0,1,1\nS1,0,2,0,1,3\n");
  EXPECT_EQ(Shown(plain, page("S0,1,1,0,1,1\nS1,0,7,0,1,3\n")), "18: S1: %X2 / 18: S1: %X7");
  EXPECT_EQ(Shown(plain, page("S0,0,1,0,1,1\nS1,0,2,0,1,3\n")), "17: S0: %X1, initial / 17: S0: %X1");
  // Where it is drawn changes nothing, and is not what is quoted when something else is changed.
  EXPECT_EQ(Shown(plain, page("S0,1,1,0,5,1\nS1,0,2,0,5,3\n")), " / ");
  EXPECT_EQ(Shown(plain, page("S0,1,1,0,5,1\nS1,0,2,0,5,3\n", "50/1")), "20: C0: %I0 / 20: C0: %I1");
}

/// Memory that no scenario can name is where a page keeps its steps: runs show it all the same, and nothing is open.
TEST(ChangedLines, WhatOnlyTheControlSeesIsShownToDiffer) {
  const std::string back = Transition("1", "0", "1", "50/2");
  const auto page = [&](const std::string& condition) {
    return Project("@270/0@=5", "1,3,0", Transition("0", "1", "0", condition) + back);
  };
  const Diff diff = ComparedUntilShown(kClassicladder, page("50/0"), page("50/1"), {"step0_active", "step1_ms"});
  for (const char* const name : {"step0_active", "step1_active", "step0_ms", "step1_ms"}) {
    const DiffItem* const item = ItemNamed(diff, name);
    ASSERT_NE(item, nullptr) << NamesIn(diff);
    EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << name;
    ASSERT_TRUE(item->counterexample) << name;
    EXPECT_EQ(item->counterexample->scenario, "") << name;
    EXPECT_NE(item->counterexample->old_value, item->counterexample->new_value) << name;
  }
}

}  // namespace
}  // namespace plcxx::review::diff
