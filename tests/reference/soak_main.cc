// plcxx_soak: random programs in the simulator and in the reference, a part of them also as generated C++, for as long
// as it is told. What disagrees is made small and saved with its scenario; the exit code is 1 then.
#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "tests/reference/compiled_runs.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/temporary_directory.h"

namespace {

using namespace plcxx::reference;
using Clock = std::chrono::steady_clock;

/// Ctrl-C: the programs under way are ended, and the table is printed.
volatile std::sig_atomic_t stopped = 0;

struct Wanted {
  std::vector<std::string> dialects;
  uint64_t programs = 0;  // of each dialect; 0: until the time is over
  double hours = 0;
  uint64_t seed = 1;
  unsigned jobs = 2;
  uint64_t large_every = 20, compiled_every = 0;
  std::string save = "soak";
  std::vector<std::string> compilers = {"g++ -O0", "g++ -O2", "g++ -O3", "clang++-19 -O2"};
};

struct Tally {
  uint64_t programs = 0, large = 0, compiled = 0, compared = 0, disagreements = 0, refused = 0, unsupported = 0;
};

class Soak {
 public:
  explicit Soak(Wanted wanted) : wanted_(std::move(wanted)) {
    for (const ReferenceDialect& dialect : ReferenceDialects()) {
      const bool named = std::ranges::find(wanted_.dialects, dialect.name) != wanted_.dialects.end();
      if (wanted_.dialects.empty() || named) dialects_.push_back(&dialect);
    }
    if (dialects_.empty()) throw std::invalid_argument("no such dialect has a reference");
    tallies_.resize(dialects_.size());
    if (wanted_.compiled_every == 0) return;
    for (const std::string& command : wanted_.compilers) compilers_.push_back(MakeCompiler(command));
  }

  int Run() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < wanted_.jobs; ++i) threads.emplace_back([this] { Work(); });
    for (std::thread& thread : threads) thread.join();
    Print();
    return failed_ ? 1 : 0;
  }

 private:
  bool TimeIsOver() const {
    if (stopped != 0) return true;
    const std::chrono::duration<double, std::ratio<3600>> hours = Clock::now() - begun_;
    return wanted_.hours > 0 && hours.count() >= wanted_.hours;
  }

  void Work() {
    const plcxx::testing_support::TemporaryDirectory directory;
    for (uint64_t next = next_++; !TimeIsOver(); next = next_++) {
      const size_t dialect = next % dialects_.size();
      const uint64_t number = next / dialects_.size();
      if (wanted_.programs != 0 && number >= wanted_.programs) return;
      One(*dialects_[dialect], tallies_[dialect], number, directory.path().string());
    }
  }

  void One(const ReferenceDialect& dialect, Tally& tally, uint64_t number, const std::string& directory) {
    const uint64_t seed = (wanted_.seed << 32) + number;
    Random random(seed);
    const bool large = number % wanted_.large_every == wanted_.large_every - 1;
    const RandomProgram program = dialect.generate(random, large ? ProgramSize::kLarge : ProgramSize::kSmall);
    for (const auto& entry : std::filesystem::directory_iterator(directory)) std::filesystem::remove_all(entry);
    const RunResult result = RunRandom(program, dialect, directory);
    std::string compiled;
    const bool compile = wanted_.compiled_every != 0 && number % wanted_.compiled_every == 0;
    if (compile && result.outcome == Outcome::kAgrees) compiled = RunCompiled(directory, compilers_);
    {
      const std::lock_guard lock(mutex_);
      ++tally.programs;
      tally.large += large ? 1 : 0;
      tally.compiled += compile ? 1 : 0;
      tally.compared += result.compared;
      tally.refused += result.outcome == Outcome::kNothingToRun ? 1 : 0;
      tally.unsupported += result.outcome == Outcome::kUnsupported ? 1 : 0;
      if (result.outcome == Outcome::kDisagrees || !compiled.empty()) ++tally.disagreements;
    }
    if (result.outcome == Outcome::kAgrees && compiled.empty()) return;
    const auto fails = [&](const RandomProgram& less) {
      const RunResult again = RunRandom(less, dialect, directory);
      if (compiled.empty()) return again.outcome == result.outcome;
      return again.outcome == Outcome::kAgrees && !RunCompiled(directory, compilers_).empty();
    };
    Save(dialect, seed, Shrink(program, fails), compiled.empty() ? result.text : compiled);
  }

  void Save(const ReferenceDialect& dialect, uint64_t seed, const RandomProgram& program, const std::string& text) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    const std::string folder = wanted_.save + "/" + std::string(dialect.name) + "_" + std::to_string(seed);
    std::filesystem::create_directories(folder);
    for (const RenderedFile& file : Render(program, std::string(dialect.name))) {
      std::ofstream(folder + "/" + file.name, std::ios::binary) << file.text;
    }
    std::cout << folder << "\n" << text << std::endl;
  }

  void Print() {
    std::printf("%-8s %10s %8s %9s %16s %14s %8s %12s\n", "dialect", "programs", "large", "compiled", "values compared",
                "disagreements", "refused", "unsupported");
    for (size_t i = 0; i < dialects_.size(); ++i) {
      const Tally& tally = tallies_[i];
      if (tally.refused != 0 || tally.unsupported != 0) failed_ = true;
      std::printf("%-8s %10ju %8ju %9ju %16ju %14ju %8ju %12ju\n", dialects_[i]->name.data(), uintmax_t{tally.programs},
                  uintmax_t{tally.large}, uintmax_t{tally.compiled}, uintmax_t{tally.compared},
                  uintmax_t{tally.disagreements}, uintmax_t{tally.refused}, uintmax_t{tally.unsupported});
    }
  }

  Wanted wanted_;
  std::vector<const ReferenceDialect*> dialects_;
  std::vector<Tally> tallies_;  // by dialect; guarded by mutex_ while threads run
  std::vector<std::shared_ptr<const plcxx::driver::Platform>> compilers_;
  std::atomic<uint64_t> next_ = 0;
  std::mutex mutex_;
  bool failed_ = false;
  Clock::time_point begun_ = Clock::now();
};

