// Judges what `plcxx diff` says of a pair.
//
// What it calls equal is attacked by simulated runs of both versions, with power failures, fast parts alone, answers of
// the host at random; what it calls different must have been seen, and its scenario must pass on the old version and
// fail on the new one; a pair that is alike by construction is never different. In: a pair. Out: the sums, and what is
// wrong in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/pairs/pair.h"

namespace plcxx::pairs {

struct JudgeOptions {
  uint64_t time_ms = 2000;
  int runs = 8, steps = 50;
};

struct Tally {
  uint64_t pairs = 0, alike = 0;  // of them alike by construction
  uint64_t not_compiled = 0, refused = 0;
  uint64_t without_difference = 0;              // pairs
  uint64_t claimed = 0, attacked = 0;           // locations called equal; pairs whose claims were attacked by runs
  uint64_t different = 0, replayed = 0;         // locations; with a scenario that was run on both
  uint64_t undecided = 0, pairs_undecided = 0;  // locations; pairs with some
  uint64_t alike_undecided = 0;                 // pairs
  uint64_t late = 0, longest_ms = 0;            // more than a tenth over the time
  std::vector<std::string> unsound;             // what is wrong, a pair each
};
void Add(Tally& sum, const Tally& other);

/// One pair of the language with this seed: mutated or rewritten.
Pair PairOf(const std::string& dialect, uint64_t seed);
/// `save`: a folder for each pair that was judged wrongly; empty: none.
Tally Judge(const Pair& pair, uint64_t seed, const JudgeOptions& options, const std::string& save);

/// The head of the table and its rows.
std::string TableHead();
std::string TableRow(const std::string& dialect, const Tally& tally);

}  // namespace plcxx::pairs
