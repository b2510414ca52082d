// The mask of a width, where a shift by it would be undefined, too.
#include "transpiler/support/low_bits.h"

#include <gtest/gtest.h>

namespace plcxx::support {
namespace {

TEST(LowBits, OfEachWidth) {
  EXPECT_EQ(LowBits(0), 0U);
  EXPECT_EQ(LowBits(1), 1U);
  EXPECT_EQ(LowBits(8), 0xFFU);
  EXPECT_EQ(LowBits(63), 0x7FFF'FFFF'FFFF'FFFFU);
  EXPECT_EQ(LowBits(64), 0xFFFF'FFFF'FFFF'FFFFU);
  EXPECT_EQ(LowBits(65), LowBits(64));
}

}  // namespace
}  // namespace plcxx::support
