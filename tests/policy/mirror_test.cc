// Tests stand as what they test, and what is about several folders says so.
#include "tests/policy/mirror.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Mirror, TestsStandAsTheTree) {
  const Findings findings = CheckMirror(Root(), ReadFile(Root() + "/tests/policy/mirror.txt"));
  EXPECT_THAT(findings, IsEmpty()) << Joined(findings);
}

TEST(Mirror, FixtureHasStrayTests) {
  EXPECT_THAT(
      CheckMirror(Fixture("mirror"), ""),
      ElementsAre(
          "tests/stray: no folder of transpiler/ has this name; say in mirror.txt what it is about",
          "tests/room/other_test.cc: includes nothing of transpiler/room; it belongs to the folder that it tests",
          "tests/room/through_test.cc: includes nothing of transpiler/room; it belongs to the folder that it "
          "tests"));
  EXPECT_THAT(CheckMirror(Fixture("mirror"),
                          "# comment\ntests/stray of all\ntests/room/other_test.cc of two\n"
                          "tests/room/through_test.cc of two\n"),
              IsEmpty());
}

TEST(Mirror, ExceptionsHaveReasonsAndAreUsed) {
  EXPECT_THAT(CheckMirror(Fixture("mirror"),
                          "tests/stray of all\ntests/room/other_test.cc\ntests/room/through_test.cc of two\n"
                          "tests/gone of nothing\n"),
              ElementsAre("mirror.txt: a reason is missing: tests/room/other_test.cc",
                          "mirror.txt: nothing is an exception by 'tests/gone'; remove it"));
}

}  // namespace
}  // namespace plcxx::policy
