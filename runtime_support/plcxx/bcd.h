// Packed BCD: two decimal digits in a byte.
//
// Implements NC110 6.6 (BCD, BIN) with decision D13: numbers above 99 and nibbles above 9 have a result too.
// Not its job: to report them; that is the debug build's choice.
#pragma once

#include <stdint.h>

namespace plcxx {

/// The last two decimal digits of a number; always two valid digits.
[[gnu::const]] constexpr uint8_t ToBcd8(uint8_t value) noexcept {
  unsigned rest = value;
  // By subtraction and multiplication: cores without a divider would call a library for / and %.
  if (rest >= 200) rest -= 200;
  if (rest >= 100) rest -= 100;
  const unsigned tens = (rest * 103) >> 10;  // rest / 10 for every rest below 179
  return static_cast<uint8_t>(tens * 16 + (rest - tens * 10));
}

/// High nibble times ten plus low nibble, also for nibbles above 9. Range 0..165.
[[gnu::const]] constexpr uint8_t FromBcd8(uint8_t value) noexcept {
  return static_cast<uint8_t>((value >> 4) * 10 + (value & 0x0F));
}

}  // namespace plcxx
