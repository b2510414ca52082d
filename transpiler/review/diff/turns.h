// Whose turn it is, where so much is open that no way of searching comes to its end.
//
// In: how long each way took the last time, and how many locations it found to differ. Out: the way that found most in
// its time; as the easy ones are found it finds fewer, until another one is better. Not its job: how long a turn is.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace plcxx::review::diff {

/// Ways of searching for runs: in many lanes at once, and from moments of a machine at work.
enum class Way : uint8_t { kWide, kAtWork };

class Turns {
 public:
  void Took(Way way, std::chrono::duration<double> time, size_t found) {
    constexpr double kLeastSeconds = 0.001;
    found_per_second_[static_cast<size_t>(way)] = static_cast<double>(found) / std::max(kLeastSeconds, time.count());
  }
  /// One that had no turn yet first.
  Way Next() const { return static_cast<Way>(std::ranges::max_element(found_per_second_) - found_per_second_.begin()); }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::array<double, 2> found_per_second_{kUnknown, kUnknown};
};

}  // namespace plcxx::review::diff
