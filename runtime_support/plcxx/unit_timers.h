// Timers that count their section's period up to a preset number of units: TON, TOF, TP.
//
// Implements HOST50 7.2 to the letter. The functions carry the source's mnemonics: MS counts units of 100 ms, S of
// 1 s, M of 60 s. All zero is the state after power-on. A timer that is not executed freezes.
// Why long functions are called and not copied: timers.h.
#pragma once

#include <stdint.h>

namespace plcxx {

struct UnitTimer {
  // Where numbers of 8 bytes may begin at a multiple of 4 (32-bit x86), the layout is the same.
  alignas(8) uint64_t elapsed_ms;
  uint32_t value;   // .V: units elapsed, truncated, at most the preset; as of the last execution
  uint32_t preset;  // .P of the last execution
  bool previous;    // the input at the last execution
  bool running;     // TOF and TP: the delay is running
  bool output;      // .Q
};

/// A preset in units of `unit_ms`; a negative one counts as 0.
[[gnu::const]] constexpr uint64_t PresetMs(uint32_t preset, uint32_t unit_ms) noexcept {
  return preset > 0x7FFFFFFFU ? 0 : uint64_t{preset} * unit_ms;
}

constexpr bool EndTimerStep(UnitTimer& timer, bool input, uint32_t preset, uint64_t preset_ms,
                            uint32_t unit_ms) noexcept {
  timer.previous = input;
  timer.preset = preset;
  const uint64_t shown = timer.elapsed_ms < preset_ms ? timer.elapsed_ms : preset_ms;
  timer.value = static_cast<uint32_t>(shown / unit_ms);
  return timer.output;
}

/// The end of a delay of TOF and TP.
constexpr void EndDelay(UnitTimer& timer, uint64_t preset_ms) noexcept {
  if (!timer.running || timer.elapsed_ms < preset_ms) return;
  timer.output = false;
  timer.running = false;
  timer.elapsed_ms = preset_ms;
}

/// TON: on when the input has been 1 for the preset time; then until the input falls.
constexpr bool StepTon(UnitTimer& timer, bool input, uint32_t preset, uint32_t period_ms, uint32_t unit_ms) noexcept {
  const uint64_t preset_ms = PresetMs(preset, unit_ms);
  if (!input) {
    timer.elapsed_ms = 0;
    timer.output = false;
  } else if (!timer.output) {
    timer.elapsed_ms = timer.previous ? timer.elapsed_ms + period_ms : 0;
    if (timer.elapsed_ms >= preset_ms) {
      timer.output = true;
      timer.elapsed_ms = preset_ms;
    }
  }
  return EndTimerStep(timer, input, preset, preset_ms, unit_ms);
}

/// TOF: on with the input, off when it has been 0 for the preset time.
constexpr bool StepTof(UnitTimer& timer, bool input, uint32_t preset, uint32_t period_ms, uint32_t unit_ms) noexcept {
  const uint64_t preset_ms = PresetMs(preset, unit_ms);
  if (input) {
    timer.output = true;
    timer.elapsed_ms = 0;
    timer.running = false;
  } else if (timer.previous) {
    timer.running = true;
    timer.elapsed_ms = 0;
  } else if (timer.running) {
    timer.elapsed_ms += period_ms;
  }
  EndDelay(timer, preset_ms);
  return EndTimerStep(timer, input, preset, preset_ms, unit_ms);
}

/// TP as the manual describes it: on with the rising input, timed from the falling one.
constexpr bool StepTp(UnitTimer& timer, bool input, uint32_t preset, uint32_t period_ms, uint32_t unit_ms) noexcept {
  const uint64_t preset_ms = PresetMs(preset, unit_ms);
  if (input && !timer.previous) {
    timer.output = true;
    timer.running = false;
    timer.elapsed_ms = 0;
  } else if (!input && timer.previous) {
    if (timer.output) {
      timer.running = true;
      timer.elapsed_ms = 0;
    }
  } else if (timer.running) {
    timer.elapsed_ms += period_ms;
  }
  EndDelay(timer, preset_ms);
  return EndTimerStep(timer, input, preset, preset_ms, unit_ms);
}

/// TP=IEC: a pulse of the preset length from the rising input; not restarted while it lasts.
constexpr bool StepPulse(UnitTimer& timer, bool input, uint32_t preset, uint32_t period_ms, uint32_t unit_ms) noexcept {
  const uint64_t preset_ms = PresetMs(preset, unit_ms);
  if (input && !timer.previous && !timer.running) {
    timer.output = true;
    timer.running = true;
    timer.elapsed_ms = 0;
  } else if (timer.running) {
    timer.elapsed_ms += period_ms;
  }
  EndDelay(timer, preset_ms);
  if (!input && !timer.running) timer.elapsed_ms = 0;
  return EndTimerStep(timer, input, preset, preset_ms, unit_ms);
}

[[gnu::noinline]] static constexpr bool TONMS(UnitTimer& timer, bool input, uint32_t preset,
                                              uint32_t period_ms) noexcept {
  return StepTon(timer, input, preset, period_ms, 100);
}
[[gnu::noinline]] static constexpr bool TONS(UnitTimer& timer, bool input, uint32_t preset,
                                             uint32_t period_ms) noexcept {
  return StepTon(timer, input, preset, period_ms, 1000);
}
[[gnu::noinline]] static constexpr bool TONM(UnitTimer& timer, bool input, uint32_t preset,
                                             uint32_t period_ms) noexcept {
  return StepTon(timer, input, preset, period_ms, 60000);
}

[[gnu::noinline]] static constexpr bool TOFMS(UnitTimer& timer, bool input, uint32_t preset,
                                              uint32_t period_ms) noexcept {
  return StepTof(timer, input, preset, period_ms, 100);
}
[[gnu::noinline]] static constexpr bool TOFS(UnitTimer& timer, bool input, uint32_t preset,
                                             uint32_t period_ms) noexcept {
  return StepTof(timer, input, preset, period_ms, 1000);
}
[[gnu::noinline]] static constexpr bool TOFM(UnitTimer& timer, bool input, uint32_t preset,
                                             uint32_t period_ms) noexcept {
  return StepTof(timer, input, preset, period_ms, 60000);
}

[[gnu::noinline]] static constexpr bool TPMS(UnitTimer& timer, bool input, uint32_t preset,
                                             uint32_t period_ms) noexcept {
  return StepTp(timer, input, preset, period_ms, 100);
}
[[gnu::noinline]] static constexpr bool TPS(UnitTimer& timer, bool input, uint32_t preset,
                                            uint32_t period_ms) noexcept {
  return StepTp(timer, input, preset, period_ms, 1000);
}
[[gnu::noinline]] static constexpr bool TPM(UnitTimer& timer, bool input, uint32_t preset,
                                            uint32_t period_ms) noexcept {
  return StepTp(timer, input, preset, period_ms, 60000);
}

[[gnu::noinline]] static constexpr bool PulseMS(UnitTimer& timer, bool input, uint32_t preset,
                                                uint32_t period_ms) noexcept {
  return StepPulse(timer, input, preset, period_ms, 100);
}
[[gnu::noinline]] static constexpr bool PulseS(UnitTimer& timer, bool input, uint32_t preset,
                                               uint32_t period_ms) noexcept {
  return StepPulse(timer, input, preset, period_ms, 1000);
}
[[gnu::noinline]] static constexpr bool PulseM(UnitTimer& timer, bool input, uint32_t preset,
                                               uint32_t period_ms) noexcept {
  return StepPulse(timer, input, preset, period_ms, 60000);
}

}  // namespace plcxx
