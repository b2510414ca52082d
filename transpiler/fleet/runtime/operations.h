// Operations that have a form in planes. The rows of sliced_operations.def name them; what each has to give is the
// function of runtime_support that transpiler/ir/ops.def names.
//
// Operands are planes, rows or constants; constants disappear when the loops over the bits are unrolled.
#pragma once

#include "transpiler/fleet/runtime/values.h"

namespace plcxx_fleet {

template <unsigned N, class A, class Function>
inline Bits<N> EachBit(const A& a, Function&& function) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[i] = function(x.Bit(i));
  return r;
}
template <unsigned N, class A, class B, class Function>
inline Bits<N> EachBit(const A& a, const B& b, Function&& function) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[i] = function(x.Bit(i), y.Bit(i));
  return r;
}

inline Plane BitAnd(const Plane& a, const Plane& b) { return a & b; }
inline Plane BitOr(const Plane& a, const Plane& b) { return a | b; }
inline Plane BitXor(const Plane& a, const Plane& b) { return a ^ b; }
inline Plane BitNot(const Plane& a) { return ~a; }

template <unsigned N, class A, class B>
inline Bits<N> And(const A& a, const B& b) {
  return EachBit<N>(a, b, [](const Plane& x, const Plane& y) { return x & y; });
}
template <unsigned N, class A, class B>
inline Bits<N> Or(const A& a, const B& b) {
  return EachBit<N>(a, b, [](const Plane& x, const Plane& y) { return x | y; });
}
template <unsigned N, class A, class B>
inline Bits<N> Xor(const A& a, const B& b) {
  return EachBit<N>(a, b, [](const Plane& x, const Plane& y) { return x ^ y; });
}
template <unsigned N, class A>
inline Bits<N> Not(const A& a) {
  return EachBit<N>(a, [](const Plane& x) { return ~x; });
}
template <unsigned N, class A, class B>
inline Bits<N> Select(const Plane& condition, const A& a, const B& b) {
  return EachBit<N>(a, b, [&](const Plane& x, const Plane& y) { return Choose(condition, x, y); });
}

/// The bits from `kFrom` on, with 0 above them.
template <unsigned N, unsigned kFrom, unsigned kWidth, class A>
inline Bits<N> Part(const A& a) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[i] = i < kWidth ? Plane(x.Bit(kFrom + i)) : Zeros();
  return r;
}
template <unsigned N, unsigned kWidth, class A>
inline Bits<N> SignExtended(const A& a) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[i] = x.Bit(i < kWidth ? i : kWidth - 1);
  return r;
}
template <unsigned N>
inline Bits<N> WidenBit(const Plane& bit) {
  Bits<N> r{};
  r.p[0] = bit;
  return r;
}
template <unsigned kHalf, class A, class B>
inline Bits<2 * kHalf> Pair(const A& low, const B& high) {
  const auto& x = Sliced(low);
  const auto& y = Sliced(high);
  Bits<2 * kHalf> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < kHalf; ++i) {
    r.p[i] = x.Bit(i);
    r.p[kHalf + i] = y.Bit(i);
  }
  return r;
}
template <class A, class B>
inline Bits<16> WithLowByte(const A& word, const B& low) {
  return Pair<8>(low, Part<8, 8, 8>(word));
}
template <class A>
inline Bits<8> SwapNibbles(const A& a) {
  const auto& x = Sliced(a);
  Bits<8> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < 8; ++i) r.p[i] = x.Bit((i + 4) % 8);
  return r;
}

/// a + b + carry, modulo 2^N; the carry out is left in `carry`.
template <unsigned N, class A, class B>
inline Bits<N> AddWithCarry(const A& a, const B& b, Plane& carry) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) {
    const Plane p = x.Bit(i), q = y.Bit(i);
    r.p[i] = p ^ q ^ carry;
    carry = (p & q) | (carry & (p | q));
  }
  return r;
}
template <unsigned N, class A, class B>
inline Bits<N> Add(const A& a, const B& b) {
  Plane carry{};
  return AddWithCarry<N>(a, b, carry);
}
/// a - b - borrow; the borrow out is left in `borrow`.
template <unsigned N, class A, class B>
inline Bits<N> SubWithBorrow(const A& a, const B& b, Plane& borrow) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) {
    const Plane p = x.Bit(i), q = y.Bit(i);
    r.p[i] = p ^ q ^ borrow;
    borrow = (~p & q) | (borrow & (~p | q));
  }
  return r;
}
template <unsigned N, class A, class B>
inline Bits<N> Sub(const A& a, const B& b) {
  Plane borrow{};
  return SubWithBorrow<N>(a, b, borrow);
}
template <unsigned N, class A>
inline Bits<N> Minus(const A& a) {
  return Sub<N>(Fixed<uint64_t, 0>{}, a);
}
template <unsigned N, class A>
inline Bits<N> Abs(const A& a) {
  const auto& x = Sliced(a);
  return Select<N>(x.Bit(N - 1), Minus<N>(x), x);
}

