// Floating point: binary64, every operation rounded to nearest even.
//
// Implements HNC 6.1, 6.2 and 6.11: arithmetic of IEEE with infinities and NaN, conversion to integers by way of a
// 64-bit integer of which the low bits count, and fabs, floor, ceil, sqrt without a library. A compiler that fuses a
// multiplication with an addition gives another result: compile generated code with -ffp-contract=off.
#pragma once

#include <stdint.h>

#include "plcxx/float_environment.h"

namespace plcxx {

[[gnu::const]] constexpr double AddF64(double a, double b) noexcept { return a + b; }
[[gnu::const]] constexpr double SubF64(double a, double b) noexcept { return a - b; }
[[gnu::const]] constexpr double MulF64(double a, double b) noexcept { return a * b; }
[[gnu::const]] constexpr double DivF64(double a, double b) noexcept { return a / b; }
/// The sign inverted, also of zero and NaN.
[[gnu::const]] constexpr double NegateF64(double value) noexcept { return -value; }

[[gnu::const]] constexpr bool EqualF64(double a, double b) noexcept { return a == b; }
[[gnu::const]] constexpr bool NotEqualF64(double a, double b) noexcept { return !(a == b); }
[[gnu::const]] constexpr bool LessF64(double a, double b) noexcept { return a < b; }
[[gnu::const]] constexpr bool LessEqualF64(double a, double b) noexcept { return a <= b; }
[[gnu::const]] constexpr bool GreaterF64(double a, double b) noexcept { return a > b; }
[[gnu::const]] constexpr bool GreaterEqualF64(double a, double b) noexcept { return a >= b; }
[[gnu::const]] constexpr double SelectF64(bool condition, double a, double b) noexcept { return condition ? a : b; }

/// The 64 bits of the number, and the number with these bits.
[[gnu::const]] inline uint64_t BitsOfF64(double value) noexcept {
  uint64_t bits = 0;
  static_assert(sizeof bits == sizeof value, "double is binary64");
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}
[[gnu::const]] inline double F64OfBits(uint64_t bits) noexcept {
  double value = 0.0;
  static_assert(sizeof bits == sizeof value, "double is binary64");
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

/// Words of 32 bits, with and without sign; each is a binary64 exactly.
[[gnu::const]] constexpr double SignedToF64(uint32_t value) noexcept {
  return static_cast<double>(static_cast<int32_t>(value));
}
[[gnu::const]] constexpr double UnsignedToF64(uint32_t value) noexcept { return static_cast<double>(value); }
/// Toward zero as a 64-bit integer, of which these are the low bits; from 2^63 on, and for NaN, 0.
[[gnu::const]] constexpr uint32_t TruncateF64(double value) noexcept {
  if (!(value > -9223372036854775808.0 && value < 9223372036854775808.0)) return 0;
  return static_cast<uint32_t>(static_cast<uint64_t>(static_cast<int64_t>(value)) & 0xFFFFFFFFU);
}
[[gnu::const]] constexpr double WidenF32(float value) noexcept { return static_cast<double>(value); }
/// To the nearest binary32, ties to even.
[[gnu::const]] constexpr float NarrowF64(double value) noexcept { return static_cast<float>(value); }

[[gnu::const]] inline double AbsF64(double value) noexcept { return F64OfBits(BitsOfF64(value) & 0x7FFFFFFFFFFFFFFFU); }

/// The greatest whole number not above, the smallest one not below; the sign of a zero stays.
[[gnu::const]] inline double FloorF64(double value) noexcept {
  // From 2^52 on there is no fraction; NaN and infinity are their own.
  if (!(value > -4503599627370496.0 && value < 4503599627370496.0)) return value;
  const auto whole = static_cast<double>(static_cast<int64_t>(value));
  const double below = whole > value ? whole - 1.0 : whole;
  return below == 0.0 ? F64OfBits(BitsOfF64(value) & 0x8000000000000000U) : below;
}
[[gnu::const]] inline double CeilF64(double value) noexcept { return -FloorF64(-value); }

/// The square root, correctly rounded; of negative numbers NaN, of -0 itself.
[[gnu::const]] inline double SqrtF64(double value) noexcept {
  const uint64_t bits = BitsOfF64(value);
  if (value == 0.0 || !(value == value) || bits == 0x7FF0000000000000U) return value;
  if ((bits & 0x8000000000000000U) != 0) return F64OfBits(0x7FF8000000000000U);
  auto exponent = static_cast<int32_t>(bits >> 52);
  uint64_t mantissa = bits & 0x000FFFFFFFFFFFFFU;
  if (exponent == 0) {
    exponent = 1;
    while ((mantissa & 0x0010000000000000U) == 0) {  // at most 52 rounds
      mantissa <<= 1;
      --exponent;
    }
  }
  mantissa |= 0x0010000000000000U;
  exponent -= 1023;
  if ((exponent & 1) != 0) mantissa <<= 1;
  // Digit by digit: 54 bits of the root of mantissa * 2^54, one more than the result has, and whether anything is left.
  uint64_t root = 0, rest = 0;
  for (int32_t i = 53; i >= 0; --i) {  // at most 54 rounds
    const int32_t from = 2 * i - 54;   // of the two digits that come down
    const uint64_t digits = from >= 0 ? (mantissa >> from) & 3U : 0U;
    rest = rest << 2 | digits;
    const uint64_t trial = root << 2 | 1U;
    root <<= 1;
    if (rest >= trial) {
      rest -= trial;
      root |= 1U;
    }
  }
  const uint64_t even = root >> 1;
  const uint64_t rounded =
      even + (root & 1U);  // no root is half way between two numbers: its square has too many digits
  const auto half = static_cast<int32_t>(exponent >= 0 ? exponent / 2 : -((1 - exponent) / 2));
  return F64OfBits((rounded & 0x000FFFFFFFFFFFFFU) + (static_cast<uint64_t>(half + 1023) << 52) +
                   (rounded >> 53 << 52));
}

}  // namespace plcxx
