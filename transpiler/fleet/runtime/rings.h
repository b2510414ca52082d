// Rotary parts: the shortest way round a ring of a constant number of places, and counters of positions.
//
// What each has to give is the function of runtime_support of the same name.
#pragma once

#include "transpiler/fleet/runtime/steps.h"

namespace plcxx_fleet {

template <class T, uint64_t kPlaces, class A, class B>
inline Plane OnRing(const Fixed<T, kPlaces>& places, const A& from, const B& to) {
  if constexpr (kPlaces == 0 || kPlaces > 0x7FFFFFFF) return Zeros();
  return Less<32>(from, places) & Less<32>(to, places);
}
template <class T, uint64_t kPlaces, class A, class B>
inline Bits<32> StepsForward(const Fixed<T, kPlaces>& places, const A& from, const B& to) {
  Plane borrow{};
  const Bits<32> steps = SubWithBorrow<32>(to, from, borrow);
  return Select<32>(borrow, Add<32>(steps, places), steps);
}
template <class Number>
inline Plane IsForward(const Bits<32>& forward, const Number& places) {
  return LessEqual<32>(forward, Sub<32>(places, forward)) | IsZero<32>(forward);
}
template <class T, uint64_t kPlaces, class A, class B>
inline Plane RingForward(const Fixed<T, kPlaces>& places, const A& from, const B& to) {
  return IsForward(StepsForward(places, from, to), places);
}
template <class T, uint64_t kPlaces, class A, class B>
inline Bits<32> RingSteps(const Fixed<T, kPlaces>& places, const A& from, const B& to) {
  const Bits<32> forward = StepsForward(places, from, to);
  return Select<32>(IsForward(forward, places), forward, Sub<32>(places, forward));
}
template <class T, uint64_t kPlaces, class A, class B>
inline Bits<32> RingBefore(const Fixed<T, kPlaces>& places, const A& from, const B& to) {
  constexpr Fixed<uint32_t, 1> kOne{};
  const Bits<32> before = Select<32>(IsZero<32>(to), Sub<32>(places, kOne), Sub<32>(to, kOne));
  const Bits<32> next = Add<32>(to, kOne);
  const Bits<32> after = Select<32>(Equal<32>(next, places), Fixed<uint32_t, 0>{}, next);
  const Bits<32> there = Select<32>(RingForward(places, from, to), before, after);
  return Select<32>(Equal<32>(from, to), to, there);
}

inline Bits<8> CounterPins(const Plane& reset, const Plane& down, const Plane& low) {
  Bits<8> pins{};
  pins.p[0] = reset;
  pins.p[1] = down;
  pins.p[2] = low;
  return pins;
}

/// value 32, preset 32, loaded, previous, output
template <class Preset, class Pins, class M>
inline Plane StepPositionCounter(State& m, unsigned first, const Plane& input, const Preset& preset_value,
                                 const Pins& pin_values, bool holds, const M& active) {
  const auto& preset = Sliced(preset_value);
  const auto& pins = Sliced(pin_values);
  const Plane reset = pins.Bit(0), down = pins.Bit(1);
  Bits<32> low{};
  low.p[0] = pins.Bit(2);
  const auto at_end = [&](const Bits<32>& value) {
    return Choose(down, SignedLessEqual<32>(value, low), SignedGreaterEqual<32>(value, preset));
  };
  Bits<32> value = FieldAt<32>(m, first);
  const Plane starts = reset | ~m.planes[first + 64], edge = input & ~m.planes[first + 65] & ~starts;
  const auto changes = Within(active, starts | edge);
  if (Any(changes)) {
    constexpr Fixed<uint32_t, 1> kOne{};
    const Plane ends = at_end(value);
    const Bits<32> begin = Select<32>(down, preset, low);
    const Bits<32> next = Select<32>(down, Sub<32>(value, kOne), Add<32>(value, kOne));
    const Bits<32> counted = Select<32>(ends, holds ? value : begin, next);
    value = Select<32>(starts, begin, Select<32>(edge, counted, value));
    PutField<32>(m, first, value, changes);
    PutPlane(m, first + 64, Ones(), active);
  }
  PutPlane(m, first + 65, input, active);
  PutField<32>(m, first + 32, preset, active);
  const Plane output = ~reset & at_end(value);
  PutPlane(m, first + 66, output, active);
  return output;
}
template <class Preset, class Pins, class M>
inline Plane CountRing(State& m, unsigned first, const Plane& input, const Preset& preset, const Pins& pins,
                       const M& active) {
  return StepPositionCounter(m, first, input, preset, pins, false, active);
}
template <class Preset, class Pins, class M>
inline Plane CountHold(State& m, unsigned first, const Plane& input, const Preset& preset, const Pins& pins,
                       const M& active) {
  return StepPositionCounter(m, first, input, preset, pins, true, active);
}

}  // namespace plcxx_fleet
