// The one-shot: a pulse of one slow cycle on the rising edge of its input.
//
// Implements NC110 7.3 to the letter. All zero is the state after power-on, so an input that is 1 from the start gives
// a pulse. `fast` says which part started the pulse, and with it which part's expiry ends it.
// One one-shot driven in both parts (W350): pulse and previous input are shared, each statement follows the rule of its
// own part, and each part keeps its own count: a fast statement leaves a running pulse alone while its target is ahead,
// whoever started the pulse.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

namespace plcxx {

struct OneShot {
  uint32_t stamp;   // slow part: the slow cycle of the start
  uint32_t target;  // fast part: the slow_done at which the pulse ends
  bool pulse;       // Pnn
  bool previous;    // the input at the last execution
  bool fast;        // the part that started the pulse
};

/// True when `slow_done` has reached the target, by difference, so that both may wrap.
constexpr bool ReachedSlowCycle(uint32_t slow_done, uint32_t target) noexcept {
  return slow_done - target < 0x80000000U;
}

/// The statement in the slow part: the pulse lasts until the same statement in the next slow cycle.
constexpr void PulseSlow(OneShot& shot, bool input, uint32_t slow_cycle) noexcept {
  shot.pulse = input && !shot.previous;
  shot.previous = input;
  if (shot.pulse) {
    shot.stamp = slow_cycle;
    shot.fast = false;
  }
}

/// The statement in the fast part: the pulse lasts until a complete slow cycle has been executed after its start, so
/// that the slow part sees it everywhere. `slice` is the slice that the slow part executes next; not 0: a slow cycle is
/// half done and does not count as a complete one.
[[gnu::noinline]] static constexpr void PulseFast(OneShot& shot, bool input, uint32_t slow_done,
                                                  uint8_t slice) noexcept {
  const bool reached = ReachedSlowCycle(slow_done, shot.target);
  if (reached) shot.target = slow_done;  // kept near, so that a wrap of the count never makes an old one look new
  if (reached || !shot.pulse) {
    shot.pulse = input && !shot.previous;
    if (shot.pulse) {
      shot.target = slow_done + (slice != 0 ? 2U : 1U);
      shot.fast = true;
    }
  }
  shot.previous = input;
}

/// End of a slow cycle: a pulse started in the slow part ends when its statement was not executed in this cycle.
constexpr void ExpireSlow(OneShot& shot, uint32_t slow_cycle) noexcept {
  if (!shot.fast && shot.stamp != slow_cycle) shot.pulse = false;
}

/// End of an execution of the fast part: a pulse started there ends when its slow cycles are done.
constexpr void ExpireFast(OneShot& shot, uint32_t slow_done) noexcept {
  if (shot.fast && ReachedSlowCycle(slow_done, shot.target)) shot.pulse = false;
}

}  // namespace plcxx
