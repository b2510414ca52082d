// Numbers that look random and are the same everywhere: proofs and runs that use them can be repeated.
#pragma once

#include <cstdint>

namespace plcxx::terms {

/// Marsaglia's xorshift of 64 bits.
class Random {
 public:
  /// `seed` is not 0.
  constexpr explicit Random(uint64_t seed) : state_(seed) {}
  constexpr uint64_t Next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  constexpr bool OneIn(uint64_t n) { return Next() % n == 0; }

 private:
  uint64_t state_;
};

}  // namespace plcxx::terms
