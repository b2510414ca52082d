// What a processor of the 8086 family leaves in its registers and flags, as functions of the operands: carries,
// shifts, rotations, decimal adjustment.
//
// A flag is a function of its own, so that only those are computed that somebody reads. Implements TECHNOL 6.5 (RL, RR)
// and 6.9. Every function has a result for every operand; where the processor's depends on the width of a register,
// the name ends with the width.
// Not here: sums, products and quotients (arith.h), bits (bits.h), packed digits as numbers (bcd.h).
#pragma once

#include <stdint.h>

namespace plcxx {

namespace registers {

template <class T>
[[gnu::const, gnu::always_inline]] constexpr inline bool Highest(unsigned value) noexcept {
  return ((value >> (sizeof(T) * 8U - 1U)) & 1U) != 0;
}

/// The widths of a rotation: 9, 17 or 33 bits with the carry above the value.
template <class T>
[[gnu::const, gnu::always_inline]] constexpr inline uint64_t RotatedWithCarry(T value, bool carry,
                                                                              uint32_t count) noexcept {
  constexpr uint32_t kBits = sizeof(T) * 8U + 1U;
  const uint64_t all = (uint64_t{carry} << (kBits - 1U)) | value;
  const uint32_t left = count % kBits;
  // By less than 64 in both directions: kBits - left is at most 33.
  return (all << left) | (all >> (kBits - left));
}

template <class T>
[[gnu::const, gnu::always_inline]] constexpr inline T RotatedLeft(T value, uint32_t count) noexcept {
  constexpr uint32_t kBits = sizeof(T) * 8U;
  const uint64_t twice = (uint64_t{value} << kBits) | value;
  return static_cast<T>(twice >> (kBits - count % kBits));
}

}  // namespace registers

/// The carry out of the highest bit of a sum `sum` = a + b or a + b + 1.
[[gnu::const]] constexpr bool CarryOfAdd8(uint8_t a, uint8_t b, uint8_t sum) noexcept {
  return registers::Highest<uint8_t>((unsigned{a} & b) | ((unsigned{a} | b) & ~unsigned{sum}));
}
[[gnu::const]] constexpr bool CarryOfAdd16(uint16_t a, uint16_t b, uint16_t sum) noexcept {
  return registers::Highest<uint16_t>((unsigned{a} & b) | ((unsigned{a} | b) & ~unsigned{sum}));
}
[[gnu::const]] constexpr bool CarryOfAdd32(uint32_t a, uint32_t b, uint32_t sum) noexcept {
  return registers::Highest<uint32_t>((a & b) | ((a | b) & ~sum));
}

/// The borrow into the highest bit of a difference `difference` = a - b or a - b - 1.
[[gnu::const]] constexpr bool BorrowOfSub8(uint8_t a, uint8_t b, uint8_t difference) noexcept {
  return registers::Highest<uint8_t>((~unsigned{a} & b) | ((~unsigned{a} | b) & difference));
}
[[gnu::const]] constexpr bool BorrowOfSub16(uint16_t a, uint16_t b, uint16_t difference) noexcept {
  return registers::Highest<uint16_t>((~unsigned{a} & b) | ((~unsigned{a} | b) & difference));
}
[[gnu::const]] constexpr bool BorrowOfSub32(uint32_t a, uint32_t b, uint32_t difference) noexcept {
  return registers::Highest<uint32_t>((~a & b) | ((~a | b) & difference));
}

/// Whether a sum or difference of two's complement, with a carry or borrow or without, does not fit.
[[gnu::const]] constexpr bool OverflowOfAdd8(uint8_t a, uint8_t b, uint8_t sum) noexcept {
  return registers::Highest<uint8_t>((unsigned{a} ^ sum) & (unsigned{b} ^ sum));
}
[[gnu::const]] constexpr bool OverflowOfAdd16(uint16_t a, uint16_t b, uint16_t sum) noexcept {
  return registers::Highest<uint16_t>((unsigned{a} ^ sum) & (unsigned{b} ^ sum));
}
[[gnu::const]] constexpr bool OverflowOfAdd32(uint32_t a, uint32_t b, uint32_t sum) noexcept {
  return registers::Highest<uint32_t>((a ^ sum) & (b ^ sum));
}
[[gnu::const]] constexpr bool OverflowOfSub8(uint8_t a, uint8_t b, uint8_t difference) noexcept {
  return registers::Highest<uint8_t>((unsigned{a} ^ b) & (unsigned{a} ^ difference));
}
[[gnu::const]] constexpr bool OverflowOfSub16(uint16_t a, uint16_t b, uint16_t difference) noexcept {
  return registers::Highest<uint16_t>((unsigned{a} ^ b) & (unsigned{a} ^ difference));
}
[[gnu::const]] constexpr bool OverflowOfSub32(uint32_t a, uint32_t b, uint32_t difference) noexcept {
  return registers::Highest<uint32_t>((a ^ b) & (a ^ difference));
}

/// The carry out of bit 3 of a sum, or the borrow from bit 4 of a difference, by the low bytes of operands and result.
[[gnu::const]] constexpr bool HalfCarry8(uint8_t a, uint8_t b, uint8_t result) noexcept {
  return ((unsigned{a} ^ b ^ result) & 0x10U) != 0;
}

/// Shifts that bring in zeros, or copies of the sign; by 32 or more only those are left.
[[gnu::const]] constexpr uint32_t ShiftLeft32(uint32_t value, uint32_t count) noexcept {
  return count > 31 ? 0U : value << count;
}
[[gnu::const]] constexpr uint32_t ShiftRight32(uint32_t value, uint32_t count) noexcept {
  return count > 31 ? 0U : value >> count;
}
[[gnu::const]] constexpr uint32_t ArithmeticShiftRight32(uint32_t value, uint32_t count) noexcept {
  const uint32_t zeros = ShiftRight32(value, count);
  return value > 0x7FFFFFFFU ? zeros | ~ShiftRight32(0xFFFFFFFFU, count) : zeros;
}

/// Rotations by the count modulo the width.
[[gnu::const]] constexpr uint8_t RotateLeft8(uint8_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, count);
}
[[gnu::const]] constexpr uint16_t RotateLeft16(uint16_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, count);
}
[[gnu::const]] constexpr uint32_t RotateLeft32(uint32_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, count);
}
[[gnu::const]] constexpr uint8_t RotateRight8(uint8_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, 8U - count % 8U);
}
[[gnu::const]] constexpr uint16_t RotateRight16(uint16_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, 16U - count % 16U);
}
[[gnu::const]] constexpr uint32_t RotateRight32(uint32_t value, uint32_t count) noexcept {
  return registers::RotatedLeft(value, 32U - count % 32U);
}

