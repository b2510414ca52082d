#include "transpiler/support/ids.h"

#include <gtest/gtest.h>

#include <string>

namespace plcxx::support {
namespace {

using NameId = Id<struct NameTag>;

TEST(Ids, DefaultIsNone) {
  EXPECT_FALSE(NameId().valid());
  EXPECT_TRUE(NameId(0).valid());
  EXPECT_LT(NameId(0), NameId(1));
}

TEST(Store, GivesIdsInOrder) {
  Store<NameId, std::string> names;
  const NameId first = names.Add("a");
  const NameId second = names.Add("b");
  EXPECT_EQ(first.index, 0u);
  EXPECT_EQ(names[second], "b");
  EXPECT_EQ(names.size(), 2u);
}

TEST(StoreDeathTest, UnknownIdIsOurFault) {
  Store<NameId, std::string> names;
  EXPECT_EXIT(names[NameId()], testing::ExitedWithCode(3), "please report it");
}

}  // namespace
}  // namespace plcxx::support
