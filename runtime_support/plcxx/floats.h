// Floating point: binary32, every operation rounded to nearest even.
//
// Implements HOST50 6.4 to 6.6. A compiler that fuses a multiplication with an addition gives another result: compile
// generated code with -ffp-contract=off. Every function has a result for every input, NaN and infinity included.
// Not here: the integer side of a conversion's overflow is saturation, and no flag tells it.
#pragma once

#include <stdint.h>

#include "plcxx/float_environment.h"

namespace plcxx {

[[gnu::const]] constexpr float AddF32(float a, float b) noexcept { return a + b; }
[[gnu::const]] constexpr float SubF32(float a, float b) noexcept { return a - b; }
[[gnu::const]] constexpr float MulF32(float a, float b) noexcept { return a * b; }
/// a / b; by zero of either sign: a.
[[gnu::const]] constexpr float QuotientOrDividendF32(float a, float b) noexcept { return b == 0.0F ? a : a / b; }
/// The sign inverted, also of zero and NaN.
[[gnu::const]] constexpr float NegateF32(float value) noexcept { return -value; }

[[gnu::const]] constexpr bool EqualF32(float a, float b) noexcept { return a == b; }
[[gnu::const]] constexpr bool NotEqualF32(float a, float b) noexcept { return !(a == b); }
[[gnu::const]] constexpr bool LessF32(float a, float b) noexcept { return a < b; }
[[gnu::const]] constexpr bool LessEqualF32(float a, float b) noexcept { return a <= b; }
[[gnu::const]] constexpr bool GreaterF32(float a, float b) noexcept { return a > b; }
[[gnu::const]] constexpr bool GreaterEqualF32(float a, float b) noexcept { return a >= b; }

/// The 32 bits of the number; for "has it changed", which NaN and the two zeros would otherwise answer wrongly.
[[gnu::const]] inline uint32_t BitsOfF32(float value) noexcept {
  uint32_t bits = 0;
  static_assert(sizeof bits == sizeof value, "float is binary32");
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// The number with these 32 bits: how generated code spells NaN and infinity.
[[gnu::const]] inline float F32OfBits(uint32_t bits) noexcept {
  float value = 0.0F;
  static_assert(sizeof bits == sizeof value, "float is binary32");
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

/// A two's complement word as the nearest binary32, ties to even.
[[gnu::const]] constexpr float SignedToF32(uint32_t value) noexcept {
  return static_cast<float>(static_cast<int32_t>(value));
}

/// Toward zero; beyond the range of a word its highest or lowest number, NaN 0.
[[gnu::const]] constexpr uint32_t TruncateF32(float value) noexcept {
  if (!(value == value)) return 0;
  if (value >= 2147483648.0F) return 0x7FFFFFFFU;
  if (value <= -2147483648.0F) return 0x80000000U;
  return static_cast<uint32_t>(static_cast<int32_t>(value));
}

/// To the nearest word, ties away from zero; beyond the range and NaN as TruncateF32.
[[gnu::const]] constexpr uint32_t RoundF32(float value) noexcept {
  const uint32_t whole = TruncateF32(value);
  // From 2^23 on a binary32 has no fraction; below it the difference is exact.
  if (!(value > -8388608.0F && value < 8388608.0F)) return whole;
  const float fraction = value - SignedToF32(whole);
  if (fraction >= 0.5F) return whole + 1U;
  if (fraction <= -0.5F) return whole - 1U;
  return whole;
}

}  // namespace plcxx
