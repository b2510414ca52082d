// Operations of state instances: those that have a form in planes, and all others lane by lane.
//
// In: the first plane of an instance; its fields follow in the order of transpiler/ir/states.def, a plane for each bit.
// What each has to do is the function of runtime_support of the same name.
#pragma once

#include "plcxx/decade_counters.h"
#include "plcxx/texts.h"
#include "plcxx/time_word_timers.h"
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

// --- texts: a flag is left 8, flag; an inbox is text 32 * 8, length 8, pending --------------------------------------

/// Whether the text of an inbox is the literal. Rare: only while a text is pending.
[[gnu::noinline]] inline Plane EqualsText(const State& m, unsigned inbox, const char* literal) {
  uint8_t length = 0;
  while (literal[length] != '\0') {
    if (++length > plcxx::kLongestText) return Zeros();
  }
  Plane equal = ~NotEqual<8>(FieldAt<8>(m, inbox + 256), Uniform<uint8_t>{length});
  for (unsigned i = 0; i < length && Any(equal); ++i)
    equal &= ~NotEqual<8>(FieldAt<8>(m, inbox + 8 * i), Uniform<uint8_t>{static_cast<uint8_t>(literal[i])});
  return equal;
}
template <class M>
inline void UpdateText(State& m, unsigned flag, unsigned inbox, const char* literal, const M& active) {
  const Plane pending = m.planes[inbox + 264];
  Bits<8> left = FieldAt<8>(m, flag);
  const Plane some = ~IsZero<8>(left);
  if (__builtin_expect(Any(pending | some), 0)) {
    left = Select<8>(some, Sub<8>(left, Fixed<uint8_t, 1>{}), left);
    if (Any(pending)) {
      const Plane equal = EqualsText(m, inbox, literal);
      PLCXX_UNROLL
      for (unsigned i = 0; i < 8; ++i) left.p[i] = Choose(pending, i == 1 ? equal : Zeros(), left.p[i]);
    }
    PutField<8>(m, flag, left, active);
  }
  PutPlane(m, flag + 8, ~IsZero<8>(left), active);
}

template <class M>
inline void ClearText(State& m, unsigned inbox, const M& active) {
  PutField<8>(m, inbox + 256, Fixed<uint8_t, 0>{}, active);
  PutPlane(m, inbox + 264, Zeros(), active);
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

/// A target that was reached is kept near, so that a wrap of the count never makes an old one look new.
template <class Done, class Slice, class M>
inline void PulseFast(State& m, unsigned first, const Plane& input, const Done& slow_done, const Slice& slice,
                      const M& active) {
  const Plane pulse = m.planes[first + 64], rises = input & ~m.planes[first + 65];
  const Plane reached = ~SignBit<32>(Sub<32>(slow_done, FieldAt<32>(m, first + 32)));
  const Plane begins = rises & (reached | ~pulse);
  PutField<32>(m, first + 32, slow_done, Within(active, reached));
  const auto started = Within(active, begins);
  if (Any(started)) {
    Plane carry = NotEqual<8>(slice, Fixed<uint8_t, 0>{});
    PutField<32>(m, first + 32, AddWithCarry<32>(slow_done, Fixed<uint32_t, 1>{}, carry), started);
    PutPlane(m, first + 66, Ones(), started);
  }
  PutPlane(m, first + 64, Choose(reached | ~pulse, rises, pulse), active);
  PutPlane(m, first + 65, input, active);
}

// --- timers with a time word: left_ms 32, scale 8, delays, running, edge, output ------------------------------------
//
// What does not run has no time left, and a time is below 2^21 ms: plcxx/time_word_timers.h.

/// The time of a word, in the lanes of `starts`; gives where it is not 0.
template <class T, uint64_t kWord>
inline Plane LoadTime(State& m, unsigned first, const Fixed<T, kWord>&, const Plane& starts) {
  plcxx::TimeWordTimer timer{};
  const bool some = plcxx::LoadTime(timer, static_cast<uint16_t>(kWord));
  PutField<32>(m, first, Uniform<uint32_t>{timer.left_ms}, starts);
  PutField<8>(m, first + 32, Uniform<uint8_t>{timer.scale}, starts);
  return AllEqual(some);
}
template <class Word>
[[gnu::noinline]] Plane LoadTime(State& m, unsigned first, const Word& word, const Plane& starts) {
  const auto& words = In<uint16_t>(word);
  Lanes<uint32_t> left;
  Lanes<uint8_t> scale;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    plcxx::TimeWordTimer timer{};
    plcxx::LoadTime(timer, words[lane]);
    left.v[lane] = timer.left_ms;
    scale.v[lane] = timer.scale;
  }
  PutField<32>(m, first, left, starts);
  PutField<8>(m, first + 32, scale, starts);
  return ~IsZero<32>(left);
}

