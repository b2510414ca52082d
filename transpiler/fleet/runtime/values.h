// Values of all lanes: numbers as planes (one a bit), as rows (one element a lane), or the same constant in each; and
// the ways from one form to the other.
//
// A value is converted where the form that it has is not the one that is asked for: In<T>() for rows, Sliced() for
// planes.
#pragma once

#include <stdint.h>

#include "transpiler/fleet/runtime/planes.h"

#define PLCXX_UNROLL _Pragma("GCC unroll 64")

namespace plcxx_fleet {

template <unsigned N>
struct Unsigned;
template <>
struct Unsigned<1> {
  using Type = uint8_t;
};
template <>
struct Unsigned<2> {
  using Type = uint16_t;
};
template <>
struct Unsigned<4> {
  using Type = uint32_t;
};
template <>
struct Unsigned<8> {
  using Type = uint64_t;
};

template <class T>
inline T FromRaw(uint64_t raw) {
  const auto bits = static_cast<typename Unsigned<sizeof(T)>::Type>(raw);
  T value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}
template <class T>
inline uint64_t ToRaw(T value) {
  typename Unsigned<sizeof(T)>::Type bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// A number of N bits in each lane, least significant plane first.
template <unsigned N>
struct Bits {
  Plane p[N];
  const Plane& Bit(unsigned i) const { return p[i]; }
};

/// One element for each lane.
template <class T>
struct alignas(64) Lanes {
  T v[kLanes];
  T operator[](unsigned lane) const { return v[lane]; }
};

/// The same constant in each lane.
template <class T, uint64_t kRaw>
struct Fixed {
  Plane Bit(unsigned i) const { return AllEqual((kRaw >> i & 1) != 0); }
  T operator[](unsigned) const { return FromRaw<T>(kRaw); }
};

/// The same number in each lane, found when the code runs.
template <class T>
struct Uniform {
  T value;
  Plane Bit(unsigned i) const { return AllEqual((ToRaw(value) >> i & 1) != 0); }
  T operator[](unsigned) const { return value; }
};
template <>
struct Uniform<bool> {
  bool value;
  bool operator[](unsigned) const { return value; }
  operator Plane() const { return AllEqual(value); }
};
inline Plane ToPlane(const Uniform<bool>& bit) { return bit; }

/// A constant, so that code is not made for each.
template <class T, uint64_t kRaw>
inline Uniform<T> AsUniform(const Fixed<T, kRaw>&) {
  return {FromRaw<T>(kRaw)};
}
template <class Number>
inline const Number& AsUniform(const Number& value) {
  return value;
}

// --- eight planes as a row of bytes, and back ---------------------------------------------------------------------

/// Bit 8 * i + k becomes bit 8 * k + i.
inline uint64_t Transposed(uint64_t x) {
  uint64_t t = (x ^ (x >> 7)) & 0x00AA00AA00AA00AAULL;
  x = x ^ t ^ (t << 7);
  t = (x ^ (x >> 14)) & 0x0000CCCC0000CCCCULL;
  x = x ^ t ^ (t << 14);
  t = (x ^ (x >> 28)) & 0x00000000F0F0F0F0ULL;
  return x ^ t ^ (t << 28);
}

/// `bit(i)` gives plane i; the bytes of all lanes.
template <class BitOf>
inline void PlanesToBytes(BitOf&& bit, uint8_t* bytes) {
  for (unsigned w = 0; w < kWords; ++w) {
#if defined(__AVX512BW__)
    __m512i all = _mm512_setzero_si512();
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i)
      all = _mm512_or_si512(all, _mm512_maskz_set1_epi8(Word(bit(i), w), static_cast<char>(1U << i)));
    _mm512_storeu_si512(bytes + 64 * w, all);
#else
    for (unsigned k = 0; k < 8; ++k) {
      uint64_t x = 0;
      PLCXX_UNROLL
      for (unsigned i = 0; i < 8; ++i) x |= (Word(bit(i), w) >> (8 * k) & 0xFF) << (8 * i);
      x = Transposed(x);
      __builtin_memcpy(bytes + 64 * w + 8 * k, &x, 8);
    }
#endif
  }
}

inline void BytesToPlanes(const uint8_t* bytes, Plane* planes) {
  for (unsigned w = 0; w < kWords; ++w) {
#if defined(__AVX512BW__)
    const __m512i all = _mm512_loadu_si512(bytes + 64 * w);
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i)
      SetWord(planes[i], w, _mm512_test_epi8_mask(all, _mm512_set1_epi8(static_cast<char>(1U << i))));
#else
    uint64_t words[8] = {};
    for (unsigned k = 0; k < 8; ++k) {
      uint64_t x;
      __builtin_memcpy(&x, bytes + 64 * w + 8 * k, 8);
      x = Transposed(x);
      PLCXX_UNROLL
      for (unsigned i = 0; i < 8; ++i) words[i] |= (x >> (8 * i) & 0xFF) << (8 * k);
    }
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i) SetWord(planes[i], w, words[i]);
#endif
  }
}

