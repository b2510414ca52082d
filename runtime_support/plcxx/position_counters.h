// The up and down counter of a rotary part, a ring from a low value to the preset: CNUD.
//
// Implements HOST50 7.3 to the letter. Counts are two's complement. All zero is the state after power-on: the first
// execution loads the start value and does not count.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

#include "plcxx/compare.h"

namespace plcxx {

struct PositionCounter {
  uint32_t value;   // .V
  uint32_t preset;  // .P of the last execution
  bool loaded;      // has been executed since power-on
  bool previous;    // the input at the last execution
  bool output;      // .Q
};

/// The pins P (reset), M (down) and N (low value 1) as bits 0, 1 and 2.
[[gnu::const]] constexpr uint8_t Pins(bool p, bool m, bool n) noexcept {
  return static_cast<uint8_t>((p ? 1 : 0) | (m ? 2 : 0) | (n ? 4 : 0));
}

/// `holds`: at the end the count stays instead of going round.
constexpr bool StepPositionCounter(PositionCounter& counter, bool input, uint32_t preset, uint8_t pins,
                                   bool holds) noexcept {
  const bool reset = (pins & 1) != 0, down = (pins & 2) != 0;
  const uint32_t low = (pins & 4) != 0 ? 1 : 0;
  if (!counter.loaded || reset) {
    counter.value = down ? preset : low;
    counter.loaded = true;
  } else if (input && !counter.previous) {
    const bool at_end = down ? S32(counter.value) <= S32(low) : S32(counter.value) >= S32(preset);
    if (!at_end) {
      counter.value = down ? counter.value - 1U : counter.value + 1U;
    } else if (!holds) {
      counter.value = down ? preset : low;
    }
  }
  counter.previous = input;
  counter.preset = preset;
  counter.output = !reset && (down ? S32(counter.value) <= S32(low) : S32(counter.value) >= S32(preset));
  return counter.output;
}

[[gnu::noinline]] static constexpr bool CNUD(PositionCounter& counter, bool input, uint32_t preset,
                                             uint8_t pins) noexcept {
  return StepPositionCounter(counter, input, preset, pins, false);
}
[[gnu::noinline]] static constexpr bool CNUDHold(PositionCounter& counter, bool input, uint32_t preset,
                                                 uint8_t pins) noexcept {
  return StepPositionCounter(counter, input, preset, pins, true);
}

}  // namespace plcxx
