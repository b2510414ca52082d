// Timers of a coded time word: five ways of starting one, as in STEP 5.
//
// Implements PROSTEP 7.1 to the letter. Time passes by PassTime, which the schedule calls for every timer at the start
// of a tick; the start instructions stand in the program. All zero is the state after power-on.
// Not its job: when time passes.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

#include "plcxx/bcd.h"

namespace plcxx {

struct TimeWordTimer {
  uint32_t left_ms;  // 0..1,665,000
  uint8_t scale;     // of the last start: 0 = 1 ms, 1 = 10 ms, 2 = 100 ms, 3 = 1 s
  bool delays;       // last start instruction was SR or SS: the output comes when the time is over
  bool running;
  bool edge;    // S at the last start instruction; one memory for all start instructions of a timer
  bool output;  // what A T n reads
};

/// Milliseconds in one unit of a scale 0..3.
[[gnu::const]] constexpr uint32_t MsPerUnit(uint8_t scale) noexcept {
  switch (scale & 3) {
    case 0:
      return 1;
    case 1:
      return 10;
    case 2:
      return 100;
    default:
      return 1000;
  }
}

/// Takes a time word: three decades (nibbles above 9 count as they are) and the scale in bits 13..12.
/// Returns whether there is any time.
constexpr bool LoadTime(TimeWordTimer& timer, uint16_t word) noexcept {
  timer.scale = static_cast<uint8_t>((word >> 12) & 3);
  timer.left_ms = FromBcd16(word & 0x0FFF) * MsPerUnit(timer.scale);
  return timer.left_ms > 0;
}

constexpr void StopTimer(TimeWordTimer& timer) noexcept {
  timer.output = false;
  timer.running = false;
  timer.left_ms = 0;
}

/// SP: on with a rising condition, off when the time is over or the condition falls.
[[gnu::noinline]] static constexpr bool StartPulse(TimeWordTimer& timer, bool condition, uint16_t word) noexcept {
  const bool rises = condition && !timer.edge;
  timer.edge = condition;
  timer.delays = false;
  if (!condition) {
    StopTimer(timer);
  } else if (rises) {
    timer.running = timer.output = LoadTime(timer, word);
  }
  return timer.output;
}

/// SE: on with a rising condition for the whole time; a new edge starts it again.
[[gnu::noinline]] static constexpr bool StartExtended(TimeWordTimer& timer, bool condition, uint16_t word) noexcept {
  const bool rises = condition && !timer.edge;
  timer.edge = condition;
  timer.delays = false;
  if (rises) timer.running = timer.output = LoadTime(timer, word);
  return timer.output;
}

/// SR: on when the condition has been 1 for the time.
[[gnu::noinline]] static constexpr bool StartOnDelay(TimeWordTimer& timer, bool condition, uint16_t word) noexcept {
  const bool rises = condition && !timer.edge;
  timer.edge = condition;
  timer.delays = true;
  if (!condition) {
    StopTimer(timer);
  } else if (rises) {
    timer.running = LoadTime(timer, word);
    timer.output = !timer.running;
  }
  return timer.output;
}

/// SS: on when the time after an edge is over, whatever the condition does; off by ResetTimer only.
[[gnu::noinline]] static constexpr bool StartLatchedDelay(TimeWordTimer& timer, bool condition,
                                                          uint16_t word) noexcept {
  const bool rises = condition && !timer.edge;
  timer.edge = condition;
  timer.delays = true;
  if (rises && !timer.output) {
    timer.running = LoadTime(timer, word);
    timer.output = !timer.running;
  }
  return timer.output;
}

/// SF: on with the condition, off when it has been 0 for the time.
[[gnu::noinline]] static constexpr bool StartOffDelay(TimeWordTimer& timer, bool condition, uint16_t word) noexcept {
  const bool rises = condition && !timer.edge;
  const bool falls = !condition && timer.edge;
  timer.edge = condition;
  timer.delays = false;
  if (rises) {
    timer.output = true;
    timer.running = false;
    timer.left_ms = 0;
  } else if (falls && timer.output) {
    timer.running = timer.output = LoadTime(timer, word);
  }
  return timer.output;
}

/// R T: off; edge and scale keep their values, so that the timer stays off until a new edge.
constexpr void ResetTimer(TimeWordTimer& timer, bool condition) noexcept {
  if (condition) StopTimer(timer);
}

/// `ms` have passed since the last call.
[[gnu::noinline]] static constexpr void PassTime(TimeWordTimer& timer, uint32_t ms) noexcept {
  if (!timer.running) return;
  if (ms < timer.left_ms) {
    timer.left_ms -= ms;
    return;
  }
  timer.left_ms = 0;
  timer.running = false;
  timer.output = timer.delays;
}

/// L T: the time left in units of the scale, rounded up.
[[gnu::noinline]] static constexpr uint16_t TimeLeft(const TimeWordTimer& timer) noexcept {
  const uint32_t unit = MsPerUnit(timer.scale);
  return static_cast<uint16_t>((timer.left_ms + unit - 1) / unit);
}

/// LD T: the same as three BCD digits, with the scale of the last start in bits 13..12.
[[gnu::noinline]] static constexpr uint16_t TimeLeftCoded(const TimeWordTimer& timer) noexcept {
  return static_cast<uint16_t>((ToBcd16(TimeLeft(timer)) & 0x0FFF) | (timer.scale << 12));
}

}  // namespace plcxx
