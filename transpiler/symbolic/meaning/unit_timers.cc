// Timers that count the period of their section: HOST50 7.2.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// What the blocks of one kind have in common: the operands, in milliseconds.
struct Operands {
  Value input, preset, preset_ms, period_ms;
  uint64_t unit_ms;
};

/// A negative preset counts as 0.
Operands InMs(Value input, Value preset, Value period_ms, uint64_t unit_ms) {
  return {.input = input,
          .preset = preset,
          .preset_ms = Select(Sign(preset), preset.Const(0, 64), Zext(preset, 64) * unit_ms),
          .period_ms = Zext(period_ms, 64),
          .unit_ms = unit_ms};
}

/// The end of a running delay.
void EndDelay(UnitTimerValues& timer, const Operands& o) {
  const Value ends = timer.running & AtMost(o.preset_ms, timer.elapsed_ms);
  SetIf(ends, timer.elapsed_ms, o.preset_ms);
  timer.output = timer.output & Not(ends);
  timer.running = timer.running & Not(ends);
}

/// What a program reads after every execution; gives .Q.
Bit Publish(UnitTimerValues& timer, const Operands& o) {
  timer.previous = o.input;
  timer.preset = o.preset;
  const Value shown = Select(Less(timer.elapsed_ms, o.preset_ms), timer.elapsed_ms, o.preset_ms);
  timer.value = Low(Quotient(shown, o.unit_ms), 32);
  return timer.output;
}

Bit StepTon(UnitTimerValues& timer, const Operands& o) {
  const Value zero = timer.elapsed_ms.Same(0);
  const Value counts = o.input & Not(timer.output);
  SetIf(counts, timer.elapsed_ms, Select(timer.previous, timer.elapsed_ms + o.period_ms, zero));
  const Value reached = counts & AtMost(o.preset_ms, timer.elapsed_ms);
  SetIf(reached, timer.elapsed_ms, o.preset_ms);
  SetIf(Not(o.input), timer.elapsed_ms, zero);
  timer.output = o.input & (timer.output | reached);
  return Publish(timer, o);
}

Bit StepTof(UnitTimerValues& timer, const Operands& o) {
  const Value falls = Not(o.input) & timer.previous;
  SetIf(timer.running, timer.elapsed_ms, timer.elapsed_ms + o.period_ms);
  SetIf(o.input | falls, timer.elapsed_ms, timer.elapsed_ms.Same(0));
  timer.output = timer.output | o.input;
  timer.running = Not(o.input) & (timer.running | falls);
  EndDelay(timer, o);
  return Publish(timer, o);
}

/// As the manual has it: the time runs from the falling input.
Bit StepTp(UnitTimerValues& timer, const Operands& o) {
  const Value rises = o.input & Not(timer.previous), falls = Not(o.input) & timer.previous;
  const Value changes = rises | falls;
  const Value zero = timer.elapsed_ms.Same(0);
  // A falling input changes nothing when no pulse is there.
  SetIf(timer.running & Not(changes), timer.elapsed_ms, timer.elapsed_ms + o.period_ms);
  SetIf(rises | (falls & timer.output), timer.elapsed_ms, zero);
  timer.running = Not(rises) & (timer.running | (falls & timer.output));
  timer.output = timer.output | rises;
  EndDelay(timer, o);
  return Publish(timer, o);
}

/// As IEC has it: a pulse of fixed length from the rising input.
Bit StepPulse(UnitTimerValues& timer, const Operands& o) {
  const Value starts = o.input & Not(timer.previous) & Not(timer.running);
  const Value zero = timer.elapsed_ms.Same(0);
  SetIf(timer.running, timer.elapsed_ms, timer.elapsed_ms + o.period_ms);
  SetIf(starts, timer.elapsed_ms, zero);
  timer.output = timer.output | starts;
  timer.running = timer.running | starts;
  EndDelay(timer, o);
  SetIf(Not(o.input | timer.running), timer.elapsed_ms, zero);
  return Publish(timer, o);
}

constexpr uint64_t kTenthOfSecond = 100, kSecond = 1000, kMinute = 60000;

}  // namespace

Bit TonMs(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTon(timer, InMs(input, preset, period_ms, kTenthOfSecond));
}
Bit TonS(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTon(timer, InMs(input, preset, period_ms, kSecond));
}
Bit TonM(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTon(timer, InMs(input, preset, period_ms, kMinute));
}
Bit TofMs(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTof(timer, InMs(input, preset, period_ms, kTenthOfSecond));
}
Bit TofS(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTof(timer, InMs(input, preset, period_ms, kSecond));
}
Bit TofM(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTof(timer, InMs(input, preset, period_ms, kMinute));
}
Bit TpMs(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTp(timer, InMs(input, preset, period_ms, kTenthOfSecond));
}
Bit TpS(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTp(timer, InMs(input, preset, period_ms, kSecond));
}
Bit TpM(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepTp(timer, InMs(input, preset, period_ms, kMinute));
}
Bit PulseMs(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepPulse(timer, InMs(input, preset, period_ms, kTenthOfSecond));
}
Bit PulseS(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepPulse(timer, InMs(input, preset, period_ms, kSecond));
}
Bit PulseM(UnitTimerValues& timer, Bit input, I32 preset, I32 period_ms) {
  return StepPulse(timer, InMs(input, preset, period_ms, kMinute));
}

}  // namespace plcxx::meaning
