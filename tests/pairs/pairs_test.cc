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
  const uint64_t least_replayed = wanted / 10;
  Tally sum;
  std::vector<uint64_t> undecided;
  // So many pairs, and as many more as it takes until some are different: a mutation often changes nothing that is
  // seen.
  for (uint64_t seed = 0; (sum.pairs < wanted || sum.replayed < least_replayed) && seed < 6 * wanted; ++seed) {
    const Tally one = Judge(PairOf(dialect, seed), seed, {.time_ms = 1000}, "");
    if (one.pairs_undecided != 0) undecided.push_back(seed);
    Add(sum, one);
  }
  std::cout << TableHead() << TableRow(dialect, sum);
  EXPECT_GE(sum.pairs, wanted);
  EXPECT_GT(sum.alike, wanted / 5);
  // How much is decided in a second depends on the machine; with enough time a part of it is on any.
  for (const uint64_t seed : undecided) {
    if (sum.replayed >= least_replayed && sum.claimed > wanted) break;
    Add(sum, Judge(PairOf(dialect, seed), seed, {.time_ms = 10'000}, ""));
  }
  EXPECT_GE(sum.replayed, least_replayed);
  EXPECT_GT(sum.claimed, wanted);
  for (const std::string& what : sum.unsound) ADD_FAILURE() << what;
}

INSTANTIATE_TEST_SUITE_P(Dialects, RandomPairs,
                         testing::Values("nc110", "technol", "host50", "prostep", "hnc", "classicladder"),
                         [](const auto& named) { return std::string(named.param); });

/// Behind `O` stands a comment here: it opens what is ORed, and is no operation that commutes with its neighbours.
TEST(Pairs, AnOWithoutAnOperandStaysWhereItIs) {
  const std::string marked = ":O\t* remark", unmarked = ":O oil level";
  const std::string text =
      ":A I 0.0\n:ON I 0.1\n" + marked + "\n:ON I 0.2\n" + unmarked + "\n:ON I 0.3\n:= O 0.0\n:EM\n";
  const ProgramText program{.dialect = "prostep", .sources = {"a.plc"}, .files = {{"a.plc", text}}};
  int others = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    terms::Random random(seed);
    const std::string written = Rewritten(program, random).new_program.files.at("a.plc");
    const auto at = [&written](const std::string& line) { return written.find(line); };
    EXPECT_TRUE(at(":ON I 0.1") < at(marked) && at(marked) < at(":ON I 0.2") && at(":ON I 0.2") < at(unmarked) &&
                at(unmarked) < at(":ON I 0.3"))
        << written;
    others += written != text ? 1 : 0;
  }
  EXPECT_GT(others, 0);
}

/// The same seed makes the same pair, everywhere.
TEST(Pairs, FollowFromTheirSeeds) {
  for (const char* const dialect : {"nc110", "technol", "host50", "prostep", "hnc", "classicladder"}) {
    EXPECT_EQ(PairOf(dialect, 7).new_program.files, PairOf(dialect, 7).new_program.files);
  }
}

}  // namespace
}  // namespace plcxx::pairs
