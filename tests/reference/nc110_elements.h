// Timers, counters and one-shots of nc110, from section 7 of the specification.
#pragma once

#include <cstdint>
#include <optional>

namespace plcxx::reference::nc110_elements {

enum class Part : uint8_t { kSlow, kFast };

/// Counts of 4.3 that elements look at.
struct Cycles {
  uint32_t slow_cycle = 0, slow_done = 0, fast_executions = 0;
  bool slow_in_progress = false;  // j is not 0
};

struct Timer {  // 7.1
  bool input = false, hold = false, elapsed_output = false, running = false;
  uint32_t elapsed = 0, last = 0;

  void Step(bool v, uint64_t preset_ms, uint32_t now) {
    if (!v) {
      input = elapsed_output = running = false;
      elapsed = 0;
    } else {
      if (!input) {
        input = true;
        elapsed = 0;
      } else if (!hold) {
        const uint64_t sum = uint64_t{elapsed} + static_cast<uint32_t>(now - last);
        elapsed = sum > 0xFFFF'FFFF ? 0xFFFF'FFFF : static_cast<uint32_t>(sum);
      }
      if (!elapsed_output) {
        elapsed_output = elapsed >= preset_ms;
        running = !elapsed_output;
      }
    }
    last = now;
  }
};

enum class Carry : uint8_t { kScan, kInput, kNext };

struct Counter {  // 7.2
  bool input = false, down = false, reset = false, carry = false;
  uint8_t count = 0;
  uint32_t stamp = 0;
  std::optional<Part> part;  // of the carry; none: the host wrote it

  void Reset(bool v) {
    if (v && !reset) {
      count = 0;
      carry = input = down = false;
    }
    reset = v;
  }

  /// False: the modulus is out of range, which is a fault.
  bool Step(bool v, uint32_t modulus, Carry mode, Part in, const Cycles& now) {
    if (mode == Carry::kScan || (mode == Carry::kInput && !v)) carry = false;
    if (reset) {
      input = false;
      return true;
    }
    const bool rising = v && !input;
    input = v;
    if (!rising) return true;
    if (mode == Carry::kNext) carry = false;
    if (modulus < 2 || modulus > 255) return false;
    bool wraps = false;
    if (!down) {
      wraps = count + 1u >= modulus;
      count = wraps ? uint8_t{0} : static_cast<uint8_t>(count + 1);
    } else {
      wraps = count == 0;
      count = static_cast<uint8_t>(wraps ? modulus - 1 : count - 1u);
    }
    if (!wraps) return true;
    carry = true;
    part = in;
    stamp = in == Part::kSlow ? now.slow_cycle : now.fast_executions;
    return true;
  }

  void Expire(Part ended, const Cycles& now) {
    const uint32_t current = ended == Part::kSlow ? now.slow_cycle : now.fast_executions;
    if (part.value_or(ended) == ended && carry && stamp != current) carry = false;
  }
};

struct OneShot {  // 7.3
  bool pulse = false, previous = false;
  uint32_t stamp = 0, target = 0;
  Part part = Part::kSlow;

  void StepSlow(bool v, const Cycles& now) {
    pulse = v && !previous;
    if (pulse) {
      stamp = now.slow_cycle;
      part = Part::kSlow;
    }
    previous = v;
  }

  void StepFast(bool v, const Cycles& now) {
    if (pulse && now.slow_done < target) {
      previous = v;
      return;
    }
    pulse = v && !previous;
    if (pulse) {
      target = now.slow_done + (now.slow_in_progress ? 2 : 1);
      part = Part::kFast;
    }
    previous = v;
  }

  void Expire(Part ended, const Cycles& now) {
    if (part != ended || !pulse) return;
    if (ended == Part::kSlow ? stamp < now.slow_cycle : now.slow_done >= target) pulse = false;
  }
};

}  // namespace plcxx::reference::nc110_elements
