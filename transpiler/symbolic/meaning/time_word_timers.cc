// Timers of a time word: PROSTEP 7.1.
#include "transpiler/symbolic/meaning/digits.h"
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// Milliseconds of a unit, by the low two bits of a scale.
Value UnitMs(Value scale) {
  const Value low = Bits(scale, 0, 1), high = Bits(scale, 1, 1);
  return Select(high, Select(low, scale.Const(1000, 32), scale.Const(100, 32)),
                Select(low, scale.Const(10, 32), scale.Const(1, 32)));
}

/// Takes the time word where `when` holds. Gives whether the word has any time.
Value LoadTime(TimeWordTimerValues& timer, Value when, Value word) {
  const Value scale = Zext(Bits(word, 12, 2), 8);
  const Value time = NumberOfDigits(Low(word, 12), 32) * UnitMs(scale);
  SetIf(when, timer.scale, scale);
  SetIf(when, timer.left_ms, time);
  return time != 0;
}

/// Takes the condition of a start instruction; gives whether it rises.
Value TakeCondition(TimeWordTimerValues& timer, Value condition) {
  const Value rises = condition & Not(timer.edge);
  timer.edge = condition;
  return rises;
}

void Stop(TimeWordTimerValues& timer, Value when) {
  const Value never = when.Bit(false);
  SetIf(when, timer.output, never);
  SetIf(when, timer.running, never);
  SetIf(when, timer.left_ms, timer.left_ms.Same(0));
}

/// Starts with the output 1 while there is time.
void Start(TimeWordTimerValues& timer, Value when, Value word) {
  const Value any = LoadTime(timer, when, word);
  SetIf(when, timer.running, any);
  SetIf(when, timer.output, any);
}
/// Starts with the output 0 until there is no time.
void StartDelay(TimeWordTimerValues& timer, Value when, Value word) {
  const Value any = LoadTime(timer, when, word);
  SetIf(when, timer.running, any);
  SetIf(when, timer.output, Not(any));
}

Value UnitsLeft(const TimeWordTimerValues& timer) {
  const Value unit = UnitMs(timer.scale);
  return Low(Quotient(timer.left_ms + unit - 1, unit), 16);
}

}  // namespace

/// SP
Bit StartPulse(TimeWordTimerValues& timer, Bit condition, I16 word) {
  const Value rises = TakeCondition(timer, condition);
  timer.delays = condition.Bit(false);
  Stop(timer, Not(condition));
  Start(timer, rises, word);
  return timer.output;
}

/// SE
Bit StartExtended(TimeWordTimerValues& timer, Bit condition, I16 word) {
  const Value rises = TakeCondition(timer, condition);
  timer.delays = condition.Bit(false);
  Start(timer, rises, word);
  return timer.output;
}

/// SR
Bit StartOnDelay(TimeWordTimerValues& timer, Bit condition, I16 word) {
  const Value rises = TakeCondition(timer, condition);
  timer.delays = condition.Bit(true);
  Stop(timer, Not(condition));
  StartDelay(timer, rises, word);
  return timer.output;
}

/// SS
Bit StartLatchedDelay(TimeWordTimerValues& timer, Bit condition, I16 word) {
  const Value rises = TakeCondition(timer, condition);
  timer.delays = condition.Bit(true);
  StartDelay(timer, rises & Not(timer.output), word);
  return timer.output;
}

/// SF: on with the rising condition, off when the time from the falling one is over.
Bit StartOffDelay(TimeWordTimerValues& timer, Bit condition, I16 word) {
  const Value falls = timer.edge & Not(condition);
  const Value rises = TakeCondition(timer, condition);
  timer.delays = condition.Bit(false);
  Start(timer, falls & timer.output, word);
  Stop(timer, rises);
  timer.output = timer.output | rises;
  return timer.output;
}

void ResetTimer(TimeWordTimerValues& timer, Bit condition) { Stop(timer, condition); }

void PassTime(TimeWordTimerValues& timer, I32 ms) {
  const Value ends = timer.running & AtMost(timer.left_ms, ms);
  const Value left = Select(ends, timer.left_ms.Same(0), timer.left_ms - ms);
  SetIf(timer.running, timer.left_ms, left);
  SetIf(ends, timer.output, timer.delays);
  timer.running = timer.running & Not(ends);
}

I16 TimeLeft(TimeWordTimerValues& timer) { return UnitsLeft(timer); }

/// Three digits, and above them the scale.
I16 TimeLeftCoded(TimeWordTimerValues& timer) {
  return Join(Low(timer.scale, 4), Low(DigitsOf(UnitsLeft(timer), 4), 12));
}

}  // namespace plcxx::meaning
