// On-delay timers that all lanes step together: most steps start nothing, end nothing and hold nothing, and change no
// time but the one that all lanes share.
//
// In: a timer whose preset is a constant and whose time is the same in every machine. While its clock runs, the planes
// of elapsed_ms are the time at which a lane's input became 1, moved by what it was held; what has elapsed is last -
// start, and 0 where the input is 0. Otherwise the planes are what they are called.
#pragma once

#include "transpiler/fleet/runtime/steps.h"

namespace plcxx_fleet {

/// Longer times do not run by a clock, so that differences of times say which is later.
constexpr uint32_t kLongestTime = 1U << 30;

/// to = number - planes, in `bits` bits; `to` may be the planes themselves.
inline void SubtractFrom(uint32_t number, const Plane* planes, unsigned bits, Plane* to) {
  Plane borrow{};
  for (unsigned i = 0; i < bits; ++i) {
    const Plane p = AllEqual((number >> i & 1) != 0), q = planes[i];
    to[i] = p ^ q ^ borrow;
    borrow = (~p & q) | (borrow & (~p | q));
  }
}

/// The planes are what they are called.
[[gnu::noinline]] inline void StopClock(State& m, unsigned first, Clock& clock) {
  if (clock.runs == 0) return;
  clock.runs = 0;
  const Plane input = m.planes[first + 64];
  SubtractFrom(clock.last, &m.planes[first], 32, &m.planes[first]);
  for (unsigned i = 0; i < 32; ++i) {
    m.planes[first + i] &= input;
    m.planes[first + 32 + i] = AllEqual((clock.last >> i & 1) != 0);
  }
}

/// How long the lanes have run: planes of now - start, and how many of them are not 0 for certain.
struct Ages {
  Plane p[32];
  unsigned bits = 0;
};
inline void FindAges(const State& m, unsigned first, uint32_t now, unsigned bits, Ages& ages) {
  ages.bits = bits;
  SubtractFrom(now, &m.planes[first], bits, ages.p);
}
/// The greatest age of lanes; 0 when there are none.
inline uint32_t Oldest(const Ages& ages, Plane lanes) {
  uint32_t age = 0;
  for (unsigned i = ages.bits; i-- > 0;) {
    const Plane older = lanes & ages.p[i];
    if (!Any(older)) continue;
    lanes = older;
    age |= 1U << i;
  }
  return age;
}
inline unsigned BitsOf(uint32_t number) { return number == 0 ? 0 : 32 - static_cast<unsigned>(__builtin_clz(number)); }

/// After a step of all lanes: the clock runs unless a time is too long.
inline void StartClock(State& m, unsigned first, Clock& clock, uint32_t now) {
  const Plane input = m.planes[first + 64];
  if (Any(input & (m.planes[first + 30] | m.planes[first + 31]))) return;
  Ages ages;
  ages.bits = 30;
  for (unsigned i = 0; i < 30; ++i) ages.p[i] = m.planes[first + i];
  SubtractFrom(now, &m.planes[first], 32, &m.planes[first]);
  clock = {now, now - Oldest(ages, input), now - Oldest(ages, input & ~m.planes[first + 66]), 1, 0, 0, 0, 0};
}

/// Any step of all lanes.
[[gnu::noinline]] inline void StepByClock(State& m, unsigned first, Clock& clock, const Plane& input, uint32_t preset,
                                          uint32_t now) {
  const uint32_t passed = now - clock.last;
  if (passed > kLongestTime || now - clock.oldest > kLongestTime) StopClock(m, first, clock);
  if (clock.runs == 0) {
    OnDelay(m, first, input, Uniform<uint32_t>{preset}, Uniform<uint32_t>{now}, All{});
    return StartClock(m, first, clock, now);
  }
  const Plane was = m.planes[first + 64], done = m.planes[first + 66];
  const Plane starts = input & ~was, held = input & was & m.planes[first + 65];
  if (Any(held)) {
    Plane carry{};
    for (unsigned i = 0; i < 32; ++i) {
      const Plane p = m.planes[first + i], q = AllEqual((passed >> i & 1) != 0) & held;
      m.planes[first + i] = p ^ q ^ carry;
      carry = (p & q) | (carry & (p | q));
    }
  }
  if (Any(starts)) {
    for (unsigned i = 0; i < 32; ++i)
      m.planes[first + i] = Choose(starts, AllEqual((now >> i & 1) != 0), m.planes[first + i]);
  }
  Plane reached{};
  if (now - clock.waiting >= preset) {  // who has waited longest has waited long enough
    Ages ages;
    FindAges(m, first, now, BitsOf(now - clock.oldest), ages);
    Plane less{};
    for (unsigned i = 0; i < ages.bits; ++i) less = (preset >> i & 1) != 0 ? ~ages.p[i] | less : ~ages.p[i] & less;
    reached = ages.bits < 32 && preset >> ages.bits != 0 ? Zeros() : ~less;
    clock.waiting = now - Oldest(ages, input & ~done & ~reached);
    clock.oldest = now - Oldest(ages, input);
  }
  m.planes[first + 67] = input & Choose(done, m.planes[first + 67], ~reached);
  m.planes[first + 66] = input & (done | reached);
  m.planes[first + 64] = input;
  clock.last = now;
}

template <uint64_t kPreset>
inline void OnDelayByClock(State& m, unsigned first, unsigned at, const Plane& input,
                           const Fixed<uint32_t, kPreset>& preset, const Uniform<uint32_t>& now, All) {
#if PLCXX_FLEET_FORCES
  OnDelay(m, first, input, preset, now, All{});
#else
  Clock& clock = m.clocks[at];
  const Plane was = m.planes[first + 64], hold = m.planes[first + 65], done = m.planes[first + 66];
  const bool nothing_ends = now.value - clock.waiting < kPreset && now.value - clock.last <= kLongestTime;
  if (__builtin_expect(clock.runs == 0 || !nothing_ends || Any(input & (hold | ~was)), 0))
    return StepByClock(m, first, clock, input, kPreset, now.value);
  m.planes[first + 64] = input;
  m.planes[first + 66] = input & done;
  m.planes[first + 67] = input & (m.planes[first + 67] | ~done);
  clock.last = now.value;
#endif
}
/// Of the lanes of a mask.
[[gnu::noinline]] inline void OnDelayOfSome(State& m, unsigned first, const Plane& input, uint32_t preset, uint32_t now,
                                            const Plane& active) {
  OnDelay(m, first, input, Uniform<uint32_t>{preset}, Uniform<uint32_t>{now}, active);
}
template <uint64_t kPreset>
inline void OnDelayByClock(State& m, unsigned first, unsigned at, const Plane& input,
                           const Fixed<uint32_t, kPreset>& preset, const Uniform<uint32_t>& now, const Plane& active) {
  if (IsFull(active)) return OnDelayByClock(m, first, at, input, preset, now, All{});
  StopClock(m, first, m.clocks[at]);
  OnDelayOfSome(m, first, input, kPreset, now.value, active);
}

}  // namespace plcxx_fleet
