// Sets of goals, and which runs are needed to reach them.
#include "transpiler/soak/soak.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace plcxx::soak {
namespace {

GoalSet SetOf(std::initializer_list<size_t> goals) {
  GoalSet set(130);
  for (const size_t goal : goals) set.Add(goal);
  return set;
}

TEST(Goals, AreWrittenAndRead) {
  const GoalSet set = SetOf({0, 3, 63, 64, 129});
  EXPECT_EQ(set.Count(), 5U);
  GoalSet read;
  ASSERT_TRUE(read.FromHex(set.ToHex(), 130));
  EXPECT_EQ(read, set);
  EXPECT_FALSE(read.FromHex(set.ToHex(), 65)) << "another program";
  EXPECT_FALSE(read.FromHex(set.ToHex(), 129)) << "a goal that is none";
  EXPECT_FALSE(read.FromHex(set.ToHex().replace(0, 1, "x"), 130));
}

TEST(Needed, NoneOfTheRunsIsRedundant) {
  const std::vector<GoalSet> runs = {SetOf({1, 2}), SetOf({2, 3}), SetOf({1, 2, 3, 4}), SetOf({5}), SetOf({4, 5})};
  EXPECT_EQ(Needed(runs, SetOf({1, 2, 3, 4, 5})), (std::vector<size_t>{2, 3}));
  // The greatest comes first, and the two others make it redundant.
  const std::vector<GoalSet> covered = {SetOf({2, 3, 4, 5}), SetOf({1, 2, 3}), SetOf({4, 5, 6})};
  EXPECT_EQ(Needed(covered, SetOf({1, 2, 3, 4, 5, 6})), (std::vector<size_t>{1, 2}));
  EXPECT_TRUE(Needed({}, SetOf({1})).empty());
}

}  // namespace
}  // namespace plcxx::soak
