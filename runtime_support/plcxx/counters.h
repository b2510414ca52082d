// The ring counter: rising edges counted up or down, modulo 2..255, with a carry when it wraps.
//
// Implements NC110 7.2 to the letter, one Count function per choice of --carry (D9). All zero is the state after
// power-on. CnnA = v and CnnW = v are plain assignments to `down` and `count`.
// Not its job: to report a modulus out of range; the result says it, the caller tells the host.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

namespace plcxx {

/// RingCounter::part: where the carry was set last. A carry that the host wrote before any statement did belongs to no
/// part, so the part that drives the counter ends it (7.2: every counter of that part with an older stamp).
inline constexpr uint8_t kCarryOfSlowPart = 1;
inline constexpr uint8_t kCarryOfFastPart = 2;

struct RingCounter {
  uint32_t stamp;  // the slow cycle or fast execution in which the carry was set
  uint8_t count;   // CnnW
  bool input;      // CnnI
  bool down;       // CnnA: direction
  bool reset;      // CnnZ
  bool carry;      // CnnR
  uint8_t part;    // 0 or the part in which the carry was set: kCarryOf...
};

/// Takes the input; true when it is an edge to count. A part of the Count functions.
constexpr bool TakeCountInput(RingCounter& counter, bool input) noexcept {
  if (counter.reset) {
    counter.input = false;  // so that an input that is still 1 after the reset counts once
    return false;
  }
  const bool rising = input && !counter.input;
  counter.input = input;
  return rising;
}

/// Counts one edge, false when the modulus is outside 2..255. A part of the Count functions.
/// A count at or above the modulus wraps when it is counted up; counted down, it falls by 1.
constexpr bool CountEdge(RingCounter& counter, uint16_t modulus) noexcept {
  if (modulus < 2 || modulus > 255) return false;
  if (counter.down) {
    counter.carry |= counter.count == 0;
    counter.count = static_cast<uint8_t>((counter.count == 0 ? modulus : counter.count) - 1);
  } else {
    const bool wraps = counter.count + 1 >= modulus;
    counter.carry |= wraps;
    counter.count = static_cast<uint8_t>(wraps ? 0 : counter.count + 1);
  }
  return true;
}

/// The input statement in the slow part, carry=scan: the carry lasts until the statement's next execution.
/// False: an edge came with a modulus outside 2..255 and was not counted.
[[gnu::noinline]] static constexpr bool CountSlow(RingCounter& counter, bool input, uint16_t modulus,
                                                  uint32_t slow_cycle) noexcept {
  counter.carry = false;
  if (!TakeCountInput(counter, input)) return true;
  const bool counted = CountEdge(counter, modulus);
  if (counter.carry) {
    counter.stamp = slow_cycle;
    counter.part = kCarryOfSlowPart;
  }
  return counted;
}

/// The input statement in the fast part, carry=scan; `fast_count` numbers the executions of the fast part.
[[gnu::noinline]] static constexpr bool CountFast(RingCounter& counter, bool input, uint16_t modulus,
                                                  uint32_t fast_count) noexcept {
  counter.carry = false;
  if (!TakeCountInput(counter, input)) return true;
  const bool counted = CountEdge(counter, modulus);
  if (counter.carry) {
    counter.stamp = fast_count;
    counter.part = kCarryOfFastPart;
  }
  return counted;
}

/// The input statement in either part, carry=input: the carry stays while the input stays 1.
[[gnu::noinline]] static constexpr bool CountCarryWhileInput(RingCounter& counter, bool input,
                                                             uint16_t modulus) noexcept {
  if (!input) counter.carry = false;
  return !TakeCountInput(counter, input) || CountEdge(counter, modulus);
}

/// The input statement in either part, carry=next: the carry stays until the next edge, also one that is not counted.
[[gnu::noinline]] static constexpr bool CountCarryUntilNext(RingCounter& counter, bool input,
                                                            uint16_t modulus) noexcept {
  if (!TakeCountInput(counter, input)) return true;
  counter.carry = false;
  return CountEdge(counter, modulus);
}

/// CnnZ = z. Clears on the rising edge only: a count assigned while z stays 1 is kept (D10).
constexpr void ResetCounter(RingCounter& counter, bool z) noexcept {
  if (z && !counter.reset) {
    counter.count = 0;
    counter.carry = false;
    counter.input = false;
    counter.down = false;
  }
  counter.reset = z;
}

/// End of a slow cycle, carry=scan: a carry not set in the fast part ends when its statement was not executed in this
/// cycle. Any other stamp is an older one, so the numbers may wrap.
constexpr void ExpireSlow(RingCounter& counter, uint32_t slow_cycle) noexcept {
  if (counter.part != kCarryOfFastPart && counter.stamp != slow_cycle) counter.carry = false;
}

/// End of an execution of the fast part, carry=scan: the same for a carry not set in the slow part.
constexpr void ExpireFast(RingCounter& counter, uint32_t fast_count) noexcept {
  if (counter.part != kCarryOfSlowPart && counter.stamp != fast_count) counter.carry = false;
}

}  // namespace plcxx
