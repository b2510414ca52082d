// Integers as a C compiler of 16-bit machines has them: int of 16 bits, long of 32, values kept as words without sign.
//
// Implements HNC 6.1, 6.2 and 6.11: what wraps (wrapping of + and - is in arith.h), division that truncates toward zero
// and has a result for every divisor, the choice between two values. Shifts and rotations of other widths are in bits.h
// and registers.h. Not here: the fault of a division by zero, which is a comparison of the lowering beside it.
#pragma once

#include <stdint.h>

#include "plcxx/arith.h"

namespace plcxx {

/// Unary minus; the lowest number is its own.
[[gnu::const]] constexpr uint16_t Minus16(uint16_t value) noexcept { return static_cast<uint16_t>(0 - value); }
[[gnu::const]] constexpr uint32_t Minus32(uint32_t value) noexcept { return 0U - value; }

/// Quotient and remainder without sign; by zero: 0, also for the remainder.
[[gnu::const]] constexpr uint16_t UnsignedDiv16(uint16_t a, uint16_t b) noexcept {
  return b == 0 ? uint16_t{0} : static_cast<uint16_t>(a / b);
}
[[gnu::const]] constexpr uint16_t UnsignedRem16(uint16_t a, uint16_t b) noexcept {
  return b == 0 ? uint16_t{0} : static_cast<uint16_t>(a % b);
}
[[gnu::const]] constexpr uint32_t UnsignedRemOrZero32(uint32_t a, uint32_t b) noexcept { return b == 0 ? 0 : a % b; }

/// Quotient of two's complement, truncated toward zero. By zero: 0; the lowest number by -1: itself.
[[gnu::const]] constexpr uint16_t SignedDiv16(uint16_t a, uint16_t b) noexcept {
  const uint16_t quotient = UnsignedDiv16(Abs16(a), Abs16(b));
  return ((a ^ b) & 0x8000) != 0 ? Minus16(quotient) : quotient;
}
/// Its remainder, with the sign of the dividend. By zero: 0.
[[gnu::const]] constexpr uint16_t SignedRem16(uint16_t a, uint16_t b) noexcept {
  const uint16_t rest = UnsignedRem16(Abs16(a), Abs16(b));
  return a > 0x7FFF ? Minus16(rest) : rest;
}
[[gnu::const]] constexpr uint32_t SignedRemOrZero32(uint32_t a, uint32_t b) noexcept {
  const uint32_t rest = UnsignedRemOrZero32(Abs32(a), Abs32(b));
  return a > 0x7FFFFFFFU ? Minus32(rest) : rest;
}

/// A shift to the right that copies the sign; by 16 or more only that is left.
[[gnu::const]] constexpr uint16_t ArithmeticShiftRight16(uint16_t value, uint16_t count) noexcept {
  const auto flip = static_cast<uint16_t>(value > 0x7FFF ? 0xFFFF : 0);
  const auto magnitude = static_cast<uint16_t>(value ^ flip);
  return static_cast<uint16_t>((count > 15 ? 0 : magnitude >> count) ^ flip);
}

[[gnu::const]] constexpr uint16_t Widen1To16(bool value) noexcept { return value ? uint16_t{1} : uint16_t{0}; }
[[gnu::const]] constexpr uint8_t LowByte32(uint32_t value) noexcept { return static_cast<uint8_t>(value & 0xFFU); }

/// condition ? a : b, both of which have been computed.
[[gnu::const]] constexpr bool Select1(bool condition, bool a, bool b) noexcept { return condition ? a : b; }
[[gnu::const]] constexpr uint8_t Select8(bool condition, uint8_t a, uint8_t b) noexcept { return condition ? a : b; }
[[gnu::const]] constexpr uint16_t Select16(bool condition, uint16_t a, uint16_t b) noexcept {
  return condition ? a : b;
}
[[gnu::const]] constexpr uint32_t Select32(bool condition, uint32_t a, uint32_t b) noexcept {
  return condition ? a : b;
}

}  // namespace plcxx
