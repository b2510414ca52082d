// Operations of state instances: those that have a form in planes, and all others lane by lane.
//
// In: the first plane of an instance; its fields follow in the order of transpiler/ir/states.def, a plane for each bit.
// What each has to do is the function of runtime_support of the same name.
#pragma once

#include "plcxx/texts.h"
#include "transpiler/fleet/runtime/machine.h"

namespace plcxx_fleet {

template <unsigned N>
inline Bits<N> FieldAt(const State& m, unsigned first) {
  Bits<N> number;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) number.p[i] = m.planes[first + i];
  return number;
}
template <unsigned N, class Number, class M>
inline void PutField(State& m, unsigned first, const Number& value, const M& active) {
  const auto& number = Sliced(value);
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) PutPlane(m, first + i, number.Bit(i), active);
}

// --- lane by lane: the code generator writes a Fields for each kind of instance that needs one -----------------------

template <class Instance>
struct Fields;

template <class T>
inline Lanes<T> FieldRows(const State& m, unsigned first) {
  if constexpr (kIsBool<T>) {
    return In<bool>(m.planes[first]);
  } else {
    return RowsOf<T>(FieldAt<8 * sizeof(T)>(m, first));
  }
}
template <class T, class M>
inline void PutFieldRows(State& m, unsigned first, const Lanes<T>& rows, const M& active) {
  if constexpr (kIsBool<T>) {
    PutPlane(m, first, Sliced(rows), active);
  } else {
    PutField<8 * sizeof(T)>(m, first, rows, active);
  }
}

template <class Instance, class R, class M, class Function, class... Operand>
inline auto StepPerLane(State& m, unsigned first, const M& active, Function&& function, const Operand&... operand) {
  Fields<Instance> fields;
  fields.Take(m, first);
  if constexpr (kIsBool<R>) {
    Lanes<bool> results;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      Instance instance = fields.Get(lane);
      results.v[lane] = function(instance, operand[lane]...);
      fields.Set(lane, instance);
    }
    fields.Give(m, first, active);
    return Sliced(results);
  } else {
    Lanes<R> results;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      Instance instance = fields.Get(lane);
      results.v[lane] = function(instance, operand[lane]...);
      fields.Set(lane, instance);
    }
    fields.Give(m, first, active);
    return results;
  }
}

/// Compares the text of an inbox with a literal.
template <class Flag, class Inbox, class M>
inline void UpdateTextPerLane(State& m, unsigned flag_first, unsigned inbox_first, const char* literal,
                              const M& active) {
  Fields<Flag> flags;
  Fields<Inbox> inboxes;
  flags.Take(m, flag_first);
  inboxes.Take(m, inbox_first);
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    Flag flag = flags.Get(lane);
    plcxx::UpdateText(flag, inboxes.Get(lane), literal);
    flags.Set(lane, flag);
  }
  flags.Give(m, flag_first, active);
}

// --- on-delay timers
// ----------------------------------------------------------------------------------------------------

/// The upper halves of times are rarely touched: they are 0, or those of a moment ago. `kBits` of them are computed.
template <unsigned kBits, class Preset, class M>
inline Plane PassDelay(State& m, unsigned first, const Bits<32>& now, const Plane& runs, const Plane& counts,
                       const Preset& preset, const M& active) {
  Plane borrow{}, carry{};
  const Bits<kBits> before = FieldAt<kBits>(m, first);
  const Bits<kBits> passed = SubWithBorrow<kBits>(now, FieldAt<kBits>(m, first + 32), borrow);
  if constexpr (kBits < 32) {  // time that goes back has passed nearly 2^32 ms
    if (Any(borrow)) return PassDelay<32>(m, first, now, runs, counts, preset, active);
  }
  const Bits<kBits> sum = AddWithCarry<kBits>(before, passed, carry);
  const Plane overflow = kBits == 32 ? carry : Zeros();  // what is short does not overflow
  Bits<32> elapsed{};
  PLCXX_UNROLL
  for (unsigned i = 0; i < kBits; ++i) elapsed.p[i] = counts & Choose(runs, sum.p[i] | overflow, before.p[i]);
  PutField<kBits>(m, first, elapsed, active);
  PutField<kBits>(m, first + 32, now, active);
  return GreaterEqual<32>(elapsed, preset);
}
/// Whether `kBits` hold what has passed and the sum: both numbers are below 2^(kBits - 1).
template <unsigned kBits>
inline bool IsShort(const State& m, unsigned first, const Bits<32>& now) {
  Plane any{};
  PLCXX_UNROLL
  for (unsigned i = kBits - 1; i < 32; ++i) any |= m.planes[first + i] | (now.p[i] ^ m.planes[first + 32 + i]);
  return !Any(any);
}
template <class Preset, class Time, class M>
inline void OnDelay(State& m, unsigned first, const Plane& input, const Preset& preset, const Time& time,
                    const M& active) {
  const unsigned kInput = first + 64, kDone = first + 66, kTiming = first + 67;
  const Bits<32> now = Held<32>(time);
  const Plane was = m.planes[kInput], hold = m.planes[first + 65], done = m.planes[kDone];
  const Plane runs = input & was & ~hold, counts = input & was;
  // Times of the same stretch of 2^15 ms differ by less than that.
  const Plane reached = IsShort<16>(m, first, now) ? PassDelay<16>(m, first, now, runs, counts, preset, active)
                                                   : PassDelay<32>(m, first, now, runs, counts, preset, active);
  PutPlane(m, kTiming, input & Choose(done, m.planes[kTiming], ~reached), active);
  PutPlane(m, kDone, input & (done | reached), active);
  PutPlane(m, kInput, input, active);
}

