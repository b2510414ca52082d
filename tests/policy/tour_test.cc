// What the README shows is what happens.
#include "tests/policy/tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string ToolDirectory() { return std::filesystem::path(PLCXX_BINARY).parent_path().string(); }

TEST(Tour, ReadmeIsTrue) {
  const Findings findings = RunTour("README.md", ReadFile(Root() + "/README.md"), ToolDirectory());
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

TEST(Tour, GuideIsTrue) {
  const std::vector<std::string> pages = FilesBelow(Root(), "docs", {".md"});
  EXPECT_GE(pages.size(), 7u);
  for (const std::string& page : pages) {
    if (page == "docs/evidence.md") continue;  // figures of runs: ctest `evidence` compares them with their record
    const Findings findings = RunTour(page, ReadFile(Root() + "/" + page), ToolDirectory());
    EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
  }
}

TEST(Tour, FixtureIsNot) {
  EXPECT_THAT(RunTour("tour.md", ReadFile(Fixture("tour/tour.md")), ToolDirectory()),
              ElementsAre(HasSubstr("tour.md:4: exit code 1"), HasSubstr("tour.md:8: 'two' where 'three'"),
                          HasSubstr("tour.md:11: also 'two'"), HasSubstr("tour.md:13: nothing where 'four'")));
}

}  // namespace
}  // namespace plcxx::policy