template <unsigned N, class A, class B>
inline Plane NotEqual(const A& a, const B& b) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  Plane differs{};
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) differs |= x.Bit(i) ^ y.Bit(i);
  return differs;
}
template <unsigned N, class A, class B>
inline Plane Equal(const A& a, const B& b) {
  return ~NotEqual<N>(a, b);
}
template <unsigned N, class A>
inline Plane IsZero(const A& a) {
  return Equal<N>(a, Fixed<uint64_t, 0>{});
}
template <unsigned N, class A, class B>
inline Plane Less(const A& a, const B& b) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  Plane less{};
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) {
    const Plane p = x.Bit(i), q = y.Bit(i);
    less = (~p & q) | (less & (~p | q));
  }
  return less;
}
template <unsigned N, class A, class B>
inline Plane LessEqual(const A& a, const B& b) {
  return ~Less<N>(b, a);
}
template <unsigned N, class A, class B>
inline Plane Greater(const A& a, const B& b) {
  return Less<N>(b, a);
}
template <unsigned N, class A, class B>
inline Plane GreaterEqual(const A& a, const B& b) {
  return ~Less<N>(a, b);
}
/// Of two's complement: the highest bit counts the other way round.
template <unsigned N, class A, class B>
inline Plane SignedLess(const A& a, const B& b) {
  const auto& x = Sliced(a);
  const auto& y = Sliced(b);
  const Plane less = Less<N - 1>(x, y), p = x.Bit(N - 1), q = y.Bit(N - 1);
  return (p & ~q) | (less & (p | ~q));
}
template <unsigned N, class A, class B>
inline Plane SignedLessEqual(const A& a, const B& b) {
  return ~SignedLess<N>(b, a);
}
template <unsigned N, class A, class B>
inline Plane SignedGreater(const A& a, const B& b) {
  return SignedLess<N>(b, a);
}
template <unsigned N, class A, class B>
inline Plane SignedGreaterEqual(const A& a, const B& b) {
  return ~SignedLess<N>(a, b);
}

template <unsigned N, class A>
inline Plane SignBit(const A& a) {
  return Sliced(a).Bit(N - 1);
}

// --- by a constant number of places
// -----------------------------------------------------------------------------------

template <unsigned N, class A, class T, uint64_t kCount>
inline Bits<N> ShiftLeft(const A& a, const Fixed<T, kCount>&) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[i] = i >= kCount ? Plane(x.Bit(static_cast<unsigned>(i - kCount))) : Zeros();
  return r;
}
template <unsigned N, class A, class T, uint64_t kCount>
inline Bits<N> ShiftRight(const A& a, const Fixed<T, kCount>&) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i)
    r.p[i] = kCount < N - i ? Plane(x.Bit(static_cast<unsigned>(i + kCount % N))) : Zeros();
  return r;
}
template <unsigned N, class A, class T, uint64_t kBit>
inline Plane TestBit(const A& a, const Fixed<T, kBit>&) {
  if constexpr (kBit < N) {
    return Sliced(a).Bit(kBit);
  } else {
    return Zeros();
  }
}
template <unsigned N, class T, uint64_t kPosition>
inline Bits<N> BitAt(const Plane& bit, const Fixed<T, kPosition>&) {
  Bits<N> r{};
  if constexpr (kPosition < N) r.p[kPosition] = bit;
  return r;
}

/// a * kBy, modulo 2^N: a sum of shifted numbers, or a difference where a row of ones ends (7 is 8 - 1).
template <unsigned N, class A, class T, uint64_t kBy>
inline Bits<N> Times(const A& a, const Fixed<T, kBy>&) {
  const auto& x = Sliced(a);
  Bits<N> r{};
  uint64_t left = kBy;
  PLCXX_UNROLL
  for (unsigned at = 0; at < N; ++at, left >>= 1) {
    if ((left & 1) == 0) continue;
    const bool minus = (left & 3) == 3;
    Bits<N> shifted{};
    PLCXX_UNROLL
    for (unsigned i = at; i < N; ++i) shifted.p[i] = x.Bit(i - at);
    r = minus ? Sub<N>(r, shifted) : Add<N>(r, shifted);
    left = minus ? left + 1 : left - 1;
  }
  return r;
}
template <unsigned N, class T, uint64_t kBy, class A>
inline Bits<N> TimesFirst(const Fixed<T, kBy>& by, const A& a) {
  return Times<N>(a, by);
}

