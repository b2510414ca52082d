// Counters 0..999 with separate memories of the counting edges, as in STEP 5.
//
// Implements PROSTEP 7.2 to the letter. All zero is the state after power-on.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

#include "plcxx/bcd.h"

namespace plcxx {

struct DecadeCounter {
  uint16_t value;  // 0..999
  bool up_edge;    // S at the last CU of this counter
  bool down_edge;  // S at the last CD
  bool set_edge;   // S at the last S C; only with --set counter-set=edge
};

/// CU: counts a rising condition, not beyond 999. Returns whether the count is not 0.
constexpr bool CountUp(DecadeCounter& counter, bool condition) noexcept {
  if (condition && !counter.up_edge && counter.value < 999) ++counter.value;
  counter.up_edge = condition;
  return counter.value != 0;
}

/// CD: counts a rising condition down, not below 0. Returns whether the count is not 0.
constexpr bool CountDown(DecadeCounter& counter, bool condition) noexcept {
  if (condition && !counter.down_edge && counter.value > 0) --counter.value;
  counter.down_edge = condition;
  return counter.value != 0;
}

/// S C: takes the preset (three BCD digits, the top nibble ignored; at most 999) while the condition is 1.
[[gnu::noinline]] static constexpr void SetCounter(DecadeCounter& counter, bool condition, uint16_t preset) noexcept {
  if (!condition) return;
  const uint16_t value = FromBcd16(preset & 0x0FFF);
  counter.value = value > 999 ? uint16_t{999} : value;
}

/// The same with --set counter-set=edge: only when the condition rises.
[[gnu::noinline]] static constexpr void SetCounterOnEdge(DecadeCounter& counter, bool condition,
                                                         uint16_t preset) noexcept {
  if (!counter.set_edge) SetCounter(counter, condition, preset);
  counter.set_edge = condition;
}

/// R C: 0 while the condition is 1; the edges keep their memories.
constexpr void ZeroCounter(DecadeCounter& counter, bool condition) noexcept {
  if (condition) counter.value = 0;
}

}  // namespace plcxx
