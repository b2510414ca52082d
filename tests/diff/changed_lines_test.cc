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

}  // namespace
}  // namespace plcxx::review::diff
