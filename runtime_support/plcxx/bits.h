// Operations on words taken as rows of bits: complement, priority encoder and decoder, nibbles, single bits.
//
// Implements NC110 6.1 and 6.2 (AND, OR, XOR, NOT) and 6.6 (ENC, DEC, HIG, LOW, XCH, SGN), and the pairs of 5.4.
// Every function is defined for every input and costs the same for each: a scan must not become slower with its data.
// The operators exist as functions too because the simulator calls the meaning of an operation by name; generated
// code spells them & | ^ and !. [[gnu::const]], here and in the headers of numbers: a call has no effect, so that no
// compiler suggests && for an & of two calls. Not here: numbers (arith.h), order (compare.h), digits (bcd.h).
#pragma once

#include <stdint.h>

namespace plcxx {

[[gnu::const]] constexpr bool BitAnd(bool a, bool b) noexcept { return a & b; }
[[gnu::const]] constexpr bool BitOr(bool a, bool b) noexcept { return a | b; }
[[gnu::const]] constexpr bool BitXor(bool a, bool b) noexcept { return a != b; }
[[gnu::const]] constexpr bool BitNot(bool a) noexcept { return !a; }

[[gnu::const]] constexpr uint8_t And8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a & b); }
[[gnu::const]] constexpr uint16_t And16(uint16_t a, uint16_t b) noexcept { return static_cast<uint16_t>(a & b); }
[[gnu::const]] constexpr uint32_t And32(uint32_t a, uint32_t b) noexcept { return a & b; }
[[gnu::const]] constexpr uint64_t And64(uint64_t a, uint64_t b) noexcept { return a & b; }

[[gnu::const]] constexpr uint8_t Or8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a | b); }
[[gnu::const]] constexpr uint16_t Or16(uint16_t a, uint16_t b) noexcept { return static_cast<uint16_t>(a | b); }
[[gnu::const]] constexpr uint32_t Or32(uint32_t a, uint32_t b) noexcept { return a | b; }
[[gnu::const]] constexpr uint64_t Or64(uint64_t a, uint64_t b) noexcept { return a | b; }

[[gnu::const]] constexpr uint8_t Xor8(uint8_t a, uint8_t b) noexcept { return static_cast<uint8_t>(a ^ b); }
[[gnu::const]] constexpr uint16_t Xor16(uint16_t a, uint16_t b) noexcept { return static_cast<uint16_t>(a ^ b); }
[[gnu::const]] constexpr uint32_t Xor32(uint32_t a, uint32_t b) noexcept { return a ^ b; }
[[gnu::const]] constexpr uint64_t Xor64(uint64_t a, uint64_t b) noexcept { return a ^ b; }

/// Every bit complemented, in the word's own width (C++ would widen a plain ~ to int).
[[gnu::const]] constexpr uint8_t Not8(uint8_t value) noexcept { return static_cast<uint8_t>(~value); }
[[gnu::const]] constexpr uint16_t Not16(uint16_t value) noexcept { return static_cast<uint16_t>(~value); }
[[gnu::const]] constexpr uint32_t Not32(uint32_t value) noexcept { return ~value; }
[[gnu::const]] constexpr uint64_t Not64(uint64_t value) noexcept { return ~value; }

/// Number of the highest 1 bit, the lowest bit being number 1; 0 for 0. Range 0..8.
/// By halves, without a count-leading-zeros builtin: cores that lack the instruction would call a library for it.
[[gnu::const]] constexpr uint8_t HighestBit8(uint8_t value) noexcept {
  unsigned rest = value;
  unsigned number = rest != 0 ? 1 : 0;
  if (rest > 0x0F) {
    rest >>= 4;
    number += 4;
  }
  if (rest > 0x03) {
    rest >>= 2;
    number += 2;
  }
  if (rest > 0x01) number += 1;
  return static_cast<uint8_t>(number);
}

/// The word in which only bit `number` is 1, the lowest bit being number 1; 0 for 0 and for 9..255.
[[gnu::const]] constexpr uint8_t OneHot8(uint8_t number) noexcept {
  // Shifted one place too far and back, so that 0 needs no case of its own.
  return number > 8 ? uint8_t{0} : static_cast<uint8_t>((1U << number) >> 1);
}

