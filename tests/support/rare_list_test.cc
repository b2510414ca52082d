#include "transpiler/support/rare_list.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace plcxx::support {
namespace {

std::vector<int> ItemsOf(const RareList<int>& list) { return {list.begin(), list.end()}; }

TEST(RareList, TakesTheRoomOfAPointer) { EXPECT_EQ(sizeof(RareList<int>), sizeof(void*)); }

TEST(RareList, BeginsEmpty) {
  const RareList<int> list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(ItemsOf(list), std::vector<int>());
}

TEST(RareList, ACopyHasItemsOfItsOwn) {
  RareList<int> list;
  list.push_back(1);
  list.push_back(2);
  RareList<int> copy = list;
  copy[0] = 3;
  copy.push_back(4);
  EXPECT_EQ(ItemsOf(list), (std::vector<int>{1, 2}));
  EXPECT_EQ(ItemsOf(copy), (std::vector<int>{3, 2, 4}));
  list = copy;
  copy = RareList<int>();
  EXPECT_EQ(ItemsOf(list), (std::vector<int>{3, 2, 4}));
  EXPECT_TRUE(copy.empty());
}

TEST(RareList, WhatIsMovedHasItsItems) {
  RareList<int> list;
  list.push_back(5);
  const RareList<int> moved = std::move(list);
  EXPECT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved.front(), 5);
}

}  // namespace
}  // namespace plcxx::support
