#include "transpiler/support/fnv1a.h"

#include <gtest/gtest.h>

namespace plcxx::support {
namespace {

// The published values of the algorithm's authors.
TEST(Fnv1a, KnownValues) {
  EXPECT_EQ(HashOf32(""), 0x811C9DC5U);
  EXPECT_EQ(HashOf32("a"), 0xE40C292CU);
  EXPECT_EQ(HashOf32("foobar"), 0xBF9CF968U);
  EXPECT_EQ(HashOf64(""), 0xCBF29CE484222325U);
  EXPECT_EQ(HashOf64("a"), 0xAF63DC4C8601EC8CU);
  EXPECT_EQ(HashOf64("foobar"), 0x85944171F73967E8U);
}

TEST(Fnv1a, BytesAboveAsciiCountAsUnsigned) {
  Fnv1a32 hash;
  hash.Add('\xE9');
  EXPECT_EQ(hash.value(), (0x811C9DC5U ^ 0xE9U) * 16777619U);
}

}  // namespace
}  // namespace plcxx::support
