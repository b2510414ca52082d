// A new mnemonic is its row and its lowering.
#include "tests/policy/rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Rows, AreNamedInOneSource) {
  const Findings findings = CheckRows(Root(), ReadFile(Root() + "/tests/policy/rows.txt"));
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

TEST(Rows, FixtureNamesSomeInTwo) {
  const std::string table = "table transpiler/dialects/small/machine.def SMALL_INSTRUCTION Op\n";
  EXPECT_THAT(CheckRows(Fixture("rows"), table),
              ElementsAre("And of transpiler/dialects/small: named in 2 sources lowering.cc warnings.cc"));
  EXPECT_THAT(CheckRows(Fixture("rows"), table + "transpiler/dialects/small And 2\n"), IsEmpty());
  EXPECT_THAT(
      CheckRows(Fixture("rows"),
                table + "transpiler/dialects/small And 3\ntranspiler/dialects/small Gone 2\nand more words here\n"),
      ElementsAre("rows.txt: cannot be read: and more words here",
                  HasSubstr("And of transpiler/dialects/small: named in 2 sources; shorten"),
                  HasSubstr("Gone of transpiler/dialects/small: has no row")));
}

TEST(Rows, ATableWithoutRowsFails) {
  EXPECT_THAT(CheckRows(Fixture("rows"), ""), ElementsAre("rows.txt: no table"));
  EXPECT_THAT(CheckRows(Fixture("rows"), "table transpiler/dialects/small/machine.def OTHER Op\n"),
              ElementsAre("transpiler/dialects/small/machine.def has no OTHER"));
}

}  // namespace
}  // namespace plcxx::policy
