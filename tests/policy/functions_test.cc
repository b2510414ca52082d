// How long functions are.
#include "tests/policy/functions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Functions, AreShort) { EXPECT_THAT(CheckFunctions(Root()), IsEmpty()); }

TEST(Functions, FixtureHasTwoLongOnes) {
  EXPECT_THAT(CheckFunctions(Fixture("functions")),
              ElementsAre(HasSubstr("transpiler/long.cc:10: 'Long' has 81 lines, of at most 80"),
                          HasSubstr("'InClass' has 81 lines")));
}

TEST(Functions, ARuleWithoutFunctionsFails) {
  EXPECT_THAT(CheckFunctions(Fixture("generated")), ElementsAre("there are no functions"));
}

}  // namespace
}  // namespace plcxx::policy
