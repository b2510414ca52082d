// Timers that count their section's period (TON, TOF, TP), stepped by all lanes together: most steps start nothing and
// end nothing, and change nothing but the time that all lanes share.
//
// In: a timer that statements of one kind step, whose value the program does not ask for. While its clock runs, the
// planes of elapsed_ms are, in the lanes that count, the moment of that clock at which they were 0, and the planes of
// value mean nothing: who asks for either computes it (Fleet::Field). Otherwise the planes are what they are called.
// Fields: elapsed_ms 64, value 32, preset 32, previous, running, output.
#pragma once

#include "plcxx/unit_timers.h"
#include "transpiler/fleet/runtime/clocks.h"

namespace plcxx_fleet {

enum class Delay { kOn, kOff, kAfterFall, kPulse };  // TON, TOF, TP, TP=IEC

namespace unit_timer {
constexpr unsigned kValue = 64, kPreset = 96, kPrevious = 128, kRunning = 129, kOutput = 130;
constexpr unsigned kTimeBits = 30;
constexpr uint32_t kLongest = 1U << kTimeBits;
constexpr uint32_t kLongestPeriod = 1U << 20;
}  // namespace unit_timer

template <Delay kDelay, unsigned kUnit>
struct OneUnitTimer {
  bool operator()(plcxx::UnitTimer& timer, bool input, uint32_t preset, uint32_t period) const {
    if constexpr (kDelay == Delay::kOn) return plcxx::StepTon(timer, input, preset, period, kUnit);
    if constexpr (kDelay == Delay::kOff) return plcxx::StepTof(timer, input, preset, period, kUnit);
    if constexpr (kDelay == Delay::kAfterFall) return plcxx::StepTp(timer, input, preset, period, kUnit);
    if constexpr (kDelay == Delay::kPulse) return plcxx::StepPulse(timer, input, preset, period, kUnit);
  }
};
template <Delay kDelay, unsigned kUnit, class Instance = plcxx::UnitTimer, class Preset, class M>
[[gnu::noinline]] Plane StepUnitTimers(State& m, unsigned first, const Plane& input, const Preset& preset,
                                       uint32_t period, const M& active) {
  return StepPerLane<Instance, bool>(m, first, active, OneUnitTimer<kDelay, kUnit>{}, In<bool>(input),
                                     In<uint32_t>(preset), Uniform<uint32_t>{period});
}

/// Whose elapsed_ms grows.
template <Delay kDelay>
inline Plane Counting(const State& m, unsigned first) {
  using namespace unit_timer;
  if constexpr (kDelay == Delay::kOn) return m.planes[first + kPrevious] & ~m.planes[first + kOutput];
  return m.planes[first + kRunning];
}

/// The planes are what they are called.
template <Delay kDelay, unsigned kUnit>
[[gnu::noinline]] void StopUnitClock(State& m, unsigned first, Clock& clock) {
  using namespace unit_timer;
  if (clock.runs == 0) return;
  clock.runs = 0;
  const Plane counting = Counting<kDelay>(m, first);
  Bits<32> since;
  SubtractFrom(clock.last, &m.planes[first], 32, since.p);
  PutField<32>(m, first, since, counting);
  const Lanes<uint32_t> elapsed = FieldRows<uint32_t>(m, first), preset = FieldRows<uint32_t>(m, first + kPreset);
  Lanes<uint32_t> value;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    const uint32_t longest = preset.v[lane] * kUnit;
    value.v[lane] = (elapsed.v[lane] < longest ? elapsed.v[lane] : longest) / kUnit;
  }
  PutField<32>(m, first + kValue, value, All{});
}

// --- presets, in ms below kLongest ----------------------------------------------------------------------------------

template <unsigned kUnit>
inline bool IsShortPreset(const Uniform<uint32_t>& preset) {
  return preset.value < unit_timer::kLongest / kUnit;
}
template <unsigned kUnit>
inline bool IsShortPreset(const Bits<32>& preset) {
  Plane any{};
  for (unsigned i = BitsOf(unit_timer::kLongest / kUnit) - 1; i < 32; ++i) any |= preset.p[i];
  return !Any(any);
}
template <unsigned kUnit>
inline Uniform<uint32_t> ToMs(const Uniform<uint32_t>& preset) {
  return {preset.value * kUnit};
}
template <unsigned kUnit>
inline Bits<32> ToMs(const Bits<32>& preset) {
  return Times<32>(preset, Fixed<uint32_t, kUnit>{});
}
/// Where it is not that of the step before.
inline Plane Differs(const State&, unsigned, const Clock& clock, const Uniform<uint32_t>& preset) {
  return AllEqual(preset.value != clock.preset);
}
inline Plane Differs(const State& m, unsigned first, const Clock&, const Bits<32>& preset) {
  return NotEqual<32>(FieldAt<32>(m, first + unit_timer::kPreset), preset);
}
/// One that all lanes have; else one that no clock runs with.
inline uint32_t CommonPreset(const Uniform<uint32_t>& preset) { return preset.value; }
inline uint32_t CommonPreset(const Bits<32>&) { return 0xFFFFFFFF; }

/// The least of the numbers of some lanes; kLongest when there are none.
inline uint32_t Least(const Bits<unit_timer::kTimeBits>& numbers, Plane lanes) {
  if (!Any(lanes)) return unit_timer::kLongest;
  uint32_t least = 0;
  for (unsigned i = unit_timer::kTimeBits; i-- > 0;) {
    const Plane less = lanes & ~numbers.p[i];
    if (Any(less)) {
      lanes = less;
    } else {
      least |= 1U << i;
    }
  }
  return least;
}

