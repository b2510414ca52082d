// Arithmetic on unsigned words that wraps modulo 2^width: no overflow is undefined, no flag is kept.
//
// Implements NC110 6.4 (arithmetic inside [ ], every intermediate result modulo 256) and 6.6 (ABS), and the conversion
// of a timer's parameter to milliseconds (7.1); PROSTEP 6.9 (FM 0-3, 11-14, 60-63), HOST50 6.3 and
// TECHNOL 6.5, 6.9. Read as two's
// complement, the results of Add, Sub and Mul are the same. Division has a result for every divisor; what a dialect
// says of division by zero beside it (a fault, an unchanged destination) is a comparison of its lowering.
// Not here: comparison (compare.h), floating point (floats.h).
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
[[gnu::const]] constexpr uint32_t Widen1To32(bool value) noexcept { return value ? 1U : 0U; }
[[gnu::const]] constexpr uint16_t Widen8To16(uint8_t value) noexcept { return value; }
[[gnu::const]] constexpr uint64_t Widen32To64(uint32_t value) noexcept { return value; }
/// The same number in a wider word, read as two's complement.
[[gnu::const]] constexpr uint16_t SignExtend8To16(uint8_t value) noexcept {
  return value > 0x7F ? static_cast<uint16_t>(0xFF00U | value) : uint16_t{value};
}
[[gnu::const]] constexpr uint32_t SignExtend8To32(uint8_t value) noexcept {
  return value > 0x7F ? 0xFFFFFF00U | value : uint32_t{value};
}
[[gnu::const]] constexpr uint32_t SignExtend16To32(uint16_t value) noexcept {
  return value > 0x7FFF ? 0xFFFF0000U | value : uint32_t{value};
}
[[gnu::const]] constexpr uint64_t SignExtend32To64(uint32_t value) noexcept {
  return value > 0x7FFFFFFFU ? 0xFFFFFFFF00000000U | value : uint64_t{value};
}

/// Quotient and remainder of unsigned words. By zero: quotient 0, remainder the dividend.
[[gnu::const]] constexpr uint32_t UnsignedDiv32(uint32_t a, uint32_t b) noexcept { return b == 0 ? 0 : a / b; }
[[gnu::const]] constexpr uint32_t UnsignedRem32(uint32_t a, uint32_t b) noexcept { return b == 0 ? a : a % b; }

/// Quotient of two's complement, truncated toward zero. By zero: 0; the lowest number by -1: itself.
[[gnu::const]] constexpr uint32_t SignedDiv32(uint32_t a, uint32_t b) noexcept {
  const uint32_t quotient = UnsignedDiv32(Abs32(a), Abs32(b));
  return ((a ^ b) & 0x80000000U) != 0 ? 0U - quotient : quotient;
}
/// Its remainder, with the sign of the dividend. By zero: the dividend.
[[gnu::const]] constexpr uint32_t SignedRem32(uint32_t a, uint32_t b) noexcept {
  const uint32_t rest = UnsignedRem32(Abs32(a), Abs32(b));
  return a > 0x7FFFFFFFU ? 0U - rest : rest;
}
/// As SignedDiv32, but by zero: the dividend (HOST50 6.3).
[[gnu::const]] constexpr uint32_t QuotientOrDividend32(uint32_t a, uint32_t b) noexcept {
  return b == 0 ? a : SignedDiv32(a, b);
}

/// The same of 64-bit numbers.
[[gnu::const]] constexpr uint64_t UnsignedDiv64(uint64_t a, uint64_t b) noexcept { return b == 0 ? 0 : a / b; }
[[gnu::const]] constexpr uint64_t UnsignedRem64(uint64_t a, uint64_t b) noexcept { return b == 0 ? a : a % b; }
[[gnu::const]] constexpr uint64_t SignedDiv64(uint64_t a, uint64_t b) noexcept {
  const uint64_t quotient = UnsignedDiv64(Abs64(a), Abs64(b));
  return ((a ^ b) & 0x8000000000000000U) != 0 ? uint64_t{0} - quotient : quotient;
}
[[gnu::const]] constexpr uint64_t SignedRem64(uint64_t a, uint64_t b) noexcept {
  const uint64_t rest = UnsignedRem64(Abs64(a), Abs64(b));
  return a > 0x7FFFFFFFFFFFFFFFU ? uint64_t{0} - rest : rest;
}

[[gnu::const]] constexpr uint32_t Widen32(uint8_t value) noexcept { return value; }
[[gnu::const]] constexpr uint32_t Widen32(uint16_t value) noexcept { return value; }

}  // namespace plcxx
