#include "plcxx/retentive.h"

#include <gtest/gtest.h>

namespace plcxx {
namespace {

TEST(Retentive, PublishedVectorsOfFnv1a) {
  EXPECT_EQ(LayoutHash(""), 0x811C9DC5);
  EXPECT_EQ(LayoutHash("a"), 0xE40C292C);
  EXPECT_EQ(LayoutHash("foobar"), 0xBF9CF968);
  EXPECT_EQ(LayoutHash(nullptr), LayoutHash(""));
  EXPECT_NE(LayoutHash("\xE0"), LayoutHash("\x60"));
}

TEST(Retentive, OnlyTheSameLayoutIsAccepted) {
  EXPECT_TRUE(AcceptRetentive(LayoutHash("T 64"), LayoutHash("T 64")));
  EXPECT_FALSE(AcceptRetentive(LayoutHash("T 64"), LayoutHash("T 65")));
  EXPECT_FALSE(AcceptRetentive(0, LayoutHash("T 64")));
}

}  // namespace
}  // namespace plcxx