// --- edges
// --------------------------------------------------------------------------------------------------------------

template <class M>
inline Plane Rising(State& m, unsigned first, const Plane& signal, const M& active) {
  const Plane rises = signal & ~m.planes[first];
  PutPlane(m, first, signal, active);
  return rises;
}
template <class M>
inline Plane Falling(State& m, unsigned first, const Plane& signal, const M& active) {
  const Plane falls = ~signal & m.planes[first];
  PutPlane(m, first, signal, active);
  return falls;
}
template <class M>
inline void PresetEdge(State& m, unsigned first, const Plane& signal, const M& active) {
  PutPlane(m, first, signal, active);
}

// --- ring counters
// ------------------------------------------------------------------------------------------------------

/// What TakeCountInput and CountEdge do; `carry` is that of before.
struct Counting {
  Plane edge, counted, carry;
};
template <class Modulus, class M>
inline Counting CountEdges(State& m, unsigned first, const Plane& input, const Modulus& modulus_value,
                           const Plane& carry, const Plane& carry_at_edge, const M& active) {
  const unsigned kCount = first + 32, kInput = first + 40;
  const auto& modulus = Sliced(modulus_value);
  const Plane down = m.planes[first + 41], reset = m.planes[first + 42];
  const Plane edge = input & ~m.planes[kInput] & ~reset;
  const Plane valid = LessEqual<16>(Fixed<uint16_t, 2>{}, modulus) & LessEqual<16>(modulus, Fixed<uint16_t, 255>{});
  const Plane counted = edge & valid;
  const Bits<8> count = FieldAt<8>(m, kCount), highest = Sub<8>(modulus, Fixed<uint8_t, 1>{});
  const Plane zero = IsZero<8>(count), wraps = GreaterEqual<8>(count, highest);
  const Bits<8> lower = Select<8>(zero, highest, Sub<8>(count, Fixed<uint8_t, 1>{}));
  const Bits<8> higher = Select<8>(wraps, Fixed<uint8_t, 0>{}, Add<8>(count, Fixed<uint8_t, 1>{}));
  PutField<8>(m, kCount, Select<8>(down, lower, higher), Within(active, counted));
  PutPlane(m, kInput, input & ~reset, active);
  return {edge, counted, Choose(edge, carry_at_edge, carry) | (counted & Choose(down, zero, wraps))};
}
template <class Modulus, class Cycle, class M>
[[gnu::noinline]] Plane CountSomeInPart(State& m, unsigned first, const Plane& input, const Modulus& modulus,
                                        const Cycle& cycle, unsigned part, const M& active) {
  const Counting counting = CountEdges(m, first, input, modulus, Zeros(), Zeros(), active);
  PutPlane(m, first + 43, counting.carry, active);
  const auto carried = Within(active, counting.carry);
  if (Any(carried)) {
    PutField<32>(m, first, cycle, carried);
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i) PutPlane(m, first + 44 + i, AllEqual((part >> i & 1) != 0), carried);
  }
  return ~counting.edge | counting.counted;
}
/// In most steps no lane has an edge; one function for all counters does the others.
template <class Modulus, class Cycle, class M>
inline Plane CountInPart(State& m, unsigned first, const Plane& input, const Modulus& modulus, const Cycle& cycle,
                         unsigned part, const M& active) {
  const Plane taken = input & ~m.planes[first + 42];
  if (__builtin_expect(Any(taken & ~m.planes[first + 40]), 0))
    return CountSomeInPart(m, first, input, AsUniform(modulus), AsUniform(cycle), part, active);
  PutPlane(m, first + 40, taken, active);
  PutPlane(m, first + 43, Zeros(), active);
  return Ones();
}
template <class Modulus, class Cycle, class M>
inline Plane CountSlow(State& m, unsigned first, const Plane& input, const Modulus& modulus, const Cycle& cycle,
                       const M& active) {
  return CountInPart(m, first, input, modulus, cycle, 1, active);
}
template <class Modulus, class Cycle, class M>
inline Plane CountFast(State& m, unsigned first, const Plane& input, const Modulus& modulus, const Cycle& cycle,
                       const M& active) {
  return CountInPart(m, first, input, modulus, cycle, 2, active);
}
template <class Modulus, class M>
inline Plane CountCarryWhileInput(State& m, unsigned first, const Plane& input, const Modulus& modulus,
                                  const M& active) {
  const Plane carry = m.planes[first + 43] & input;
  const Counting counting = CountEdges(m, first, input, modulus, carry, carry, active);
  PutPlane(m, first + 43, counting.carry, active);
  return ~counting.edge | counting.counted;
}
template <class Modulus, class M>
inline Plane CountCarryUntilNext(State& m, unsigned first, const Plane& input, const Modulus& modulus,
                                 const M& active) {
  const Counting counting = CountEdges(m, first, input, modulus, m.planes[first + 43], Zeros(), active);
  PutPlane(m, first + 43, counting.carry, active);
  return ~counting.edge | counting.counted;
}
template <class M>
inline void ResetCounter(State& m, unsigned first, const Plane& z, const M& active) {
  const auto cleared = Within(active, z & ~m.planes[first + 42]);
  PutField<8>(m, first + 32, Fixed<uint8_t, 0>{}, cleared);
  PutPlane(m, first + 40, Zeros(), cleared);
  PutPlane(m, first + 41, Zeros(), cleared);
  PutPlane(m, first + 43, Zeros(), cleared);
  PutPlane(m, first + 42, z, active);
}
/// A carry that the other part set stays; so does one with the stamp of now.
template <class Number, class M>
[[gnu::noinline]] void ExpireCarry(State& m, unsigned first, const Number& number, unsigned other_part,
                                   const M& active) {
  Plane other = Ones();
  PLCXX_UNROLL
  for (unsigned i = 0; i < 8; ++i)
    other &= (other_part >> i & 1) != 0 ? m.planes[first + 44 + i] : ~m.planes[first + 44 + i];
  const Plane ends = m.planes[first + 43] & ~other;
  if (!Any(ends)) return;
  PutPlane(m, first + 43, Zeros(), Within(active, ends & NotEqual<32>(FieldAt<32>(m, first), number)));
}
template <class Number, class M>
inline void ExpireCounter(State& m, unsigned first, const Number& number, unsigned other_part, const M& active) {
  if (__builtin_expect(Any(m.planes[first + 43]), 0)) ExpireCarry(m, first, number, other_part, active);
}
template <class Number, class M>
inline void ExpireCounterSlow(State& m, unsigned first, const Number& number, const M& active) {
  ExpireCounter(m, first, number, 2, active);
}
template <class Number, class M>
inline void ExpireCounterFast(State& m, unsigned first, const Number& number, const M& active) {
  ExpireCounter(m, first, number, 1, active);
}

