// What makes m[U4A8] work when U4A8 is one bit of a stored byte: a tag, and what indexing with it returns.
//
// A statement's text does not depend on how its bits are stored: m[U4A8] is a bool& when the bit has a byte of its own,
// a uint8_t& when it is a word, and a PackedBitRef here. The tags of a program are declared by its generated header.
// The attributes: a reference is computed from the address alone (const) and reading it has no effect (pure), so that
// the compiler sees in m[A] & m[B] no effect that && would skip, and does not suggest &&.
#pragma once

#include <stdint.h>

#include "plcxx/bits.h"

namespace plcxx {

/// Tag of bit `bit` (0..7) of byte `byte` of a block of memory.
struct PackedBit {
  uint16_t byte;
  uint8_t bit;
};

/// The mask of the tag's bit; 0 for a bit that a byte does not have, which then reads 0 and writes nothing.
[[gnu::const, gnu::always_inline]] constexpr inline uint8_t MaskOf(PackedBit tag) noexcept {
  return tag.bit <= 7 ? static_cast<uint8_t>(1U << tag.bit) : uint8_t{0};
}

/// One bit of a byte, for reading and writing; the other seven bits are left alone.
class PackedBitRef {
 public:
  [[gnu::always_inline]] constexpr PackedBitRef(uint8_t& byte, uint8_t mask) noexcept : byte_(byte), mask_(mask) {}
  constexpr PackedBitRef(const PackedBitRef&) noexcept = default;
  ~PackedBitRef() = default;

  [[gnu::pure, gnu::always_inline]] constexpr operator bool() const noexcept { return (byte_ & mask_) != 0; }

  [[gnu::always_inline]] constexpr PackedBitRef& operator=(bool value) noexcept {
    byte_ = WithBits8(byte_, mask_, value);
    return *this;
  }
  /// m[A] = m[B] assigns the bit, never the reference.
  [[gnu::always_inline]] constexpr PackedBitRef& operator=(const PackedBitRef& other) noexcept {
    return *this = static_cast<bool>(other);
  }

 private:
  uint8_t& byte_;
  uint8_t mask_;
};

}  // namespace plcxx
