// Timers, counters, ROT and conversions of host50, from sections 6.4, 6.5 and 7 of the specification.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace plcxx::reference::host50_elements {

struct Timer {  // 7.2
  bool previous = false, run = false, q = false;
  int64_t elapsed = 0;
  int32_t value = 0, preset = 0;  // .V, .P

  void StepOn(bool i, int32_t wanted, int64_t unit, int64_t period) {
    const int64_t pre = Pre(wanted, unit);
    if (!i) {
      elapsed = 0;
      q = false;
    } else if (!q) {
      elapsed = previous ? elapsed + period : 0;
      if (elapsed >= pre) {
        q = true;
        elapsed = pre;
      }
    }
    Note(i, wanted, unit);
  }

  void StepOff(bool i, int32_t wanted, int64_t unit, int64_t period) {
    if (i) {
      q = true;
      elapsed = 0;
      run = false;
    } else if (previous) {
      run = true;
      elapsed = 0;
    } else if (run) {
      elapsed += period;
    }
    End(Pre(wanted, unit));
    Note(i, wanted, unit);
  }

  void StepPulseManual(bool i, int32_t wanted, int64_t unit, int64_t period) {
    if (i && !previous) {
      q = true;
      run = false;
      elapsed = 0;
    } else if (!i && previous) {
      if (q) {
        run = true;
        elapsed = 0;
      }
    } else if (run) {
      elapsed += period;
    }
    End(Pre(wanted, unit));
    Note(i, wanted, unit);
  }

  void StepPulseIec(bool i, int32_t wanted, int64_t unit, int64_t period) {
    if (i && !previous && !run) {
      q = run = true;
      elapsed = 0;
    } else if (run) {
      elapsed += period;
    }
    End(Pre(wanted, unit));
    if (!i && !run) elapsed = 0;
    Note(i, wanted, unit);
  }

 private:
  static int64_t Pre(int32_t wanted, int64_t unit) { return std::max<int64_t>(wanted, 0) * unit; }
  void End(int64_t pre) {
    if (!run || elapsed < pre) return;
    q = run = false;
    elapsed = pre;
  }
  void Note(bool i, int32_t wanted, int64_t unit) {
    previous = i;
    preset = wanted;
    value = static_cast<int32_t>(std::min(elapsed, Pre(wanted, unit)) / unit);
  }
};

struct Counter {  // 7.3
  bool first = true, previous = false, q = false;
  int32_t value = 0, preset = 0;

  void Step(bool i, bool p, bool m, bool n, int32_t wanted, bool hold) {
    const int32_t low = n ? 1 : 0, start = m ? wanted : low;
    if (first) {
      value = start;
      first = false;
    } else if (p) {
      value = start;
    } else if (i && !previous) {
      const bool at_end = m ? value <= low : value >= wanted;
      if (!at_end) {
        value += m ? -1 : 1;
      } else if (!hold) {
        value = m ? wanted : low;
      }
    }
    previous = i;
    preset = wanted;
    q = !p && (m ? value <= low : value >= wanted);
  }
};

struct Rotation {  // 6.5
  int32_t result = 0;
  bool forward = false;
};
/// None: out of range.
inline std::optional<Rotation> Rotate(int32_t positions, int32_t current, int32_t target, int32_t base, bool steps) {
  const int64_t n = positions, last = n - 1 + base;
  if (n < 1 || current < base || current > last || target < base || target > last) return std::nullopt;
  const int64_t f = ((int64_t{target} - current) % n + n) % n, r = (n - f) % n;
  const bool forward = f <= r;
  const int64_t way = forward ? f : r;
  if (steps) return Rotation{static_cast<int32_t>(way), forward};
  if (way == 0) return Rotation{target, forward};
  const int64_t before = ((int64_t{target} - base + (forward ? -1 : 1)) % n + n) % n + base;
  return Rotation{static_cast<int32_t>(before), forward};
}

/// FTOW (6.4).
inline int32_t ToInteger(float f, bool round) {
  if (std::isnan(f)) return 0;
  const double whole = round ? std::round(static_cast<double>(f)) : std::trunc(static_cast<double>(f));
  if (whole >= 2147483647.0) return std::numeric_limits<int32_t>::max();
  if (whole <= -2147483648.0) return std::numeric_limits<int32_t>::min();
  return static_cast<int32_t>(whole);
}

/// Two's complement, modulo 2^32.
inline int32_t Wrap(int64_t value) { return static_cast<int32_t>(static_cast<uint32_t>(static_cast<uint64_t>(value))); }
/// By zero: the dividend.
inline int32_t Divide(int32_t a, int32_t b) { return b == 0 ? a : Wrap(int64_t{a} / b); }
inline float Divide(float a, float b) { return b == 0.0F ? a : a / b; }

}  // namespace plcxx::reference::host50_elements
