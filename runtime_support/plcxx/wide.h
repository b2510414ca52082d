// What makes m[DW10] work when DW10 is a value of several bytes that the program also reads in other widths, at odd
// addresses, or by an index: tags, and what indexing with them returns.
//
// A value is copied from and to its bytes, so that neither the target's byte order nor its alignment matters, and no
// pointer is read as another type; compilers make one load or store of it where the processor has one, with a variable
// index, too: composed of its bytes by shifts it is several there. Implements PROSTEP 5.2
// (words at any address, least significant byte first) and FM 15 to 18 (indirect access).
// Not here: words that have a member of State to themselves (they are plain references), single bits (tags.h).
#pragma once

#include <stdint.h>

namespace plcxx {

/// Which byte of a value stands first.
enum class ByteOrder : uint8_t { kLittle, kBig };

/// Tag of a value of type T that begins with byte `byte` of a block of memory.
template <class T, ByteOrder kOrder>
struct Wide {
  using Value = T;
  static constexpr ByteOrder kByteOrder = kOrder;
  uint16_t byte;
};
template <class T>
using Little = Wide<T, ByteOrder::kLittle>;
template <class T>
using Big = Wide<T, ByteOrder::kBig>;

/// The same of the retentive block.
template <class T, ByteOrder kOrder>
struct RetentiveWide {
  using Value = T;
  static constexpr ByteOrder kByteOrder = kOrder;
  uint16_t byte;
};
template <class T>
using RetentiveLittle = RetentiveWide<T, ByteOrder::kLittle>;
template <class T>
using RetentiveBig = RetentiveWide<T, ByteOrder::kBig>;

/// Tag of values that follow each other at a distance of `stride` bytes: `count` of them, the one with the index
/// `lowest` at byte `first` of a block of memory. Tag says what the values are, and in which block.
template <class Tag>
struct Indexed {
  uint16_t first;
  uint16_t stride;
  int32_t lowest;
  uint32_t count;
};

/// One of them: `place` when there is one with the index, nothing otherwise.
template <class Tag>
struct Element {
  Tag place;
  bool inside;
};

/// The element `index`, read as two's complement, of an indexed place. One that is not there reads 0 and keeps nothing.
template <class Tag>
[[gnu::const, gnu::always_inline]] constexpr inline Element<Tag> At(Indexed<Tag> place, uint32_t index) noexcept {
  const uint32_t number = index - static_cast<uint32_t>(place.lowest);  // wraps far beyond `count` when it is lower
  const bool inside = number < place.count;
  return {{static_cast<uint16_t>(inside ? place.first + number * place.stride : place.first)}, inside};
}

namespace wide {

/// The bits of a value as an integer, and back.
template <class T>
struct Bits;
template <>
struct Bits<uint8_t> {
  using Integer = uint8_t;
};
template <>
struct Bits<uint16_t> {
  using Integer = uint16_t;
};
template <>
struct Bits<uint32_t> {
  using Integer = uint32_t;
};
template <>
struct Bits<uint64_t> {
  using Integer = uint64_t;
};
template <>
struct Bits<float> {
  using Integer = uint32_t;
};
template <>
struct Bits<double> {
  using Integer = uint64_t;
};

/// The bytes of an integer in the other order.
[[gnu::const, gnu::always_inline]] constexpr inline uint8_t Swapped(uint8_t value) noexcept { return value; }
[[gnu::const, gnu::always_inline]] constexpr inline uint16_t Swapped(uint16_t value) noexcept {
  return __builtin_bswap16(value);
}
[[gnu::const, gnu::always_inline]] constexpr inline uint32_t Swapped(uint32_t value) noexcept {
  return __builtin_bswap32(value);
}
[[gnu::const, gnu::always_inline]] constexpr inline uint64_t Swapped(uint64_t value) noexcept {
  return __builtin_bswap64(value);
}

/// As the target stores integers.
constexpr ByteOrder kOfTarget = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? ByteOrder::kLittle : ByteOrder::kBig;

template <class Integer, ByteOrder kOrder>
[[gnu::pure, gnu::always_inline]] inline Integer Load(const uint8_t* bytes) noexcept {
  Integer value;
  __builtin_memcpy(&value, bytes, sizeof value);
  return kOrder == kOfTarget ? value : Swapped(value);
}

template <class Integer, ByteOrder kOrder>
[[gnu::always_inline]] inline void Store(uint8_t* bytes, Integer value) noexcept {
  const Integer stored = kOrder == kOfTarget ? value : Swapped(value);
  __builtin_memcpy(bytes, &stored, sizeof stored);
}

}  // namespace wide

/// The value that these bytes hold.
template <class T, ByteOrder kOrder>
[[gnu::pure, gnu::always_inline]] inline T ReadBytes(const uint8_t* bytes) noexcept {
  using Integer = typename wide::Bits<T>::Integer;
  const Integer raw = wide::Load<Integer, kOrder>(bytes);
  T value;
  static_assert(sizeof value == sizeof raw, "float is binary32, double is binary64");
  __builtin_memcpy(&value, &raw, sizeof value);
  return value;
}

template <class T, ByteOrder kOrder>
[[gnu::always_inline]] inline void WriteBytes(uint8_t* bytes, T value) noexcept {
  using Integer = typename wide::Bits<T>::Integer;
  Integer raw;
  __builtin_memcpy(&raw, &value, sizeof raw);
  wide::Store<Integer, kOrder>(bytes, raw);
}

/// A value of several bytes, for reading and writing.
template <class T, ByteOrder kOrder>
class WideRef {
 public:
  [[gnu::always_inline]] constexpr explicit WideRef(uint8_t* bytes) noexcept : bytes_(bytes) {}
  constexpr WideRef(const WideRef&) noexcept = default;
  ~WideRef() = default;

  [[gnu::pure, gnu::always_inline]] operator T() const noexcept { return ReadBytes<T, kOrder>(bytes_); }

  [[gnu::always_inline]] WideRef& operator=(T value) noexcept {
    WriteBytes<T, kOrder>(bytes_, value);
    return *this;
  }
  /// m[A] = m[B] assigns the value, never the reference.
  [[gnu::always_inline]] WideRef& operator=(const WideRef& other) noexcept { return *this = static_cast<T>(other); }

 private:
  uint8_t* bytes_;
};

/// An element of an indexed place, for reading and writing.
template <class T, ByteOrder kOrder>
class ElementRef {
 public:
  [[gnu::always_inline]] constexpr ElementRef(uint8_t* bytes, bool inside) noexcept : bytes_(bytes), inside_(inside) {}
  constexpr ElementRef(const ElementRef&) noexcept = default;
  ~ElementRef() = default;

  [[gnu::pure, gnu::always_inline]] operator T() const noexcept { return inside_ ? ReadBytes<T, kOrder>(bytes_) : T{}; }

  [[gnu::always_inline]] ElementRef& operator=(T value) noexcept {
    if (inside_) WriteBytes<T, kOrder>(bytes_, value);
    return *this;
  }
  [[gnu::always_inline]] ElementRef& operator=(const ElementRef& other) noexcept {
    return *this = static_cast<T>(other);
  }

 private:
  uint8_t* bytes_;
  bool inside_;
};

}  // namespace plcxx
