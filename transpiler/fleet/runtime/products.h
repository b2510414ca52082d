// Products of two numbers that both depend on the lane, shifts by such a number, and rotations by a constant.
//
// What each has to give is the function of runtime_support that transpiler/ir/ops.def names.
#pragma once

#include "transpiler/fleet/runtime/operations.h"

namespace plcxx_fleet {

/// a * b, modulo 2^N: numbers are mostly short, and most of their planes 0.
template <unsigned N>
[[gnu::noinline]] Bits<N> ProductOf(const Bits<N>& a, const Bits<N>& b) {
  const unsigned a_bits = UsedBits(a), b_bits = UsedBits(b);
  Bits<N> sum{};
  for (unsigned at = 0; at < b_bits; ++at) {
    const Plane takes = b.p[at];
    if (!Any(takes)) continue;
    Plane carry{};
    for (unsigned i = at; i < N; ++i) {
      if (i - at >= a_bits && !Any(carry)) break;
      const Plane p = sum.p[i], q = i - at < a_bits ? a.p[i - at] & takes : Zeros();
      sum.p[i] = p ^ q ^ carry;
      carry = (p & q) | (carry & (p | q));
    }
  }
  return sum;
}
template <unsigned N, class A, class B>
inline Bits<N> Product(const A& a, const B& b) {
  return ProductOf<N>(Held<N>(a), Held<N>(b));
}

constexpr unsigned LogOf(unsigned number) { return number == 1 ? 0 : 1 + LogOf(number / 2); }

/// Bit by bit of the count: by 1, by 2, by 4 ...; a count that is too great leaves nothing.
template <unsigned N, bool kLeft, class Count>
inline Bits<N> Shifted(Bits<N> number, const Count& count) {
  PLCXX_UNROLL
  for (unsigned k = 0; k < LogOf(N); ++k) {
    const unsigned by = 1U << k;
    const Plane shifts = count.Bit(k);
    Bits<N> moved{};
    PLCXX_UNROLL
    for (unsigned i = by; i < N; ++i) moved.p[kLeft ? i : i - by] = number.p[kLeft ? i - by : i];
    number = Select<N>(shifts, moved, number);
  }
  Plane far{};
  PLCXX_UNROLL
  for (unsigned k = LogOf(N); k < N; ++k) far |= count.Bit(k);
  return EachBit<N>(number, [&](const Plane& p) { return p & ~far; });
}
template <unsigned N, class A, class B>
inline Bits<N> ShiftLeftBy(const A& a, const B& count) {
  return Shifted<N, true>(Held<N>(a), Sliced(count));
}
template <unsigned N, class A, class B>
inline Bits<N> ShiftRightBy(const A& a, const B& count) {
  return Shifted<N, false>(Held<N>(a), Sliced(count));
}
/// Copies of the sign come in.
template <unsigned N, class A, class B>
inline Bits<N> ArithmeticShiftRightBy(const A& a, const B& count) {
  const auto& x = Sliced(a);
  const Plane sign = x.Bit(N - 1);
  const auto flipped = [&](const Plane& p) { return p ^ sign; };
  return EachBit<N>(Shifted<N, false>(EachBit<N>(x, flipped), Sliced(count)), flipped);
}

template <unsigned N, class A, class T, uint64_t kCount>
inline Bits<N> RotateLeft(const A& a, const Fixed<T, kCount>&) {
  const auto& x = Sliced(a);
  Bits<N> r;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) r.p[(i + kCount) % N] = x.Bit(i);
  return r;
}
template <unsigned N, class A, class T, uint64_t kCount>
inline Bits<N> RotateRight(const A& a, const Fixed<T, kCount>&) {
  return RotateLeft<N>(a, Fixed<T, N - kCount % N>{});
}

}  // namespace plcxx_fleet
