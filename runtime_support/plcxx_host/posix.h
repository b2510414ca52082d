// The main program of a host of its own on Linux: `plcxx emit --host posix`.
//
// You write the four functions of namespace plcxx::host below; pins have their numbers in NAME_pins.hpp.
#pragma once

#include <errno.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <plcxx_host/keeper.h>
#include <plcxx_host/pins.h>
#include <plcxx_host/real_time.h>

namespace plcxx::host {

/// Before the first period, outside of real time, with what the command line has after the loop's own options. False:
/// the program ends with exit code 1; say why yourself.
bool io_open(int argc, char** argv) noexcept;
/// At the start of each period: all inputs, at one moment. What you leave alone keeps its value.
void io_read(Value* pins) noexcept;
/// At the end of each period.
void io_write(const Value* pins) noexcept;
/// When the loop has ended: leave the machine with its outputs off.
void io_close() noexcept;

struct LoopOptions {
  const char* folder = nullptr;  // of the retentive memory
  int priority = 80;
  uint64_t periods = 0;  // 0: until a signal ends it
  bool needs_real_time = false;
  bool wants_help = false;
  const char *wrong = nullptr, *why = nullptr;
  int first_argument = 1;
};

inline volatile sig_atomic_t end_is_asked = 0;
extern "C" inline void PlcxxAskForEnd(int) { end_is_asked = 1; }

inline void PrintToStandardError(Severity, const char* machine, const char* text) {
  fprintf(stderr, "%s: %s\n", machine, text);
}

/// `arguments`: what is said of those that come after "--".
inline void PrintUsage(FILE* to, const char* name, const char* arguments) {
  fprintf(to,
          "usage: %s [--retentive FOLDER] [--priority 1..99] [--periods N] [--real-time] [-- ARGUMENT...]\n"
          "  --retentive FOLDER  keeps the retentive memory there, in two files\n"
          "  --priority N        of the loop's thread, SCHED_FIFO (80)\n"
          "  --periods N         ends after so many periods; else at SIGINT or SIGTERM\n"
          "  --real-time         ends at once where the priority or locked memory is not granted\n"
          "%s",
          name, arguments);
}

/// Digits alone: strtoull takes "-1" for a very large number.
inline bool ReadWholeNumber(const char* text, uint64_t least, uint64_t most, uint64_t& value) {
  if (*text < '0' || *text > '9') return false;
  char* end = nullptr;
  errno = 0;
  value = strtoull(text, &end, 10);
  return errno == 0 && *end == '\0' && value >= least && value <= most;
}

/// Whether all of it could be read; else `wrong` and `why` say what could not.
inline bool ReadLoopOptions(int argc, char** argv, LoopOptions& options) {
  const auto fail = [&options](const char* word, const char* why) {
    options.wrong = word;
    options.why = why;
    return false;
  };
  bool has_priority = false;
  int i = 1;
  for (; i < argc; ++i) {
    const char* const word = argv[i];
    if (strcmp(word, "--") == 0) {
      ++i;
      break;
    }
    if (strcmp(word, "--help") == 0) {
      options.wants_help = true;
      return true;
    }
    if (strcmp(word, "--real-time") == 0) {
      options.needs_real_time = true;
      continue;
    }
    const bool folder = strcmp(word, "--retentive") == 0, priority = strcmp(word, "--priority") == 0,
               periods = strcmp(word, "--periods") == 0;
    if (!folder && !priority && !periods) {
      return fail(word, "no option of the loop; what is meant for the terminals comes after --");
    }
    if ((folder && options.folder != nullptr) || (priority && has_priority) || (periods && options.periods != 0)) {
      return fail(word, "given twice");
    }
    if (i + 1 == argc) return fail(word, "needs a value");
    const char* const value = argv[++i];
    if (folder) options.folder = value;
    uint64_t number = 0;
    if (priority) {
      if (!ReadWholeNumber(value, 1, 99, number)) return fail(value, "no priority: 1 to 99");
      options.priority = static_cast<int>(number);
      has_priority = true;
    }
    if (periods && !ReadWholeNumber(value, 1, UINT64_MAX, options.periods)) {
      return fail(value, "no number of periods: 1 or more");
    }
  }
  options.first_argument = i;
  return true;
}

/// "1000 periods of 10 ms: late by 12 us on average, 85 us at most; ..."
inline void PrintPunctuality(const char* name, uint32_t period_ms, const Punctuality& seen) {
  const auto us = [](int64_t ns) { return static_cast<long>((ns + 500) / 1000); };
  const int64_t mean = seen.periods > 0 ? seen.late_sum_ns / static_cast<int64_t>(seen.periods) : 0;
  fprintf(stderr,
          "%s: %llu periods of %u ms: late by %ld us on average, %ld us at most; longest period %ld us; %llu overruns, "
          "%llu periods missed\n",
          name, static_cast<unsigned long long>(seen.periods), static_cast<unsigned>(period_ms), us(mean),
          us(seen.latest_ns), us(seen.longest_ns), static_cast<unsigned long long>(seen.overruns),
          static_cast<unsigned long long>(seen.missed));
}

/// What the loop calls in each period, with the clock's time at its begin: no memory, no lock and no system call, as
/// long as the Io needs none. A function of its own, for the audit of `plcxx build`.
template <class Machine, class Io>
[[gnu::noinline]] void OnePeriod(typename Machine::State& state, typename Machine::Host& host, Io& io,
                                 int64_t now_ns) noexcept {
  io.Read(host.pins, now_ns);
  Machine::Step(state, host);
  io.Write(host.pins);
}

/// What came of the arguments after "--" and of what they name.
enum class Opened : uint8_t { kYes, kWrongUse, kFailed };

/// The main function of a host; `io` has Usage, Open, Read, Write and Close as the functions above. Exit codes: 0
/// ended, 1 what it needs is not there, 2 wrong use.
template <class Machine, class Io>
int RunLoop(int argc, char** argv, Io& io) {
  static typename Machine::State state;
  static typename Machine::Host host;
  static Keeper<Machine> keeper;
  LoopOptions options;
  if (!ReadLoopOptions(argc, argv, options)) {
    fprintf(stderr, "%s: '%s': %s\n", Machine::kName, options.wrong, options.why);
    PrintUsage(stderr, Machine::kName, Io::Usage());
    return 2;
  }
  if (options.wants_help) {
    PrintUsage(stdout, Machine::kName, Io::Usage());
    return 0;
  }
  struct sigaction action{};
  action.sa_handler = PlcxxAskForEnd;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  keeper.Load(host, options.folder, Machine::kName, PrintToStandardError);
  switch (io.Open(argc - options.first_argument, argv + options.first_argument)) {
    case Opened::kYes:
      break;
    case Opened::kWrongUse:
      return 2;
    case Opened::kFailed:
      return 1;
  }
  const RealTime granted = BecomeRealTime(options.priority);
  if (granted != RealTime::kYes) {
    fprintf(stderr, "%s: not real-time: %s is not granted to this user (limits rtprio and memlock)\n", Machine::kName,
            granted == RealTime::kNoPriority ? "a real-time priority" : "locked memory");
    if (options.needs_real_time) {
      io.Close();
      return 1;
    }
  }
  if (!keeper.Start()) fprintf(stderr, "%s: no thread for files and messages: both wait for the end\n", Machine::kName);

  Punctuality seen;
  uint64_t left = options.periods;
  RunPeriods(int64_t{Machine::kBaseMs} * kNsPerMs, seen, [&](int64_t begin_ns, uint64_t missed) {
    host.skipped_ms += missed * Machine::kBaseMs;
    OnePeriod<Machine>(state, host, io, begin_ns);
    return end_is_asked == 0 && (left == 0 || --left > 0);
  });
  io.Close();
  keeper.Stop();
  PrintPunctuality(Machine::kName, Machine::kBaseMs, seen);
  return 0;
}

/// The four functions as an Io.
struct OwnIo {
  static const char* Usage() noexcept { return "  -- ARGUMENT...      for what reads and writes the terminals\n"; }
  Opened Open(int argc, char** argv) noexcept { return io_open(argc, argv) ? Opened::kYes : Opened::kFailed; }
  void Read(Value* pins, int64_t) noexcept { io_read(pins); }
  void Write(const Value* pins) noexcept { io_write(pins); }
  void Close() noexcept { io_close(); }
};

template <class Machine>
int RunMain(int argc, char** argv) {
  OwnIo io;
  return RunLoop<Machine>(argc, argv, io);
}

}  // namespace plcxx::host
