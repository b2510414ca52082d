// Counters 0..999: PROSTEP 7.2.
#include "transpiler/symbolic/meaning/digits.h"
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

constexpr uint64_t kHighest = 999;

/// The low three digits, at most 999.
Value PresetOf(Value word) {
  const Value number = NumberOfDigits(Low(word, 12), 16);
  return Select(AtMost(number, kHighest), number, number.Same(kHighest));
}

}  // namespace

Bit CountUp(DecadeCounterValues& counter, Bit condition) {
  const Value counts = condition & Not(counter.up_edge) & Less(counter.value, kHighest);
  SetIf(counts, counter.value, counter.value + 1);
  counter.up_edge = condition;
  return counter.value != 0;
}

Bit CountDown(DecadeCounterValues& counter, Bit condition) {
  const Value counts = condition & Not(counter.down_edge) & (counter.value != 0);
  SetIf(counts, counter.value, counter.value - 1);
  counter.down_edge = condition;
  return counter.value != 0;
}

void SetCounter(DecadeCounterValues& counter, Bit condition, I16 preset) {
  SetIf(condition, counter.value, PresetOf(preset));
}
void SetCounterOnEdge(DecadeCounterValues& counter, Bit condition, I16 preset) {
  SetIf(condition & Not(counter.set_edge), counter.value, PresetOf(preset));
  counter.set_edge = condition;
}
void ZeroCounter(DecadeCounterValues& counter, Bit condition) {
  SetIf(condition, counter.value, counter.value.Same(0));
}

}  // namespace plcxx::meaning
