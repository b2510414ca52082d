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
  const uint64_t wanted = testing_support::Volume(20, 300);
  const uint64_t least_replayed = wanted / 4;
  Tally sum;
  std::vector<uint64_t> undecided;
  for (uint64_t seed = 0; sum.pairs < wanted && seed < 6 * wanted; ++seed) {
    const Tally one = Judge(PairOf(dialect, seed), seed, {.time_ms = 600}, "");
    if (one.pairs_undecided != 0 && one.replayed == 0) undecided.push_back(seed);
    Add(sum, one);
  }
  std::cout << TableHead() << TableRow(dialect, sum);
  EXPECT_EQ(sum.pairs, wanted);
  EXPECT_GT(sum.alike, wanted / 5);
  EXPECT_GT(sum.claimed, wanted);
  // How many are shown in half a second depends on the machine; with enough time a part of them is shown on any.
  Tally unhurried;
  for (const uint64_t seed : undecided) {
    if (sum.replayed + unhurried.replayed >= least_replayed) break;
    Add(unhurried, Judge(PairOf(dialect, seed), seed, {.time_ms = 10'000}, ""));
  }
  EXPECT_GE(sum.replayed + unhurried.replayed, least_replayed);
  for (const std::string& what : sum.unsound) ADD_FAILURE() << what;
  for (const std::string& what : unhurried.unsound) ADD_FAILURE() << what;
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
