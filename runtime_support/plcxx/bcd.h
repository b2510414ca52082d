// Packed BCD: two decimal digits in a byte, four in a 16-bit word, eight with a sign in a 32-bit word.
//
// Implements NC110 6.6 (BCD, BIN) with decision D13, PROSTEP 6.9 (FM 4, FM 5) and TECHNOL 6.6: numbers with too many
// digits and nibbles above 9 have a result too.
// Not its job: to report them; that is the debug build's choice.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

namespace plcxx {

/// The last two decimal digits of a number; always two valid digits.
[[gnu::const, gnu::noinline]] static constexpr uint8_t ToBcd8(uint8_t value) noexcept {
  unsigned rest = value;
  // By subtraction and multiplication: cores without a divider would call a library for / and %.
  if (rest >= 200) rest -= 200;
  if (rest >= 100) rest -= 100;
  const unsigned tens = (rest * 103) >> 10;  // rest / 10 for every rest below 179
  return static_cast<uint8_t>(tens * 16 + (rest - tens * 10));
}

/// High nibble times ten plus low nibble, also for nibbles above 9. Range 0..165.
[[gnu::const, gnu::noinline]] static constexpr uint8_t FromBcd8(uint8_t value) noexcept {
  return static_cast<uint8_t>((value >> 4) * 10 + (value & 0x0F));
}

/// The last four decimal digits of a number; always four valid digits.
[[gnu::const, gnu::noinline]] static constexpr uint16_t ToBcd16(uint16_t value) noexcept {
  unsigned rest = value, digits = 0;
  for (unsigned shift = 0; shift < 16; shift += 4) {  // at most 4 rounds
    const unsigned tenth = (rest * 52429U) >> 19;     // rest / 10 for every 16-bit number
    digits |= (rest - tenth * 10) << shift;
    rest = tenth;
  }
  return static_cast<uint16_t>(digits);
}

/// The four nibbles with the weights 1000, 100, 10, 1, also for nibbles above 9. Range 0..16665.
[[gnu::const, gnu::noinline]] static constexpr uint16_t FromBcd16(uint16_t value) noexcept {
  return static_cast<uint16_t>((value >> 12) * 1000 + ((value >> 8) & 15) * 100 + ((value >> 4) & 15) * 10 +
                               (value & 15));
}

/// A number of two's complement as a sign in bit 31 and its last digits: seven, and an eighth that is below 8. The sign
/// of 0 is 0.
[[gnu::const, gnu::noinline]] static constexpr uint32_t ToSignedBcd32(uint32_t value) noexcept {
  const bool negative = value > 0x7FFFFFFFU;
  const uint32_t magnitude = (negative ? 0U - value : value) % 80000000U;
  uint32_t rest = magnitude, digits = 0;
  for (unsigned shift = 0; shift < 32; shift += 4) {  // at most 8 rounds
    digits |= (rest % 10U) << shift;
    rest /= 10U;
  }
  return negative && magnitude != 0 ? digits | 0x80000000U : digits;
}

/// The number in two's complement; nibbles above 9 count with their weight, too.
[[gnu::const, gnu::noinline]] static constexpr uint32_t FromSignedBcd32(uint32_t value) noexcept {
  uint32_t magnitude = 0;
  for (unsigned shift = 32; shift != 0; shift -= 4) {  // at most 8 rounds
    const uint32_t nibble = (value >> (shift - 4U)) & (shift == 32 ? 7U : 15U);
    magnitude = magnitude * 10U + nibble;
  }
  return value > 0x7FFFFFFFU ? 0U - magnitude : magnitude;
}

/// Whether one of the eight nibbles is above 9.
[[gnu::const, gnu::noinline]] static constexpr bool HasNoDigit32(uint32_t value) noexcept {
  // 8 in a nibble together with 4 or 2 is above 9.
  return (value & ((value << 1) | (value << 2)) & 0x88888888U) != 0;
}

}  // namespace plcxx
