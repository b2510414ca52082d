// The ring counter of NC110 7.2, with the carry of decision D9.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// Where the carry was set last; 0 is nowhere yet, so a carry is the host's.
constexpr uint8_t kInSlowPart = 1, kInFastPart = 2;

/// Takes the input: gives whether it counts. During a reset it does not, and counts as 0.
Value TakeInput(RingCounterValues& counter, Value input) {
  const Value taken = input & Not(counter.reset);
  const Value rises = taken & Not(counter.input);
  counter.input = taken;
  return rises;
}

/// Counts where `when` holds and the modulus is 2..255; sets the carry when the count goes round. Gives whether nothing
/// had to be counted or it was.
Bit Count(RingCounterValues& counter, Value when, Value modulus) {
  const Value fits = Not(Less(modulus, 2)) & AtMost(modulus, 255);
  const Value counts = when & fits;
  const Value above = Zext(counter.count, 16) + 1;
  const Value wraps_up = AtMost(modulus, above), wraps_down = counter.count == 0;
  const Value up = Select(wraps_up, counter.count.Same(0), counter.count + 1);
  const Value down = Select(wraps_down, Low(modulus, 8), counter.count) - 1;
  SetIf(counts, counter.count, Select(counter.down, down, up));
  counter.carry = counter.carry | (counts & Select(counter.down, wraps_down, wraps_up));
  return Not(when) | fits;
}

/// The carry ends with the statement's next execution; `stamp` says when it was set, `part` in which part.
Bit CountInScan(RingCounterValues& counter, Value input, Value modulus, Value stamp, uint8_t part) {
  counter.carry = input.Bit(false);
  const Value rises = TakeInput(counter, input);
  const Value done = Count(counter, rises, modulus);
  SetIf(counter.carry, counter.stamp, stamp);
  SetIf(counter.carry, counter.part, counter.part.Same(part));
  return done;
}

}  // namespace

Bit CountSlow(RingCounterValues& counter, Bit input, I16 modulus, I32 slow_cycle) {
  return CountInScan(counter, input, modulus, slow_cycle, kInSlowPart);
}
Bit CountFast(RingCounterValues& counter, Bit input, I16 modulus, I32 fast_count) {
  return CountInScan(counter, input, modulus, fast_count, kInFastPart);
}

/// The carry stays while the input is 1.
Bit CountCarryWhileInput(RingCounterValues& counter, Bit input, I16 modulus) {
  counter.carry = counter.carry & input;
  const Value rises = TakeInput(counter, input);
  return Count(counter, rises, modulus);
}

/// The carry stays until the next edge.
Bit CountCarryUntilNext(RingCounterValues& counter, Bit input, I16 modulus) {
  const Value rises = TakeInput(counter, input);
  counter.carry = counter.carry & Not(rises);
  return Count(counter, rises, modulus);
}

void ResetCounter(RingCounterValues& counter, Bit z) {
  const Value clears = z & Not(counter.reset);
  SetIf(clears, counter.count, counter.count.Same(0));
  counter.carry = counter.carry & Not(clears);
  counter.input = counter.input & Not(clears);
  counter.down = counter.down & Not(clears);
  counter.reset = z;
}

void ExpireCounterSlow(RingCounterValues& counter, I32 slow_cycle) {
  counter.carry = counter.carry & ((counter.part == kInFastPart) | (counter.stamp == slow_cycle));
}
void ExpireCounterFast(RingCounterValues& counter, I32 fast_count) {
  counter.carry = counter.carry & ((counter.part == kInSlowPart) | (counter.stamp == fast_count));
}

}  // namespace plcxx::meaning
