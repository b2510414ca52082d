// What one random program of nc110 is like: its addresses, how deep, how long, how many of each.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/reference/random_program.h"

namespace plcxx::reference {

struct Nc110Habits {
  struct Connector {
    char package;
    uint32_t number;
  };

  /// What this program is like.
  void Choose(Random& random) {
    if (random.OneIn(3)) return;
    const auto any_of = [&](uint32_t size) {
      return random.OneIn(4) ? size - 1 - random.Below(2) : random.OneIn(4) ? random.Below(2) : random.Below(size);
    };
    if (!random.OneIn(3)) {
      connectors_.clear();
      for (uint32_t i = random.Between(2, 8); i > 0; --i) {
        const char package = "AKKNT"[random.Below(5)];
        connectors_.push_back({package, any_of(package == 'A' ? 32 : package == 'T' ? 16 : 256)});
      }
      bits_.clear();
      for (uint32_t i = random.Between(2, 10); i > 0; --i) bits_.push_back(random.Below(32));
    }
    const auto some = [&](std::vector<uint32_t>& numbers, uint32_t size) {
      if (random.OneIn(3)) return;
      numbers.clear();
      for (uint32_t i = random.Between(1, 6); i > 0; --i) numbers.push_back(any_of(size));
    };
    some(timers_, 255);
    some(counters_, 100);
    some(one_shots_, 100);
    if (random.OneIn(3)) timers_.push_back(random.Between(47, 64));
    deepest_ = random.Between(0, 5);
    most_terms_ = random.Between(1, random.OneIn(8) ? 40 : 5);
    one_block_in_ = random.Between(2, 20);
    most_in_block_ = random.Between(1, 12);
    most_members_ = random.Between(1, 12);
    one_word_in_ = random.Between(1, 8);
    most_kind_ = random.Between(3, 9);
    long_times_ = random.OneIn(12);
    is_deep_ = random.OneIn(8);
  }

  std::vector<Connector> connectors_ = {{'A', 0},  {'A', 1},  {'A', 4},   {'A', 5},  {'A', 14},  {'A', 31},
                                        {'T', 0},  {'T', 1},  {'T', 15},  {'K', 0},  {'K', 3},   {'K', 9},
                                        {'K', 10}, {'K', 26}, {'K', 40},  {'K', 41}, {'K', 255}, {'N', 0},
                                        {'N', 10}, {'N', 60}, {'N', 255}, {'K', 157}};
  std::vector<uint32_t> bits_ = {0, 1, 2, 7, 8, 15, 16, 31};
  std::vector<uint32_t> timers_ = {0, 3, 47, 48, 63, 64, 254}, counters_ = {0, 5, 99}, one_shots_ = {0, 1, 6, 99};
  uint32_t deepest_ = 3, most_terms_ = 2, one_block_in_ = 7, most_in_block_ = 4, most_members_ = 3;
  uint32_t one_word_in_ = 4, most_kind_ = 9;
  bool long_times_ = false, is_deep_ = false;
};

}  // namespace plcxx::reference
