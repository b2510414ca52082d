// The counter of a rotary part: HOST50 7.3.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// At the end of the ring: round to its start, or stay.
enum class AtEnd : uint8_t { kGoesRound, kStays };

Bit Step(PositionCounterValues& counter, Value input, Value preset, Value pins, AtEnd at_end) {
  const Value reset = Bits(pins, 0, 1), down = Bits(pins, 1, 1);
  const Value low = Zext(Bits(pins, 2, 1), 32);
  const Value start = Select(down, preset, low);
  const auto is_at_end = [&](Value value) {
    return Select(down, SignedAtMost(value, low), SignedAtMost(preset, value));
  };
  const Value next = Select(down, counter.value - 1, counter.value + 1);
  const Value counted = Select(is_at_end(counter.value), at_end == AtEnd::kGoesRound ? start : counter.value, next);
  const Value loads = Not(counter.loaded) | reset;
  const Value counts = input & Not(counter.previous);
  counter.value = Select(loads, start, Select(counts, counted, counter.value));
  counter.loaded = input.Bit(true);
  counter.previous = input;
  counter.preset = preset;
  counter.output = Not(reset) & is_at_end(counter.value);
  return counter.output;
}

}  // namespace

I8 CounterPins(Bit p, Bit m, Bit n) { return Zext(Join(n, Join(m, p)), 8); }

Bit CountRing(PositionCounterValues& counter, Bit input, I32 preset, I8 pins) {
  return Step(counter, input, preset, pins, AtEnd::kGoesRound);
}
Bit CountHold(PositionCounterValues& counter, Bit input, I32 preset, I8 pins) {
  return Step(counter, input, preset, pins, AtEnd::kStays);
}

}  // namespace plcxx::meaning
