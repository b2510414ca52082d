// The on-delay timer: its output follows its input after the input has been 1 for a preset time.
//
// Implements NC110 7.1 to the letter. All zero is the state after power-on.
// Not its job: units (the caller passes the preset in milliseconds) and clocks (the caller passes the time, latched
// once per period, so that all timers of a period agree).
// A long step is called where it is used and not copied there, in this file and its neighbours: a scan executes
// everything once, so it costs what fetching its code costs, and a copy has three times the bytes of a call. `static`
// shows the compiler all calls: it passes arguments as it likes and keeps values across a call in what the step leaves
// alone. A short one is copied, for a call and its arguments would be as long.
#pragma once

#include <stdint.h>

#include "plcxx/arith.h"

namespace plcxx {

struct OnDelayTimer {
  uint32_t elapsed_ms;  // counted since the start; stops at the highest number
  uint32_t last_ms;     // time of the last execution
  bool input;           // TnnI
  bool hold;            // TnnA, written by the program: 1 stops the counting
  bool done;            // TnnU: the delay has elapsed and the input is still 1
  bool timing;          // TnnD: started, not yet done
};

/// Steps the timer where its input statement stands. The time of a skipped statement is added at its next execution,
/// unless the timer is held then. `now_ms` may wrap; two executions must be less than 2^32 ms apart.
/// The preset may change at any time; once done, the timer stays done until the input is 0.
[[gnu::noinline]] static constexpr void OnDelay(OnDelayTimer& timer, bool input, uint32_t preset_ms,
                                                uint32_t now_ms) noexcept {
  if (!input) {
    timer.input = false;
    timer.done = false;
    timer.timing = false;
    timer.elapsed_ms = 0;
  } else {
    if (!timer.input) {
      timer.input = true;
      timer.elapsed_ms = 0;
    } else if (!timer.hold) {
      timer.elapsed_ms = AddSaturate32(timer.elapsed_ms, now_ms - timer.last_ms);
    }
    if (!timer.done) {
      if (timer.elapsed_ms >= preset_ms) {
        timer.done = true;
        timer.timing = false;
      } else {
        timer.timing = true;
      }
    }
  }
  timer.last_ms = now_ms;
}

}  // namespace plcxx
