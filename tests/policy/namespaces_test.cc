// Qualified names of types, and the namespaces of folders.
#include "tests/policy/namespaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plcxx::policy {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Namespaces, ATypeIsDefinedOnce) { EXPECT_THAT(CheckDefinedOnce(Root()), IsEmpty()); }

TEST(Namespaces, FixtureDefinesATypeTwice) {
  EXPECT_THAT(CheckDefinedOnce(Fixture("namespaces")),
              ElementsAre("transpiler/walls/window.h:7: plcxx::house::Surroundings is also defined at "
                          "transpiler/garden/fence.h:10: "));
}

TEST(Namespaces, ARuleWithoutSourcesFails) {
  EXPECT_THAT(CheckDefinedOnce(Fixture("tour")), ElementsAre("no type is defined anywhere: the rule looks at nothing"));
}

TEST(Namespaces, ALocalFunctionHasANameOfItsOwn) { EXPECT_THAT(CheckLocalFunctions(Root()), IsEmpty()); }

TEST(Namespaces, FixtureHasALocalFunctionTwice) {
  EXPECT_THAT(CheckLocalFunctions(Fixture("namespaces")),
              ElementsAre("transpiler/walls/paint.cc:8: plcxx::walls::Thickness may be compiled together with "
                          "transpiler/walls/brick.cc:4: the same name"));
  EXPECT_THAT(CheckLocalFunctions(Fixture("tour")),
              ElementsAre("no local function is defined anywhere: the rule looks at nothing"));
}

TEST(Namespaces, AFolderHasOne) { EXPECT_THAT(CheckFolderNamespaces(Root()), IsEmpty()); }

TEST(Namespaces, FixtureMixesThem) {
  EXPECT_THAT(CheckFolderNamespaces(Fixture("namespaces")),
              ElementsAre("namespaces.txt: transpiler/garden and transpiler/roof share plcxx::house",
                          "transpiler/cellar/coal.h: its folder has no row in namespaces.txt",
                          "transpiler/walls/window.h: opens plcxx::house, not plcxx::walls",
                          "namespaces.txt: nothing in transpiler/roof"));
}

}  // namespace
}  // namespace plcxx::policy
