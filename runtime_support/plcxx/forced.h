// Forcing, for the debug flavour of generated code: an object whose forced bits the program cannot change.
//
// m[U4A8], m[W3K0], m[T5U] and m[T5] give a Forced<T>, m[DW10] a ForcedBytes where DW10 is put together of bytes:
// reading is plain, assigning keeps the forced bits, and when the reference dies (at the end of the statement) the
// forced bits are put back, so that a step function that got the object itself cannot change them either. Every byte
// of State has a byte of mask and of value at the same offset. Release code contains none of this.
// Not its job: which bits are forced; the simulation's driver writes the masks.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "plcxx/tags.h"
#include "plcxx/wide.h"

namespace plcxx {

/// Puts the forced bits of `size` bytes back.
inline void ApplyForces(void* object, const unsigned char* mask, const unsigned char* value, size_t size) noexcept {
  unsigned char* bytes = static_cast<unsigned char*>(object);
  for (size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<unsigned char>((bytes[i] & ~mask[i]) | (value[i] & mask[i]));
  }
}

template <class T>
class Forced {
 public:
  Forced(T& object, const unsigned char* mask, const unsigned char* value) noexcept
      : object_(object), mask_(mask), value_(value) {}
  Forced(const Forced&) = delete;
  ~Forced() { ApplyForces(&object_, mask_, value_, sizeof(T)); }

  [[gnu::pure]] operator T&() const noexcept { return object_; }
  void operator=(T value) noexcept { object_ = value; }
  void operator=(const Forced& other) noexcept { object_ = other.object_; }

 private:
  T& object_;
  const unsigned char* mask_;
  const unsigned char* value_;
};

/// One bit of a byte.
class ForcedPackedBit {
 public:
  ForcedPackedBit(PackedBitRef bit, uint8_t& byte, const unsigned char* mask, const unsigned char* value) noexcept
      : bit_(bit), byte_(byte, mask, value) {}
  ForcedPackedBit(const ForcedPackedBit&) = delete;

  [[gnu::pure]] operator bool() const noexcept { return bit_; }
  void operator=(bool value) noexcept { bit_ = value; }
  void operator=(const ForcedPackedBit& other) noexcept { bit_ = static_cast<bool>(other.bit_); }

 private:
  PackedBitRef bit_;
  Forced<uint8_t> byte_;
};

/// A value of several bytes, or an element of an indexed place: Ref is its WideRef or ElementRef, T its type. `mask`
/// and `value` belong to the byte at `bytes`; an element that is not there has no bytes to put back.
template <class Ref, class T>
class ForcedBytes {
 public:
  ForcedBytes(Ref ref, uint8_t* bytes, bool inside, const unsigned char* mask, const unsigned char* value) noexcept
      : ref_(ref), bytes_(bytes), mask_(mask), value_(value), size_(inside ? sizeof(T) : 0) {}
  ForcedBytes(const ForcedBytes&) = delete;
  ~ForcedBytes() { ApplyForces(bytes_, mask_, value_, size_); }

  [[gnu::pure]] operator T() const noexcept { return ref_; }
  void operator=(T value) noexcept { ref_ = value; }
  void operator=(const ForcedBytes& other) noexcept { ref_ = static_cast<T>(other.ref_); }

 private:
  Ref ref_;
  uint8_t* bytes_;
  const unsigned char* mask_;
  const unsigned char* value_;
  size_t size_;
};

}  // namespace plcxx
