// Every requirement of the checklist has a test that names it. `policy_test --gtest_filter=Coverage.*` prints the
// table.
#include "tests/policy/coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFolder = "tests/policy/";

/// "checklist_nc110.txt": "nc110".
std::string DialectOf(std::string_view checklist) {
  checklist.remove_prefix(kFolder.size() + std::string_view("checklist_").size());
  return std::string(checklist.substr(0, checklist.find('.')));
}

std::vector<std::string> Checklists() {
  std::vector<std::string> checklists = FilesBelow(Root(), "tests/policy", {".txt"});
  std::erase_if(checklists, [](const std::string& file) { return !file.starts_with(kFolder + "checklist_"); });
  return checklists;
}

class Checklist : public testing::TestWithParam<std::string> {};

TEST_P(Checklist, EveryRequirementHasATest) {
  const std::string checklist = ReadFile(Root() + "/" + GetParam());
  const Coverage coverage = FindCoverage(Root(), checklist);
  std::cout << Table(coverage) << coverage.ids.size() - Uncovered(coverage).size() << " of " << coverage.ids.size()
            << " covered\n";
  EXPECT_THAT(checklist, HasSubstr("\n# requirements: " + std::to_string(coverage.ids.size()) + "\n"))
      << "lines are missing, or the number of them at the top of the list is an old one";
  EXPECT_THAT(Uncovered(coverage), IsEmpty());
  EXPECT_THAT(coverage.unknown, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Coverage, Checklist, testing::ValuesIn(Checklists()),
                         [](const auto& checklist) { return DialectOf(checklist.param); });

TEST(Coverage, EveryDialectHasAChecklist) {
  std::vector<std::string> listed;
  for (const std::string& checklist : Checklists()) listed.push_back(DialectOf(checklist));
  std::vector<std::string> dialects;
  const std::string folder = "transpiler/dialects/";
  for (const std::string& file : FilesBelow(Root(), folder, {"/CMakeLists.txt"})) {
    const std::string name = file.substr(folder.size(), file.rfind('/') - std::min(file.rfind('/'), folder.size()));
    if (!name.empty() && name != "common") dialects.push_back(name);
  }
  EXPECT_THAT(listed, testing::ElementsAreArray(dialects));
}

TEST(Coverage, FixtureLacksOne) {
  const Coverage coverage =
      FindCoverage(Fixture("coverage"), "# three\nNC110-001 first\nNC110-002 second\nNC110-004 last\n");
  EXPECT_THAT(Uncovered(coverage), ElementsAre("NC110-004 last"));
  EXPECT_THAT(coverage.unknown, ElementsAre("tests/some_test.cc:1: NC110-003"));
  EXPECT_THAT(Table(coverage), HasSubstr("NOT COVERED"));
}

}  // namespace
}  // namespace plcxx::policy
