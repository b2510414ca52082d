// Arithmetic on unsigned words that wraps modulo 2^width: no overflow is undefined, no flag is kept.
//
// Implements NC110 6.4 (arithmetic inside [ ], every intermediate result modulo 256) and 6.6 (ABS), and the conversion
// of a timer's parameter to milliseconds (7.1). Read as two's complement, the results of Add, Sub and Mul are the same.
// Not here: comparison (compare.h), division (undecided by any paragraph so far).
#pragma once

#include <stdint.h>

namespace plcxx {

[[gnu::const]] constexpr uint8_t Add8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a + b); }
[[gnu::const]] constexpr uint16_t Add16(uint16_t a, uint16_t b) noexcept { return static_cast<uint16_t>(a + b); }
[[gnu::const]] constexpr uint32_t Add32(uint32_t a, uint32_t b) noexcept { return a + b; }
[[gnu::const]] constexpr uint64_t Add64(uint64_t a, uint64_t b) noexcept { return a + b; }

[[gnu::const]] constexpr uint8_t Sub8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a - b); }
[[gnu::const]] constexpr uint16_t Sub16(uint16_t a, uint16_t b) noexcept { return static_cast<uint16_t>(a - b); }
[[gnu::const]] constexpr uint32_t Sub32(uint32_t a, uint32_t b) noexcept { return a - b; }
[[gnu::const]] constexpr uint64_t Sub64(uint64_t a, uint64_t b) noexcept { return a - b; }

[[gnu::const]] constexpr uint8_t Mul8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a * b); }
/// Widened by hand: C++ would multiply two 16-bit words as int, and 0xFFFF * 0xFFFF overflows an int.
[[gnu::const]] constexpr uint16_t Mul16(uint16_t a, uint16_t b) noexcept {
  return static_cast<uint16_t>(uint32_t{a} * b);
}
[[gnu::const]] constexpr uint32_t Mul32(uint32_t a, uint32_t b) noexcept { return a * b; }
[[gnu::const]] constexpr uint64_t Mul64(uint64_t a, uint64_t b) noexcept { return a * b; }

/// The absolute value of a word read as two's complement; the lowest number is its own (0x80 for 8 bits).
[[gnu::const]] constexpr uint8_t Abs8(uint8_t value) noexcept {
  return value > 0x7F ? static_cast<uint8_t>(-value) : value;
}
[[gnu::const]] constexpr uint16_t Abs16(uint16_t value) noexcept {
  return value > 0x7FFF ? static_cast<uint16_t>(-value) : value;
}
[[gnu::const]] constexpr uint32_t Abs32(uint32_t value) noexcept { return value > 0x7FFFFFFFU ? 0U - value : value; }
[[gnu::const]] constexpr uint64_t Abs64(uint64_t value) noexcept {
  return value > 0x7FFFFFFFFFFFFFFFU ? uint64_t{0} - value : value;
}

/// The sum, or the highest number when the sum does not fit: a time that has run long enough stays long enough.
[[gnu::const]] constexpr uint32_t AddSaturate32(uint32_t a, uint32_t b) noexcept {
  const uint32_t sum = a + b;
  return sum < a ? 0xFFFFFFFFU : sum;
}

/// The same number in 32 bits.
[[gnu::const]] constexpr uint32_t Widen8To32(uint8_t value) noexcept { return value; }
[[gnu::const]] constexpr uint32_t Widen16To32(uint16_t value) noexcept { return value; }
[[gnu::const]] constexpr uint32_t Widen32(uint8_t value) noexcept { return value; }
[[gnu::const]] constexpr uint32_t Widen32(uint16_t value) noexcept { return value; }

}  // namespace plcxx