/// What a start reads, and what it leaves; results are what it leaves before forces.
struct TimeWordStep {
  Plane running, edge, output;
};
inline TimeWordStep BeginStep(const State& m, unsigned first) {
  return {m.planes[first + 41], m.planes[first + 42], m.planes[first + 43]};
}
/// Of the lanes of `stops`, those that run have no time left.
template <class M>
inline void StopTime(State& m, unsigned first, const Plane& stops, const M& active) {
  const auto ending = Within(active, stops & m.planes[first + 41]);
  if (Any(ending)) PutField<32>(m, first, Fixed<uint32_t, 0>{}, ending);
}
template <class M>
inline Plane EndStep(State& m, unsigned first, const TimeWordStep& step, const Plane& condition, bool delays,
                     const M& active) {
  PutPlane(m, first + 40, AllEqual(delays), active);
  PutPlane(m, first + 41, step.running, active);
  PutPlane(m, first + 42, condition, active);
  PutPlane(m, first + 43, step.output, active);
  return step.output;
}
/// Starts in some lanes: the output is 1 while it runs, or, where it delays, when it does not.
template <class Word, class M>
inline void Start(State& m, unsigned first, TimeWordStep& step, const Plane& starts, const Word& word, bool delays,
                  const M& active) {
  const Plane started = ToPlane(Within(active, starts));
  if (!Any(started)) return;
  const Plane some = LoadTime(m, first, word, started);
  step.running = Choose(starts, some, step.running);
  step.output = Choose(starts, delays ? ~some : some, step.output);
}
/// Where the condition is 0, everything ends.
template <class Word, class M>
inline Plane StartWhile(State& m, unsigned first, const Plane& condition, const Word& word, bool delays,
                        const M& active) {
  TimeWordStep step = BeginStep(m, first);
  StopTime(m, first, ~condition, active);
  step.running &= condition;
  step.output &= condition;
  Start(m, first, step, condition & ~step.edge, word, delays, active);
  return EndStep(m, first, step, condition, delays, active);
}
template <class Word, class M>
inline Plane StartPulse(State& m, unsigned first, const Plane& condition, const Word& word, const M& active) {
  return StartWhile(m, first, condition, word, false, active);
}
template <class Word, class M>
inline Plane StartExtended(State& m, unsigned first, const Plane& condition, const Word& word, const M& active) {
  TimeWordStep step = BeginStep(m, first);
  Start(m, first, step, condition & ~step.edge, word, false, active);
  return EndStep(m, first, step, condition, false, active);
}
template <class Word, class M>
inline Plane StartOnDelay(State& m, unsigned first, const Plane& condition, const Word& word, const M& active) {
  return StartWhile(m, first, condition, word, true, active);
}
template <class Word, class M>
inline Plane StartLatchedDelay(State& m, unsigned first, const Plane& condition, const Word& word, const M& active) {
  TimeWordStep step = BeginStep(m, first);
  Start(m, first, step, condition & ~step.edge & ~step.output, word, true, active);
  return EndStep(m, first, step, condition, true, active);
}
template <class Word, class M>
inline Plane StartOffDelay(State& m, unsigned first, const Plane& condition, const Word& word, const M& active) {
  TimeWordStep step = BeginStep(m, first);
  const Plane rises = condition & ~step.edge, ends = ~condition & step.edge & step.output;
  StopTime(m, first, rises, active);
  step.running &= ~rises;
  step.output |= rises;
  Start(m, first, step, ends, word, false, active);
  return EndStep(m, first, step, condition, false, active);
}
template <class M>
inline void ResetTimer(State& m, unsigned first, const Plane& condition, const M& active) {
  StopTime(m, first, condition, active);
  PutPlane(m, first + 41, Zeros(), Within(active, condition));
  PutPlane(m, first + 43, Zeros(), Within(active, condition));
}
template <class Time, class M>
inline void PassTime(State& m, unsigned first, const Time& ms, const M& active) {
  constexpr unsigned kBits = 21;
  const Plane running = m.planes[first + 41];
  const auto runs = Within(active, running);
  if (!Any(runs)) return;
  const auto& passed = Sliced(ms);
  Plane borrow{}, far{};
  const Bits<kBits> rest = SubWithBorrow<kBits>(FieldAt<kBits>(m, first), passed, borrow);
  for (unsigned i = kBits; i < 32; ++i) far |= passed.Bit(i);
  const Plane ends = borrow | far | IsZero<kBits>(rest);
  PutField<kBits>(m, first, Select<kBits>(ends, Fixed<uint32_t, 0>{}, rest), runs);
  const auto ended = Within(runs, ends);
  PutPlane(m, first + 41, Zeros(), ended);
  PutPlane(m, first + 43, m.planes[first + 40], ended);
}

