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

void ExpectCovered(const std::string& checklist, size_t requirements) {
  const Coverage coverage = FindCoverage(Root(), ReadFile(Root() + "/tests/policy/" + checklist));
  EXPECT_EQ(coverage.ids.size(), requirements);
  std::cout << Table(coverage) << coverage.ids.size() - Uncovered(coverage).size() << " of " << coverage.ids.size()
            << " covered\n";
  EXPECT_THAT(Uncovered(coverage), IsEmpty());
  EXPECT_THAT(coverage.unknown, IsEmpty());
}

TEST(Coverage, EveryRequirementOfNc110) { ExpectCovered("checklist_nc110.txt", 258); }

TEST(Coverage, EveryRequirementOfTechnol) { ExpectCovered("checklist_technol.txt", 217); }

TEST(Coverage, EveryRequirementOfHnc) { ExpectCovered("checklist_hnc.txt", 362); }

TEST(Coverage, FixtureLacksOne) {
  const Coverage coverage =
      FindCoverage(Fixture("coverage"), "# three\nNC110-001 first\nNC110-002 second\nNC110-004 last\n");
  EXPECT_THAT(Uncovered(coverage), ElementsAre("NC110-004 last"));
  EXPECT_THAT(coverage.unknown, ElementsAre("tests/some_test.cc:1: NC110-003"));
  EXPECT_THAT(Table(coverage), HasSubstr("NOT COVERED"));
}

}  // namespace
}  // namespace plcxx::policy