/// 1 or 0 in each byte.
inline void PlaneToBytes(const Plane& plane, uint8_t* bytes) {
  for (unsigned w = 0; w < kWords; ++w) {
#if defined(__AVX512BW__)
    _mm512_storeu_si512(bytes + 64 * w, _mm512_maskz_set1_epi8(Word(plane, w), 1));
#else
    for (unsigned k = 0; k < 8; ++k) {
      uint64_t x = (Word(plane, w) >> (8 * k) & 0xFF) * 0x0101010101010101ULL & 0x8040201008040201ULL;
      x = (x + 0x7F7F7F7F7F7F7F7FULL) >> 7 & 0x0101010101010101ULL;
      __builtin_memcpy(bytes + 64 * w + 8 * k, &x, 8);
    }
#endif
  }
}

/// Of bytes that are 0 or 1.
inline Plane BytesToPlane(const uint8_t* bytes) {
  Plane plane{};
  for (unsigned w = 0; w < kWords; ++w) {
#if defined(__AVX512BW__)
    const __m512i all = _mm512_loadu_si512(bytes + 64 * w);
    SetWord(plane, w, _mm512_test_epi8_mask(all, all));
#else
    uint64_t word = 0;
    for (unsigned k = 0; k < 8; ++k) {
      uint64_t x;
      __builtin_memcpy(&x, bytes + 64 * w + 8 * k, 8);
      word |= (x * 0x0102040810204080ULL >> 56) << (8 * k);
    }
    SetWord(plane, w, word);
#endif
  }
  return plane;
}

// --- from planes to rows
// ------------------------------------------------------------------------------------------------

template <class T, class Number>
inline Lanes<T> RowsOf(const Number& number) {
  using Word = typename Unsigned<sizeof(T)>::Type;
  Lanes<Word> words;
  if constexpr (sizeof(T) == 1) {
    PlanesToBytes([&](unsigned i) { return number.Bit(i); }, words.v);
  } else {
    Lanes<uint8_t> bytes[sizeof(T)];
    for (unsigned b = 0; b < sizeof(T); ++b)
      PlanesToBytes([&](unsigned i) { return number.Bit(8 * b + i); }, bytes[b].v);
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      Word word = 0;
      PLCXX_UNROLL
      for (unsigned b = 0; b < sizeof(T); ++b)
        word = static_cast<Word>(word | static_cast<Word>(Word{bytes[b].v[lane]} << (8 * b)));
      words.v[lane] = word;
    }
  }
  Lanes<T> rows;
  __builtin_memcpy(&rows, &words, sizeof rows);
  return rows;
}

template <class T>
inline const Lanes<T>& In(const Lanes<T>& rows) {
  return rows;
}
template <class T, uint64_t kRaw>
inline const Fixed<T, kRaw>& In(const Fixed<T, kRaw>& value) {
  return value;
}
template <class T>
inline const Uniform<T>& In(const Uniform<T>& value) {
  return value;
}
template <class T, unsigned N>
inline Lanes<T> In(const Bits<N>& number) {
  static_assert(N == 8 * sizeof(T), "as wide as its type");
  return RowsOf<T>(number);
}
template <class T>
inline Lanes<bool> In(const Plane& plane) {
  static_assert(sizeof(T) == sizeof(bool), "a bit");
  Lanes<bool> rows;
  PlaneToBytes(plane, reinterpret_cast<uint8_t*>(rows.v));
  return rows;
}

