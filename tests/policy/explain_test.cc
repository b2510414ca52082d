// Every code has a page, and every page tells the truth.
#include "tests/policy/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/explain.h"

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Explain, EveryCodeHasItsPage) {
  std::set<std::string> codes;
  for (const diag::Row& row : diag::Catalogue()) codes.emplace(row.code);
  std::vector<std::string> pages;
  for (const std::string_view code : diag::ExplainedCodes()) pages.emplace_back(code);
  EXPECT_THAT(CheckPagesExist({codes.begin(), codes.end()}, pages), IsEmpty());
}

TEST(Explain, FixtureOfCodesIsIncomplete) {
  EXPECT_THAT(CheckPagesExist({"nc110-1", "nc110-2"}, {"nc110-2", "nc110-999"}),
              ElementsAre("nc110-1: no page in explain/", "nc110-999: no code of the catalogue"));
}

TEST(Explain, ProgramsOfThePagesDoWhatThePagesSay) {
  Findings findings;
  for (const std::string_view code : diag::ExplainedCodes()) {
    for (std::string& finding : CheckPage(std::string(code), *diag::Explain(code))) findings.push_back(finding);
  }
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

TEST(Explain, FixtureTellsLies) {
  const std::string page = ReadFile(Fixture("explain/nc110-1.md"));
  ASSERT_FALSE(page.empty());
  EXPECT_THAT(CheckPage("nc110-1", page), ElementsAre(HasSubstr("nc110-1.md:5: the wrong program gives: "),
                                                      HasSubstr("nc110-1.md:10: the right program gives: nc110-1"),
                                                      HasSubstr("nc110-1.md:15: a fence that is neither")));
  EXPECT_THAT(CheckPage("nc110-2", page), testing::Contains(HasSubstr("nc110-2.md:1: expected '# nc110-2: title'")));
  EXPECT_THAT(CheckPage("nc110-3", "# nc110-3: title\n\nWords.\n"), ElementsAre(HasSubstr("neither a wrong program")));
}

}  // namespace
}  // namespace plcxx::policy