/// Scenario files instead of random programs: a disagreement that was saved, seen again.
int RunScenarios(const std::vector<std::string>& paths) {
  int disagree = 0;
  for (const std::string& path : paths) {
    const auto read = plcxx::driver::ReadScenario(path);
    const auto* const scenario = std::get_if<plcxx::driver::Scenario>(&read);
    if (scenario == nullptr) throw std::invalid_argument(path + " is no scenario");
    auto compilation = plcxx::driver::Compile(plcxx::driver::RequestOf(*scenario, {}));
    const ReferenceDialect* dialect =
        compilation.dialect == nullptr ? nullptr : FindReference(compilation.dialect->name);
    if (dialect == nullptr) throw std::invalid_argument(path + ": its dialect has no reference");
    const RunResult result = RunBeside(*scenario, compilation, *dialect);
    std::cout << (result.text.empty() ? path + ": both agree" : result.text) << "\n";
    disagree |= result.outcome == Outcome::kAgrees ? 0 : 1;
  }
  return disagree;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random programs in the simulator, in the reference, and as generated C++");
  Wanted wanted;
  app.add_option("--dialect", wanted.dialects, "only these");
  app.add_option("--programs", wanted.programs, "of each dialect");
  app.add_option("--hours", wanted.hours, "how long");
  app.add_option("--seed", wanted.seed, "another seed gives other programs");
  app.add_option("--jobs", wanted.jobs, "programs at a time");
  app.add_option("--large-every", wanted.large_every, "one program in N has 150 to 600 statements");
  app.add_option("--compiled-every", wanted.compiled_every, "one program in N also as generated C++; 0: none");
  app.add_option("--compiler", wanted.compilers, "with its flags: 'g++ -O2'");
  app.add_option("--save", wanted.save, "the folder for what disagrees");
  std::vector<std::string> scenarios;
  app.add_option("scenarios", scenarios, "these instead of random programs");
  std::signal(SIGINT, [](int) { stopped = 1; });
  std::signal(SIGTERM, [](int) { stopped = 1; });
  CLI11_PARSE(app, argc, argv);
  if (wanted.programs == 0 && wanted.hours == 0) wanted.programs = 200;
  try {
    return scenarios.empty() ? Soak(wanted).Run() : RunScenarios(scenarios);
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << "\n";
    return 2;
  }
}
