#include "transpiler/support/mixed.h"

#include <gtest/gtest.h>

namespace plcxx::support {
namespace {

TEST(Mixed, TheOrderCounts) {
  EXPECT_NE(Mixed(Mixed(1, 2), 3), Mixed(Mixed(1, 3), 2));
  EXPECT_NE(Mixed(1, 2), Mixed(1, 3));
  EXPECT_EQ(Mixed(1, 2), Mixed(1, 2));
}

}  // namespace
}  // namespace plcxx::support