// --- decade counters: value 16, up_edge, down_edge, set_edge ---------------------------------------------------------

template <class M>
inline Plane CountUp(State& m, unsigned first, const Plane& condition, const M& active) {
  Bits<16> value = FieldAt<16>(m, first);
  const Plane counts = condition & ~m.planes[first + 16] & Less<16>(value, Fixed<uint16_t, 999>{});
  const auto counting = Within(active, counts);
  if (Any(counting)) {
    value = Select<16>(counts, Add<16>(value, Fixed<uint16_t, 1>{}), value);
    PutField<16>(m, first, value, counting);
  }
  PutPlane(m, first + 16, condition, active);
  return ~IsZero<16>(value);
}
template <class M>
inline Plane CountDown(State& m, unsigned first, const Plane& condition, const M& active) {
  Bits<16> value = FieldAt<16>(m, first);
  const Plane counts = condition & ~m.planes[first + 17] & ~IsZero<16>(value);
  const auto counting = Within(active, counts);
  if (Any(counting)) {
    value = Select<16>(counts, Sub<16>(value, Fixed<uint16_t, 1>{}), value);
    PutField<16>(m, first, value, counting);
  }
  PutPlane(m, first + 17, condition, active);
  return ~IsZero<16>(value);
}
template <class Preset>
[[gnu::noinline]] void LoadCount(State& m, unsigned first, const Preset& preset, const Plane& lanes) {
  const auto& presets = In<uint16_t>(preset);
  Lanes<uint16_t> value;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    plcxx::DecadeCounter counter{};
    plcxx::SetCounter(counter, true, presets[lane]);
    value.v[lane] = counter.value;
  }
  PutField<16>(m, first, value, lanes);
}
template <class Preset, class M>
inline void SetCounter(State& m, unsigned first, const Plane& condition, const Preset& preset, const M& active) {
  const Plane sets = ToPlane(Within(active, condition));
  if (Any(sets)) LoadCount(m, first, AsUniform(preset), sets);
}
template <class Preset, class M>
inline void SetCounterOnEdge(State& m, unsigned first, const Plane& condition, const Preset& preset, const M& active) {
  SetCounter(m, first, condition & ~m.planes[first + 18], preset, active);
  PutPlane(m, first + 18, condition, active);
}
template <class M>
inline void ZeroCounter(State& m, unsigned first, const Plane& condition, const M& active) {
  PutField<16>(m, first, Fixed<uint16_t, 0>{}, Within(active, condition));
}

}  // namespace plcxx_fleet
