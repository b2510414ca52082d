// The on-delay timer of NC110 7.1.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {

void OnDelay(OnDelayTimerValues& timer, Bit input, I32 preset_ms, I32 now_ms) {
  const Value sum = timer.elapsed_ms + (now_ms - timer.last_ms);
  const Value longer = Select(Less(sum, timer.elapsed_ms), sum.Same(0xFFFFFFFF), sum);
  const Value goes_on = input & timer.input;
  timer.elapsed_ms = Select(goes_on, Select(timer.hold, timer.elapsed_ms, longer), sum.Same(0));
  const Value reached = AtMost(preset_ms, timer.elapsed_ms);
  timer.timing = input & Select(timer.done, timer.timing, Not(reached));
  timer.done = input & (timer.done | reached);
  timer.input = input;
  timer.last_ms = now_ms;
}

}  // namespace plcxx::meaning