/// Bits 7..4 as a number 0..15.
[[gnu::const]] constexpr uint8_t HighNibble8(uint8_t value) noexcept { return static_cast<uint8_t>(value >> 4); }

/// Bits 3..0 as a number 0..15.
[[gnu::const]] constexpr uint8_t LowNibble8(uint8_t value) noexcept { return static_cast<uint8_t>(value & 0x0F); }

/// The two nibbles exchanged; its own inverse.
[[gnu::const]] constexpr uint8_t SwapNibbles8(uint8_t value) noexcept {
  return static_cast<uint8_t>((value << 4) | (value >> 4));
}

/// Bit 7: the sign when the word is read as two's complement.
[[gnu::const]] constexpr bool SignBit8(uint8_t value) noexcept { return value > 0x7F; }

/// Bit `bit` of the word, 0 being the lowest; false for a bit that the word does not have.
[[gnu::const]] constexpr bool TestBit8(uint8_t value, unsigned bit) noexcept {
  return bit <= 7 && ((value >> bit) & 1) != 0;
}

/// The word with every bit of `mask` set to `value`, the others as they were; without a branch.
[[gnu::const]] constexpr uint8_t WithBits8(uint8_t word, uint8_t mask, bool value) noexcept {
  const unsigned all = 0U - static_cast<unsigned>(value);
  return static_cast<uint8_t>((word & ~unsigned{mask}) | (all & mask));
}

/// A 16-bit parameter from its two words.
[[gnu::const]] constexpr uint16_t Pair16(uint8_t low, uint8_t high) noexcept {
  return static_cast<uint16_t>((high << 8) | low);
}

/// Bits 7..0, bits 15..8, and the word with bits 7..0 replaced (an accumulator's low byte).
[[gnu::const]] constexpr uint8_t LowByte16(uint16_t value) noexcept { return static_cast<uint8_t>(value & 0xFF); }
[[gnu::const]] constexpr uint8_t HighByte16(uint16_t value) noexcept { return static_cast<uint8_t>(value >> 8); }
[[gnu::const]] constexpr uint16_t WithLowByte16(uint16_t word, uint8_t low) noexcept {
  return static_cast<uint16_t>((word & 0xFF00) | low);
}

/// Shifts that bring in zeros; by 16 or more, nothing is left (PROSTEP FM 6, FM 7).
[[gnu::const]] constexpr uint16_t ShiftLeft16(uint16_t value, uint16_t count) noexcept {
  return count > 15 ? uint16_t{0} : static_cast<uint16_t>(uint32_t{value} << count);
}
[[gnu::const]] constexpr uint16_t ShiftRight16(uint16_t value, uint16_t count) noexcept {
  return count > 15 ? uint16_t{0} : static_cast<uint16_t>(value >> count);
}

/// The bit at position 0..31 of an empty word; 0 for a position that the word does not have.
[[gnu::const]] constexpr uint32_t BitAt32(bool bit, uint32_t position) noexcept {
  return position > 31 ? 0U : uint32_t{bit} << position;
}
/// Bit `bit` of the word, 0 being the lowest; false for a bit that the word does not have.
[[gnu::const]] constexpr bool TestBit32(uint32_t value, uint32_t bit) noexcept {
  return bit <= 31 && ((value >> bit) & 1U) != 0;
}

/// The halves of a double word and of a quadruple word.
[[gnu::const]] constexpr uint16_t LowHalf32(uint32_t value) noexcept { return static_cast<uint16_t>(value & 0xFFFFU); }
[[gnu::const]] constexpr uint16_t HighHalf32(uint32_t value) noexcept { return static_cast<uint16_t>(value >> 16); }
[[gnu::const]] constexpr uint32_t LowHalf64(uint64_t value) noexcept { return static_cast<uint32_t>(value); }
[[gnu::const]] constexpr uint32_t HighHalf64(uint64_t value) noexcept { return static_cast<uint32_t>(value >> 32); }
/// A word from its halves.
[[gnu::const]] constexpr uint32_t Pair32(uint16_t low, uint16_t high) noexcept { return uint32_t{high} << 16 | low; }
[[gnu::const]] constexpr uint64_t Pair64(uint32_t low, uint32_t high) noexcept { return uint64_t{high} << 32 | low; }

}  // namespace plcxx
