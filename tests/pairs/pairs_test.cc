// plcxx diff against random pairs of programs: mutated ones, and ones that are written in another way. More of them:
// dev/pairs.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/pairs/judge.h"
#include "tests/volume.h"

namespace plcxx::pairs {
namespace {

class RandomPairs : public testing::TestWithParam<const char*> {};

TEST_P(RandomPairs, NothingIsCalledWhatItIsNot) {
  const std::string dialect = GetParam();
  const uint64_t wanted = testing_support::Volume(10, 300);
  Tally sum;
  for (uint64_t seed = 0; sum.pairs < wanted && seed < 6 * wanted; ++seed)
    Add(sum, Judge(PairOf(dialect, seed), seed, {.time_ms = 1000}, ""));
  std::cout << TableHead() << TableRow(dialect, sum);
  EXPECT_EQ(sum.pairs, wanted);
  EXPECT_GT(sum.alike, wanted / 5);
  EXPECT_GT(sum.claimed, wanted);
  // How many are shown in a second depends on the machine; that a few are does not.
  if (wanted >= 100) EXPECT_GT(sum.replayed, wanted / 20);
  for (const std::string& what : sum.unsound) ADD_FAILURE() << what;
}

INSTANTIATE_TEST_SUITE_P(Dialects, RandomPairs, testing::Values("nc110", "technol", "host50", "prostep", "hnc"),
                         [](const auto& named) { return std::string(named.param); });

/// The same seed makes the same pair, everywhere.
TEST(Pairs, FollowFromTheirSeeds) {
  for (const char* const dialect : {"nc110", "technol", "host50", "prostep", "hnc"}) {
    EXPECT_EQ(PairOf(dialect, 7).new_program.files, PairOf(dialect, 7).new_program.files);
  }
}

}  // namespace
}  // namespace plcxx::pairs