/// After a step of all lanes: the clock runs unless a time is too long.
template <Delay kDelay, unsigned kUnit, class Preset>
inline void StartUnitClock(State& m, unsigned first, Clock& clock, const Preset& preset) {
  using namespace unit_timer;
  Plane too_long{};
  for (unsigned i = kTimeBits; i < 64; ++i) too_long |= m.planes[first + i];
  if (Any(too_long) || !IsShortPreset<kUnit>(preset)) return;
  const Plane counting = Counting<kDelay>(m, first);
  const Bits<kTimeBits> rest = Sub<kTimeBits>(ToMs<kUnit>(preset), FieldAt<kTimeBits>(m, first));
  Bits<32> start;
  SubtractFrom(0, &m.planes[first], 32, start.p);
  PutField<32>(m, first, start, counting);
  clock.last = 0;
  clock.next = Least(rest, counting);
  clock.preset = CommonPreset(preset);
  clock.unit_ms = kUnit;
  clock.counts_by_input = kDelay == Delay::kOn;
  clock.runs = 1;
}

/// Any step of all lanes.
template <Delay kDelay, unsigned kUnit, class Preset>
[[gnu::noinline]] Plane StepByUnitClock(State& m, unsigned first, Clock& clock, const Plane& input,
                                        const Preset& preset, uint32_t period) {
  using namespace unit_timer;
  if (clock.runs == 0 || !IsShortPreset<kUnit>(preset)) {
    StopUnitClock<kDelay, kUnit>(m, first, clock);
    const Plane output = StepUnitTimers<kDelay, kUnit>(m, first, input, preset, period, All{});
    StartUnitClock<kDelay, kUnit>(m, first, clock, preset);
    return output;
  }
  const uint32_t now = clock.last + period;
  const Plane was = m.planes[first + kPrevious];
  Plane running = m.planes[first + kRunning], output = m.planes[first + kOutput];
  const Plane rises = input & ~was, falls = ~input & was;
  Plane starts{}, zeros{};
  if constexpr (kDelay == Delay::kOn) {
    starts = rises;
    zeros = falls;
    output &= input;
  } else if constexpr (kDelay == Delay::kOff) {
    starts = falls;
    zeros = rises;
    output |= input;
    running = ~input & (running | falls);
  } else if constexpr (kDelay == Delay::kAfterFall) {
    starts = falls & output;
    zeros = rises;
    output |= rises;
    running = (running & ~rises) | starts;
  } else {
    starts = rises & ~running;
    output |= starts;
    running |= starts;
  }
  const auto ms = ToMs<kUnit>(preset);
  Bits<32> times = FieldAt<32>(m, first);
  times = Select<32>(starts, Uniform<uint32_t>{now}, times);
  times = Select<32>(zeros, Uniform<uint32_t>{0}, times);
  const Plane counting = kDelay == Delay::kOn ? input & ~output : running;
  const Bits<kTimeBits> age = Sub<kTimeBits>(Uniform<uint32_t>{now}, times);
  const Plane ends = counting & GreaterEqual<kTimeBits>(age, ms);
  times = Select<32>(ends, ms, times);
  if constexpr (kDelay == Delay::kOn) {
    output |= ends;
  } else {
    output &= ~ends;
    running &= ~ends;
  }
  // A pulse that has ended keeps its time as long as the input stands.
  if constexpr (kDelay == Delay::kPulse)
    times = Select<32>(~input & ~running & (was | ends), Uniform<uint32_t>{0}, times);
  PutField<32>(m, first, times, All{});
  PutField<32>(m, first + kPreset, preset, All{});
  m.planes[first + kPrevious] = input;
  m.planes[first + kRunning] = running;
  m.planes[first + kOutput] = output;
  clock.last = now;
  clock.preset = CommonPreset(preset);
  clock.next = now + Least(Sub<kTimeBits>(ms, age), counting & ~ends);
  return output;
}

template <Delay kDelay, unsigned kUnit, class Preset, class Period>
inline Plane UnitByClock(State& m, unsigned first, unsigned at, const Plane& input, const Preset& preset_value,
                         const Period& period, All) {
  using namespace unit_timer;
  const auto& preset = AsUniform(Sliced(preset_value));
  Clock& clock = m.clocks[at];
  if (PLCXX_FLEET_FORCES || period[0] > kLongestPeriod) {
    StopUnitClock<kDelay, kUnit>(m, first, clock);
    return StepUnitTimers<kDelay, kUnit>(m, first, input, preset, period[0], All{});
  }
  const uint32_t now = clock.last + period[0];
  const Plane changes = (input ^ m.planes[first + kPrevious]) | Differs(m, first, clock, preset);
  if (__builtin_expect(clock.runs == 0 || static_cast<int32_t>(now - clock.next) >= 0 || Any(changes), 0))
    return StepByUnitClock<kDelay, kUnit>(m, first, clock, input, preset, period[0]);
  clock.last = now;
  return m.planes[first + kOutput];
}
template <Delay kDelay, unsigned kUnit, class Preset, class Period>
inline Plane UnitByClock(State& m, unsigned first, unsigned at, const Plane& input, const Preset& preset,
                         const Period& period, const Plane& active) {
  if (IsFull(active)) return UnitByClock<kDelay, kUnit>(m, first, at, input, preset, period, All{});
  StopUnitClock<kDelay, kUnit>(m, first, m.clocks[at]);
  return StepUnitTimers<kDelay, kUnit>(m, first, input, AsUniform(Sliced(preset)), period[0], active);
}

}  // namespace plcxx_fleet