/// The number of the highest bit that is 1, from 1 on; 0: none is.
template <class A>
inline Bits<8> HighestBit(const A& a) {
  const auto& x = Sliced(a);
  Bits<8> number{};
  Plane above{};
  PLCXX_UNROLL
  for (unsigned i = 8; i-- > 0;) {
    const Plane highest = x.Bit(i) & ~above;
    PLCXX_UNROLL
    for (unsigned b = 0; b < 4; ++b) {
      if (((i + 1) >> b & 1) != 0) number.p[b] |= highest;
    }
    above |= x.Bit(i);
  }
  return number;
}
/// The bit of that number.
template <class A>
inline Bits<8> OneHot(const A& number) {
  Bits<8> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < 8; ++i) r.p[i] = Equal<8>(number, Uniform<uint8_t>{static_cast<uint8_t>(i + 1)});
  return r;
}

/// How many of the lower planes have a 1 in a lane.
template <unsigned N>
inline unsigned UsedBits(const Bits<N>& number) {
  unsigned bits = N;
  while (bits > 0 && !Any(number.p[bits - 1])) --bits;
  return bits;
}

// --- decimal digits -------------------------------------------------------------------------------------------------

/// The lowest decimal digits of a number, four bits each: bit by bit from above, everything is doubled, and a digit
/// that would become ten or more has three added first.
template <unsigned N, class A>
inline Bits<N> ToBcd(const A& a) {
  const auto& x = Sliced(a);
  Bits<N> r{};
  PLCXX_UNROLL
  for (unsigned at = N; at-- > 0;) {
    Plane carry = x.Bit(at);
    PLCXX_UNROLL
    for (unsigned d = 0; d < N; d += 4) {
      const Plane b0 = r.p[d], b1 = r.p[d + 1], b2 = r.p[d + 2], b3 = r.p[d + 3];
      const Plane five = b3 | (b2 & (b1 | b0));  // 5 or more: 2 * b is 10 + 2 * (b - 5)
      r.p[d] = carry;
      r.p[d + 1] = b0 ^ five;
      r.p[d + 2] = Choose(five, ~(b1 ^ b0), b1);
      r.p[d + 3] = Choose(five, b3 & b0, b2);
      carry = five;
    }
  }
  return r;
}
/// How many bits so many nibbles need: 15, 15 * 11, 15 * 1111 ...
constexpr unsigned DigitBits(unsigned digits) { return digits == 1 ? 4 : digits == 2 ? 8 : digits == 4 ? 15 : 28; }
constexpr uint64_t TenToThe(unsigned digits) { return digits == 0 ? 1 : 10 * TenToThe(digits - 1); }

/// The number of decimal digits from a bit on, half by half; nibbles above 9 count with their weight, too.
template <unsigned kDigits, class A>
inline Bits<DigitBits(kDigits)> FromDigits(const A& x, unsigned from) {
  constexpr unsigned kHalf = kDigits / 2, kBits = DigitBits(kDigits);
  if constexpr (kDigits == 1) {
    Bits<4> digit;
    PLCXX_UNROLL
    for (unsigned i = 0; i < 4; ++i) digit.p[i] = x.Bit(from + i);
    return digit;
  } else {
    const auto low = Part<kBits, 0, DigitBits(kHalf)>(FromDigits<kHalf>(x, from));
    const auto high = Part<kBits, 0, DigitBits(kHalf)>(FromDigits<kHalf>(x, from + 4 * kHalf));
    return Add<kBits>(Times<kBits>(high, Fixed<uint64_t, TenToThe(kHalf)>{}), low);
  }
}
template <unsigned N, class A>
inline Bits<N> FromBcd(const A& a) {
  return Part<N, 0, DigitBits(N / 4)>(FromDigits<N / 4>(Sliced(a), 0));
}
/// The highest bit is the sign.
template <class A>
inline Bits<32> FromSignedBcd(const A& a) {
  const auto& x = Sliced(a);
  Bits<32> digits = Held<32>(x);
  digits.p[31] = Zeros();
  const Bits<32> number = FromBcd<32>(digits);
  const Plane negative = x.Bit(31);
  return Any(negative) ? Select<32>(negative, Minus<32>(number), number) : number;
}
/// Whether one of the nibbles is above 9.
template <unsigned N, class A>
inline Plane HasNoDigit(const A& a) {
  const auto& x = Sliced(a);
  Plane any{};
  PLCXX_UNROLL
  for (unsigned d = 0; d < N; d += 4) any |= x.Bit(d + 3) & (x.Bit(d + 2) | x.Bit(d + 1));
  return any;
}

}  // namespace plcxx_fleet
