// Forcing, for the debug flavour of generated code: memory whose forced bits the program cannot change.
//
// Implements the storage side of NC110 4.7: a forced value has priority over every assignment and over the inputs.
// Every stored byte has a ForceByte beside it; a forced bit keeps its value because writing keeps it and ApplyForce
// puts it back after the control has written. Reading is plain. Release code contains none of this.
#pragma once

#include <stdint.h>

#include "plcxx/bits.h"

namespace plcxx {

/// The forced bits of one byte: where `mask` is 1, the bit has the value that `value` has there. All zero: none.
struct ForceByte {
  uint8_t mask;
  uint8_t value;
};

/// `byte` with the forced bits in place.
[[gnu::pure]] constexpr uint8_t ApplyForce(uint8_t byte, const ForceByte& force) noexcept {
  return static_cast<uint8_t>((byte & ~force.mask) | (force.value & force.mask));
}

/// One bit of a byte that may be forced.
class ForcedBitRef {
 public:
  [[gnu::always_inline]] constexpr ForcedBitRef(uint8_t& byte, uint8_t mask, const ForceByte& force) noexcept
      : byte_(byte), force_(force), mask_(mask) {}
  constexpr ForcedBitRef(const ForcedBitRef&) noexcept = default;
  ~ForcedBitRef() = default;

  [[gnu::pure, gnu::always_inline]] constexpr operator bool() const noexcept { return (byte_ & mask_) != 0; }

  [[gnu::always_inline]] constexpr ForcedBitRef& operator=(bool value) noexcept {
    byte_ = ApplyForce(WithBits8(byte_, mask_, value), force_);
    return *this;
  }
  /// m[A] = m[B] assigns the bit, never the reference.
  [[gnu::always_inline]] constexpr ForcedBitRef& operator=(const ForcedBitRef& other) noexcept {
    return *this = static_cast<bool>(other);
  }

 private:
  uint8_t& byte_;
  const ForceByte& force_;
  uint8_t mask_;
};

/// A byte of which any bits may be forced.
class ForcedByteRef {
 public:
  [[gnu::always_inline]] constexpr ForcedByteRef(uint8_t& byte, const ForceByte& force) noexcept
      : byte_(byte), force_(force) {}
  constexpr ForcedByteRef(const ForcedByteRef&) noexcept = default;
  ~ForcedByteRef() = default;

  [[gnu::pure, gnu::always_inline]] constexpr operator uint8_t() const noexcept { return byte_; }

  [[gnu::always_inline]] constexpr ForcedByteRef& operator=(uint8_t value) noexcept {
    byte_ = ApplyForce(value, force_);
    return *this;
  }
  /// m[A] = m[B] assigns the byte, never the reference.
  [[gnu::always_inline]] constexpr ForcedByteRef& operator=(const ForcedByteRef& other) noexcept {
    return *this = static_cast<uint8_t>(other);
  }

 private:
  uint8_t& byte_;
  const ForceByte& force_;
};

}  // namespace plcxx