// --- one-shots: stamp 32, target 32, pulse, previous, fast ----------------------------------------------------------

template <class Cycle, class M>
inline void PulseSlow(State& m, unsigned first, const Plane& input, const Cycle& cycle, const M& active) {
  const Plane pulse = input & ~m.planes[first + 65];
  PutPlane(m, first + 64, pulse, active);
  PutPlane(m, first + 65, input, active);
  const auto started = Within(active, pulse);
  if (!Any(started)) return;
  PutField<32>(m, first, cycle, started);
  PutPlane(m, first + 66, Zeros(), started);
}
template <class Cycle, class M>
inline void ExpirePulseSlow(State& m, unsigned first, const Cycle& cycle, const M& active) {
  const Plane ends = m.planes[first + 64] & ~m.planes[first + 66];
  if (!Any(ends)) return;
  PutPlane(m, first + 64, Zeros(), Within(active, ends & NotEqual<32>(FieldAt<32>(m, first), cycle)));
}
template <class Cycle, class M>
inline void ExpirePulseFast(State& m, unsigned first, const Cycle& slow_done, const M& active) {
  const Plane fast = m.planes[first + 64] & m.planes[first + 66];
  if (!Any(fast)) return;
  const Plane reached = ~SignBit<32>(Sub<32>(slow_done, FieldAt<32>(m, first + 32)));
  PutPlane(m, first + 64, Zeros(), Within(active, fast & reached));
}

}  // namespace plcxx_fleet