// --- from rows to planes
// ------------------------------------------------------------------------------------------------

template <unsigned N>
inline const Bits<N>& Sliced(const Bits<N>& number) {
  return number;
}
inline const Plane& Sliced(const Plane& plane) { return plane; }
template <class T, uint64_t kRaw>
inline const Fixed<T, kRaw>& Sliced(const Fixed<T, kRaw>& value) {
  return value;
}
template <class T>
inline const Uniform<T>& Sliced(const Uniform<T>& value) {
  return value;
}
inline Plane Sliced(const Uniform<bool>& bit) { return bit; }
template <class T>
inline Bits<8 * sizeof(T)> Sliced(const Lanes<T>& rows) {
  Bits<8 * sizeof(T)> number;
  if constexpr (sizeof(T) == 1) {
    BytesToPlanes(reinterpret_cast<const uint8_t*>(rows.v), number.p);
  } else {
    using Word = typename Unsigned<sizeof(T)>::Type;
    Lanes<Word> words;
    __builtin_memcpy(&words, &rows, sizeof words);
    Lanes<uint8_t> bytes;
    for (unsigned b = 0; b < sizeof(T); ++b) {
      for (unsigned lane = 0; lane < kLanes; ++lane) bytes.v[lane] = static_cast<uint8_t>(words.v[lane] >> (8 * b));
      BytesToPlanes(bytes.v, number.p + 8 * b);
    }
  }
  return number;
}
inline Plane Sliced(const Lanes<bool>& rows) { return BytesToPlane(reinterpret_cast<const uint8_t*>(rows.v)); }

/// A number as planes, whatever form it has.
template <unsigned N, class Number>
inline Bits<N> Held(const Number& value) {
  const auto& number = Sliced(value);
  Bits<N> held;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) held.p[i] = number.Bit(i);
  return held;
}

/// Numbers whose bits are those of a floating point number.
template <class T, class Number>
inline Lanes<T> AsFloat(const Number& bits) {
  const auto& words = In<typename Unsigned<sizeof(T)>::Type>(bits);
  Lanes<T> rows;
  for (unsigned lane = 0; lane < kLanes; ++lane) rows.v[lane] = FromRaw<T>(words[lane]);
  return rows;
}

/// The rows of a value's raw bits.
template <class Raw, unsigned N>
inline Lanes<Raw> RawRows(const Bits<N>& number) {
  return In<Raw>(number);
}
template <class Raw, class T>
inline Lanes<Raw> RawRows(const Lanes<T>& rows) {
  static_assert(sizeof(Raw) == sizeof(T), "raw bits");
  Lanes<Raw> raw;
  __builtin_memcpy(&raw, &rows, sizeof raw);
  return raw;
}
template <class Raw, class T>
inline Uniform<Raw> RawRows(const Uniform<T>& value) {
  return {static_cast<Raw>(ToRaw(value.value))};
}
template <class Raw, class T, uint64_t kRaw>
inline Fixed<Raw, kRaw> RawRows(const Fixed<T, kRaw>&) {
  return {};
}

template <class T>
struct WithoutConst {
  using Type = T;
};
template <class T>
struct WithoutConst<const T> {
  using Type = T;
};
template <class T>
struct WithoutConst<const T&> {
  using Type = T;
};
template <class T>
using Value = typename WithoutConst<T>::Type;

// --- an operation that has no form in planes: its meaning, lane by lane
// ------------------------------------------------

template <class T>
constexpr bool kIsBool = false;
template <>
constexpr bool kIsBool<bool> = true;

template <class R, class Function, class... Operand>
inline auto PerLane(Function&& function, const Operand&... operand) {
  Lanes<R> rows;
  for (unsigned lane = 0; lane < kLanes; ++lane) rows.v[lane] = function(operand[lane]...);
  if constexpr (kIsBool<R>) {
    return Sliced(rows);
  } else {
    return rows;
  }
}

}  // namespace plcxx_fleet
