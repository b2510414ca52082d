// A plain real-time loop of Linux: one thread with a fixed period, and what can be said of its punctuality.
//
// Memory is locked, the thread has a priority of its own (SCHED_FIFO), and it waits for absolute times, so that no
// delay adds up. A period that begins after the next one was due is an overrun: the periods that were missed are left
// out, and the program's time goes on with the clock's.
#pragma once

#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdint.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

namespace plcxx::host {

constexpr int64_t kNsPerMs = 1'000'000, kNsPerS = 1'000'000'000;

inline int64_t ClockNs() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * kNsPerS + now.tv_nsec;
}

/// How late periods began, and how long they took. Nothing in it is reset while it runs.
struct Punctuality {
  uint64_t periods = 0, overruns = 0, missed = 0;  // missed: periods that overruns left out
  int64_t latest_ns = 0, late_sum_ns = 0, longest_ns = 0;
  /// By powers of two of a microsecond: late by less than 1, 2, 4 ... us; the last takes all others.
  static constexpr uint32_t kClasses = 20;
  uint64_t late[kClasses] = {};

  void Count(int64_t late_ns) noexcept {
    ++periods;
    if (late_ns > latest_ns) latest_ns = late_ns;
    late_sum_ns += late_ns;
    uint32_t index = 0;
    while (index + 1 < kClasses && late_ns >= (int64_t{1000} << index)) ++index;
    ++late[index];
  }
};

enum class RealTime : uint8_t { kYes, kNoPriority, kNoLockedMemory };

/// For the calling thread. Without the right to it the loop runs all the same, and is not real-time.
inline RealTime BecomeRealTime(int priority) noexcept {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) return RealTime::kNoLockedMemory;
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0 ? RealTime::kYes : RealTime::kNoPriority;
}

/// Calls `period(begin, missed)` every `period_ns` until it says false: `begin` is the clock's time, and `missed`
/// periods were left out before this one.
template <class Period>
void RunPeriods(int64_t period_ns, Punctuality& punctuality, Period&& period) {
  int64_t next = ClockNs();
  for (uint64_t missed = 0;;) {
    const timespec until{static_cast<time_t>(next / kNsPerS), static_cast<long>(next % kNsPerS)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
    const int64_t begin = ClockNs();
    punctuality.Count(begin - next);
    if (!period(begin, missed)) return;
    const int64_t end = ClockNs();
    if (end - begin > punctuality.longest_ns) punctuality.longest_ns = end - begin;
    next += period_ns;
    missed = 0;
    if (end > next) {
      missed = static_cast<uint64_t>((end - next) / period_ns + 1);
      next += static_cast<int64_t>(missed) * period_ns;
      ++punctuality.overruns;
      punctuality.missed += missed;
    }
  }
}

}  // namespace plcxx::host
