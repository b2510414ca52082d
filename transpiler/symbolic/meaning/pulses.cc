// One-shots (NC110 7.3) and edges (HOST50 7.1).
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// Whether the count of slow cycles has come to the target; as a difference, so that both may wrap.
Value IsReached(Value slow_done, Value target) { return Not(Sign(slow_done - target)); }

}  // namespace

void PulseSlow(OneShotValues& shot, Bit input, I32 slow_cycle) {
  shot.pulse = input & Not(shot.previous);
  shot.previous = input;
  SetIf(shot.pulse, shot.stamp, slow_cycle);
  shot.fast = shot.fast & Not(shot.pulse);
}

/// A running pulse stays as it is. A new one ends after a complete slow cycle: with one in progress, after the next.
void PulseFast(OneShotValues& shot, Bit input, I32 slow_done, I8 slice) {
  const Value reached = IsReached(slow_done, shot.target);
  const Value running = shot.pulse & Not(reached);
  const Value starts = Not(running) & input & Not(shot.previous);
  const Value complete = Select(slice == 0, slow_done + 1, slow_done + 2);
  shot.target = Select(starts, complete, Select(reached, slow_done, shot.target));
  shot.pulse = running | starts;
  shot.fast = shot.fast | starts;
  shot.previous = input;
}

void ExpirePulseSlow(OneShotValues& shot, I32 slow_cycle) {
  shot.pulse = shot.pulse & (shot.fast | (shot.stamp == slow_cycle));
}
void ExpirePulseFast(OneShotValues& shot, I32 slow_done) {
  shot.pulse = shot.pulse & Not(shot.fast & IsReached(slow_done, shot.target));
}

Bit Rising(EdgeMemoryValues& edge, Bit signal) {
  const Value rises = signal & Not(edge.was);
  edge.was = signal;
  return rises;
}
Bit Falling(EdgeMemoryValues& edge, Bit signal) {
  const Value falls = Not(signal) & edge.was;
  edge.was = signal;
  return falls;
}
void PresetEdge(EdgeMemoryValues& edge, Bit signal) { edge.was = signal; }

}  // namespace plcxx::meaning
