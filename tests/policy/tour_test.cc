// What the README shows is what happens.
#include "tests/policy/tour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

namespace plcxx::policy {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string ToolDirectory() { return std::filesystem::path(PLCXX_BINARY).parent_path().string(); }

TEST(Tour, ReadmeIsTrue) {
  const Findings findings = RunTour("README.md", ReadFile(Root() + "/README.md"), ToolDirectory());
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

/// Every page of docs, each a test of its own: they are dealt out to what runs at the same time.
class Guide : public testing::TestWithParam<std::string> {};

TEST_P(Guide, IsTrue) {
  const Findings findings = RunTour(GetParam(), ReadFile(Root() + "/" + GetParam()), ToolDirectory());
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

std::vector<std::string> Pages() {
  std::vector<std::string> pages = FilesBelow(Root(), "docs", {".md"});
  std::erase(pages, "docs/evidence.md");  // figures of runs: ctest `evidence` compares them with their record
  // How an editor is set up; what it loads is run by tests/editors.
  std::erase_if(pages, [](const std::string& page) { return page.starts_with("docs/editors/"); });
  return pages;
}

INSTANTIATE_TEST_SUITE_P(Pages, Guide, testing::ValuesIn(Pages()), [](const auto& page) {
  std::string name = page.param;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
});

TEST(Tour, EveryDialectHasATutorial) {
  const std::vector<std::string> pages = Pages();
  for (const char* dialect : {"hnc", "host50", "nc110", "prostep", "technol"})
    EXPECT_THAT(pages, Contains("docs/tutorials/" + std::string(dialect) + ".md"));
}

TEST(Tour, FixtureIsNot) {
  EXPECT_THAT(RunTour("tour.md", ReadFile(Fixture("tour/tour.md")), ToolDirectory()),
              ElementsAre(HasSubstr("tour.md:4: exit code 1"), HasSubstr("tour.md:8: 'two' where 'three'"),
                          HasSubstr("tour.md:11: also 'two'"), HasSubstr("tour.md:13: nothing where 'four'"),
                          HasSubstr("tour.md:34: 'here.txt' where 'there.txt'")));
}

}  // namespace
}  // namespace plcxx::policy
