// plcxx_pairs: random pairs of programs for as long as it is told; one table. What is judged wrongly is saved; the exit
// code is 1 then.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "tests/pairs/judge.h"

namespace {

/// How many times as long as the processor's time a thread has waited for it: on a machine that others use, a pair gets
/// as much longer, so that as much is decided.
class Slowness {
 public:
  double factor() const { return factor_; }
  void Begin() {
    wall_ = Seconds(CLOCK_MONOTONIC);
    processor_ = Seconds(CLOCK_THREAD_CPUTIME_ID);
  }
  void End() {
    constexpr double kLeastSeconds = 0.05, kMost = 16;
    const double wall = Seconds(CLOCK_MONOTONIC) - wall_, processor = Seconds(CLOCK_THREAD_CPUTIME_ID) - processor_;
    if (processor > kLeastSeconds) factor_ = std::clamp(wall / processor, 1.0, kMost);
  }

 private:
  static double Seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
  }
  double factor_ = 1, wall_ = 0, processor_ = 0;
};

/// Ctrl-C and SIGTERM: the pairs under way are ended, and the table is printed.
volatile std::sig_atomic_t stopped = 0;

}  // namespace

int main(int argc, char** argv) {
  using namespace plcxx::pairs;
  CLI::App app("Random pairs of programs: is what plcxx diff says of them right?");
  std::vector<std::string> dialects{"nc110", "technol", "host50", "prostep", "hnc", "classicladder"};
  uint64_t pairs = 1000, seed = 1;
  unsigned jobs = 2;
  JudgeOptions options{.runs = 16, .steps = 60};
  std::string save = "pairs";
  bool tells = false;
  app.add_option("--dialect", dialects, "only these");
  app.add_option("--pairs", pairs, "of each language");
  app.add_option("--seed", seed, "another seed gives other pairs");
  app.add_option("--jobs", jobs, "pairs at a time");
  app.add_option("--time", options.time_ms, "milliseconds of the processor for each");
  app.add_option("--save", save, "the folder for what is judged wrongly");
  app.add_flag("--tell", tells, "what is done, and how long it takes");
  CLI11_PARSE(app, argc, argv);
  std::signal(SIGINT, [](int) { stopped = 1; });
  std::signal(SIGTERM, [](int) { stopped = 1; });
  std::map<std::string, Tally> tallies;
  std::mutex mutex;
  std::atomic<uint64_t> next = 0;
  const auto work = [&] {
    Slowness slowness;
    for (uint64_t one = next++; one < pairs * dialects.size() && stopped == 0; one = next++) {
      const std::string& dialect = dialects[one % dialects.size()];
      const uint64_t number = (seed << 32) + one / dialects.size();
      const Pair pair = PairOf(dialect, number);
      JudgeOptions own = options;
      own.time_ms = static_cast<uint64_t>(static_cast<double>(options.time_ms) * slowness.factor());
      slowness.Begin();
      const Tally tally = Judge(pair, number, own, save);
      slowness.End();
      const std::lock_guard lock(mutex);
      Add(tallies[dialect], tally);
      for (const std::string& what : tally.unsound) std::cout << what << std::endl;
      if (tells && tally.pairs != 0)
        std::cout << dialect << " " << number << " " << tally.longest_ms << " ms, " << tally.undecided
                  << " not decided: " << pair.what << std::endl;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < jobs; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (stopped != 0) std::cout << "stopped before its end\n";
  std::cout << TableHead();
  bool is_sound = true;
  for (const std::string& dialect : dialects) {
    std::cout << TableRow(dialect, tallies[dialect]);
    is_sound = is_sound && tallies[dialect].unsound.empty();
  }
  return is_sound ? 0 : 1;
}