/// Rotations to the left through the carry, which stands above the highest bit: the value, and the carry after it.
/// The count is taken modulo the width with the carry; to the right by n is to the left by what n lacks to it.
[[gnu::const]] constexpr uint8_t RotateCarryLeft8(uint8_t value, bool carry, uint32_t count) noexcept {
  return static_cast<uint8_t>(registers::RotatedWithCarry(value, carry, count));
}
[[gnu::const]] constexpr uint16_t RotateCarryLeft16(uint16_t value, bool carry, uint32_t count) noexcept {
  return static_cast<uint16_t>(registers::RotatedWithCarry(value, carry, count));
}
[[gnu::const]] constexpr uint32_t RotateCarryLeft32(uint32_t value, bool carry, uint32_t count) noexcept {
  return static_cast<uint32_t>(registers::RotatedWithCarry(value, carry, count));
}
[[gnu::const]] constexpr bool CarryAfterRotate8(uint8_t value, bool carry, uint32_t count) noexcept {
  return ((registers::RotatedWithCarry(value, carry, count) >> 8) & 1U) != 0;
}
[[gnu::const]] constexpr bool CarryAfterRotate16(uint16_t value, bool carry, uint32_t count) noexcept {
  return ((registers::RotatedWithCarry(value, carry, count) >> 16) & 1U) != 0;
}
[[gnu::const]] constexpr bool CarryAfterRotate32(uint32_t value, bool carry, uint32_t count) noexcept {
  return ((registers::RotatedWithCarry(value, carry, count) >> 32) & 1U) != 0;
}

/// Decimal adjustment of a sum or a difference of two packed digits: 6 for the low digit, 60h for the high one.
[[gnu::const]] constexpr uint8_t AdjustAfterAdd8(uint8_t value, bool low, bool high) noexcept {
  return static_cast<uint8_t>(value + (low ? 0x06U : 0U) + (high ? 0x60U : 0U));
}
[[gnu::const]] constexpr uint8_t AdjustAfterSub8(uint8_t value, bool low, bool high) noexcept {
  return static_cast<uint8_t>(value - (low ? 0x06U : 0U) - (high ? 0x60U : 0U));
}

}  // namespace plcxx
