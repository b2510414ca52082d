// plcxx_soak: random programs in the simulator and in the reference, a part of them also as generated C++, for as long
// as it is told. What disagrees is made small and saved with its scenario; the exit code is 1 then. It says each minute
// how far it is; a signal ends the judges under way, and the table is of what was judged before.
#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "tests/reference/crossed.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/reference/shares.h"
#include "tests/reference/spellings.h"
#include "tests/temporary_directory.h"

namespace {

using namespace plcxx::reference;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::minutes kBetweenLines(1);

/// Ctrl-C and SIGTERM: what is under way is ended, and the table is printed.
volatile std::sig_atomic_t stopped = 0;
bool IsStopped() { return stopped != 0; }

struct Wanted {
  std::vector<std::string> dialects;
  uint64_t programs = 0;  // of each dialect; 0: until the time is over
  double hours = 0;
  uint64_t seed = 1;
  unsigned jobs = 2;
  uint64_t large_every = 8;
  uint64_t crossed_every = 0;  // 0: none
  ShareSizes one_in = {};
  std::string save = "soak";
  Judges judges;
};

struct Tally {
  uint64_t programs = 0, large = 0, spelled = 0, compared = 0, disagreements = 0, refused = 0, unsupported = 0;
  uint64_t crossed = 0, crossed_ran = 0;  // golden programs that were changed; the others of them are refused
  std::array<ShareCounts, 3> shares;
};

/// A program that waits for its share, and where it came from.
struct Waiting {
  size_t dialect = 0;
  uint64_t seed = 0;
  JudgedProgram judged;
};
constexpr int kMostTries = 30;            // of a golden program with changes
constexpr uint32_t kCapriciousOneIn = 3;  // programs
constexpr size_t kTogether = 16;          // programs of one call of a compiler

class Soak {
 public:
  explicit Soak(Wanted wanted) : wanted_(std::move(wanted)) {
    for (const ReferenceDialect& dialect : ReferenceDialects()) {
      const bool named = std::ranges::find(wanted_.dialects, dialect.name) != wanted_.dialects.end();
      if (wanted_.dialects.empty() || named) dialects_.push_back(&dialect);
    }
    if (dialects_.empty()) throw std::invalid_argument("no such dialect has a reference");
    tallies_.resize(dialects_.size());
    if (wanted_.crossed_every != 0) {
      for (const ReferenceDialect* dialect : dialects_) goldens_.emplace_back(dialect->name);
    }
    wanted_.judges.stops = IsStopped;
  }

  int Run() {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < wanted_.jobs; ++i) threads.emplace_back([this] { Work(); });
    std::jthread line([this](const std::stop_token& ended) { SayHowFar(ended); });
    for (std::thread& thread : threads) thread.join();
    line.request_stop();
    line.join();
    if (IsStopped()) std::printf("stopped before its end\n");
    Print();
    return failed_ ? 1 : 0;
  }

 private:
  bool TimeIsOver() const {
    if (IsStopped()) return true;
    const std::chrono::duration<double, std::ratio<3600>> hours = Clock::now() - begun_;
    return wanted_.hours > 0 && hours.count() >= wanted_.hours;
  }

  void Work() {
    const plcxx::testing_support::TemporaryDirectory directory;
    const std::string now = directory.path().string() + "/now", waiting = directory.path().string() + "/waiting";
    std::array<std::vector<Waiting>, 3> queues;
    for (uint64_t next = next_++; !TimeIsOver(); next = next_++) {
      const size_t dialect = next % dialects_.size();
      const uint64_t number = next / dialects_.size();
      if (wanted_.programs != 0 && number >= wanted_.programs) break;
      std::filesystem::remove_all(now);
      std::filesystem::create_directories(now);
      const std::optional<RandomProgram> program = One(dialect, number, now);
      if (!program) continue;
      for (size_t share = 0; share < queues.size(); ++share) {
        const uint64_t one_in = wanted_.one_in[share];
        // Not the same programs for all: each share has its own.
        if (one_in == 0 || (number + share) % one_in != 0) continue;
        const std::string name = std::string(dialects_[dialect]->name) + "_" + std::to_string(SeedOf(number));
        JudgedProgram judged{waiting + "/" + std::string(kShareNames[share]) + "/" + name,
                             std::string(dialects_[dialect]->name), *program};
        Write(judged.program, judged.dialect, judged.folder);
        queues[share].push_back({dialect, SeedOf(number), std::move(judged)});
        if (queues[share].size() == kTogether) Flush(static_cast<Share>(share), queues[share]);
      }
    }
    for (size_t share = 0; share < queues.size(); ++share) Flush(static_cast<Share>(share), queues[share]);
  }

  uint64_t SeedOf(uint64_t number) const { return (wanted_.seed << 32) + number; }

  static void Write(const RandomProgram& program, const std::string& dialect, const std::string& folder) {
    std::filesystem::create_directories(folder);
    for (const RenderedFile& file : Render(program, dialect)) {
      std::ofstream(folder + "/" + file.name, std::ios::binary) << file.text;
    }
  }

  /// One line a minute, of what was judged so far.
  void SayHowFar(const std::stop_token& ended) {
    std::mutex alone;
    std::condition_variable_any woken;
    std::unique_lock waiting(alone);
    for (;;) {
      woken.wait_for(waiting, ended, kBetweenLines, [] { return false; });
      if (ended.stop_requested()) return;
      const std::lock_guard lock(mutex_);
      uint64_t programs = 0, disagreements = 0;
      std::array<uint64_t, 3> shares = {};
      for (const Tally& tally : tallies_) {
        programs += tally.programs;
        disagreements += tally.disagreements;
        for (size_t share = 0; share < shares.size(); ++share) shares[share] += tally.shares[share].programs;
      }
      const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(Clock::now() - begun_).count();
      std::cout << minutes << " min: " << programs << " programs, " << shares[0] << " compiled, " << shares[1]
                << " emulated, " << shares[2] << " verified, " << disagreements << " disagreements" << std::endl;
    }
  }

  void Flush(Share share, std::vector<Waiting>& queue) {
    std::vector<JudgedProgram> programs;
    for (const Waiting& waiting : queue) programs.push_back(waiting.judged);
    ShareCounts counts;
    const std::vector<Disagreement> found =
        programs.empty() || IsStopped() ? std::vector<Disagreement>() : Judge(share, programs, wanted_.judges, counts);
    if (IsStopped()) return queue.clear();  // the judge, if there was one, was ended in the middle
    {
      const std::lock_guard lock(mutex_);
      for (const Waiting& waiting : queue) ++tallies_[waiting.dialect].shares[static_cast<size_t>(share)].programs;
      verified_.proved += counts.proved;
      verified_.not_decided += counts.not_decided;
      for (const Disagreement& disagreement : found) ++tallies_[queue[disagreement.program].dialect].disagreements;
    }
    for (const Disagreement& disagreement : found) {
      const Waiting& waiting = queue[disagreement.program];
      const ReferenceDialect& dialect = *dialects_[waiting.dialect];
      const std::string folder = waiting.judged.folder + "_smaller";
      const auto fails = [&](const RandomProgram& less) {
        if (IsStopped()) return false;
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        if (RunRandom(less, dialect, folder).outcome != Outcome::kAgrees) return false;
        ShareCounts unused;
        return !Judge(share, {{folder, waiting.judged.dialect, less}}, wanted_.judges, unused).empty();
      };
      Save(dialect, waiting.seed, Shrink(waiting.judged.program, fails), disagreement.text);
    }
    for (const Waiting& waiting : queue) std::filesystem::remove_all(waiting.judged.folder);
    queue.clear();
  }

  /// The program, where simulator and reference agree about it.
  std::optional<RandomProgram> One(size_t index, uint64_t number, const std::string& directory) {
    const ReferenceDialect& dialect = *dialects_[index];
    Tally& tally = tallies_[index];
    const uint64_t seed = SeedOf(number);
    Random random(seed);
    const bool crossed = wanted_.crossed_every != 0 && number % wanted_.crossed_every == wanted_.crossed_every - 1;
    const bool large = !crossed && number % wanted_.large_every == wanted_.large_every - 1;
    const ProgramSize size = large ? ProgramSize::kLarge : ProgramSize::kSmall;
    const auto make = [&] {
      return crossed ? goldens_[index].Crossed(random) : dialect.generate(random, size, Spelling::kAny);
    };
    RandomProgram program = make();
    if (random.OneIn(kCapriciousOneIn)) program.caprices = random.Next();
    RunResult result = RunRandom(program, dialect, directory);
    // Most changes make an error of a line: another one, until the program runs.
    for (int i = 0; crossed && i < kMostTries && result.outcome == Outcome::kNothingToRun; ++i) {
      program = make();
      result = RunRandom(program, dialect, directory);
    }
    const bool agrees = result.outcome == Outcome::kAgrees;
    const bool spelled = agrees && !crossed && number % 2 == 0;
    const std::string texts = directory + "/spellings";
    const std::string difference = spelled ? DifferentSpellings(dialect, seed, size, texts) : std::string();
    {
      const std::lock_guard lock(mutex_);
      ++tally.programs;
      tally.large += large ? 1 : 0;
      tally.spelled += spelled ? 1 : 0;
      tally.compared += result.compared;
      tally.crossed += crossed ? 1 : 0;
      tally.crossed_ran += crossed && agrees ? 1 : 0;
      // What a change made of a golden program may have errors, and need what the reference passes over.
      tally.refused += !crossed && result.outcome == Outcome::kNothingToRun ? 1 : 0;
      tally.unsupported += !crossed && result.outcome == Outcome::kUnsupported ? 1 : 0;
      if (result.outcome == Outcome::kDisagrees || !difference.empty()) ++tally.disagreements;
    }
    if (!difference.empty()) SaveSpellings(dialect, seed, texts, difference);
    if (agrees) return program;
    if (crossed && result.outcome != Outcome::kDisagrees) return std::nullopt;
    const auto fails = [&](const RandomProgram& less) {
      return !IsStopped() && RunRandom(less, dialect, directory).outcome == result.outcome;
    };
    // A program with errors would be made one without anything.
    const bool runs = result.outcome == Outcome::kDisagrees;
    Save(dialect, seed, runs ? Shrink(program, fails) : program, result.text);
    return std::nullopt;
  }

  /// Both texts are kept as they are: what the shrinker takes away from one would be in the other one.
  void SaveSpellings(const ReferenceDialect& dialect, uint64_t seed, const std::string& texts,
                     const std::string& difference) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    const std::string folder = wanted_.save + "/" + std::string(dialect.name) + "_" + std::to_string(seed);
    std::filesystem::create_directories(folder);
    std::filesystem::copy(texts, folder,
                          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    std::cout << folder << "\n" << difference << std::endl;
  }

  void Save(const ReferenceDialect& dialect, uint64_t seed, const RandomProgram& program, const std::string& text) {
    const std::lock_guard lock(mutex_);
    failed_ = true;
    const std::string folder = wanted_.save + "/" + std::string(dialect.name) + "_" + std::to_string(seed);
    Write(program, std::string(dialect.name), folder);
    std::cout << folder << "\n" << text << std::endl;
  }

  void Print() {
    std::printf("%-8s %9s %7s %8s %9s %9s %9s %9s %9s %16s %14s %8s %12s\n", "dialect", "programs", "large", "spelled",
                "crossed", "(ran)", "compiled", "emulated", "verified", "values compared", "disagreements", "refused",
                "unsupported");
    for (size_t i = 0; i < dialects_.size(); ++i) {
      const Tally& tally = tallies_[i];
      if (tally.refused != 0 || tally.unsupported != 0) failed_ = true;
      std::printf("%-8s %9ju %7ju %8ju %9ju %9ju %9ju %9ju %9ju %16ju %14ju %8ju %12ju\n",
                  std::string(dialects_[i]->name).c_str(), uintmax_t{tally.programs}, uintmax_t{tally.large},
                  uintmax_t{tally.spelled}, uintmax_t{tally.crossed}, uintmax_t{tally.crossed_ran},
                  uintmax_t{tally.shares[0].programs}, uintmax_t{tally.shares[1].programs},
                  uintmax_t{tally.shares[2].programs}, uintmax_t{tally.compared}, uintmax_t{tally.disagreements},
                  uintmax_t{tally.refused}, uintmax_t{tally.unsupported});
    }
    if (wanted_.one_in[static_cast<size_t>(Share::kVerified)] == 0) return;
    std::printf("verify: %ju functions proved, %ju not decided\n", uintmax_t{verified_.proved},
                uintmax_t{verified_.not_decided});
  }

  Wanted wanted_;
  std::vector<const ReferenceDialect*> dialects_;
  std::vector<Goldens> goldens_;  // by dialect; none: nothing is crossed
  std::vector<Tally> tallies_;    // by dialect; guarded by mutex_ while threads run
  ShareCounts verified_;          // functions, of all dialects; guarded likewise
  std::atomic<uint64_t> next_ = 0;
  std::mutex mutex_;
  bool failed_ = false;
  Clock::time_point begun_ = Clock::now();
};

/// Scenario files instead of random programs: a disagreement that was saved, seen again.
int RunScenarios(const std::vector<std::string>& paths) {
  int disagree = 0;
  for (const std::string& path : paths) {
    const auto read = plcxx::scenarios::ReadScenario(path);
    const auto* const scenario = std::get_if<plcxx::scenarios::Scenario>(&read);
    if (scenario == nullptr) throw std::invalid_argument(path + " is no scenario");
    auto compilation = plcxx::compilation::Compile(plcxx::scenarios::RequestOf(*scenario, {}));
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
  app.add_option("--dialect", wanted.dialects, "only these")->allow_extra_args(false);
  app.add_option("--programs", wanted.programs, "of each dialect");
  app.add_option("--hours", wanted.hours, "how long");
  app.add_option("--seed", wanted.seed, "another seed gives other programs");
  app.add_option("--jobs", wanted.jobs, "programs at a time");
  app.add_option("--large-every", wanted.large_every, "one program in N has 150 to 600 statements");
  app.add_option("--crossed-every", wanted.crossed_every, "one program in N is a golden one with changes; 0: none");
  app.add_option("--compiled-every", wanted.one_in[0], "one program in N also as generated C++; 0: none");
  app.add_option("--emulated-every", wanted.one_in[1], "one program in N also on a Cortex-M4 and an rv32imac in QEMU");
  app.add_option("--verified-every", wanted.one_in[2], "one program in N also proved by plcxx verify");
  app.add_option("--plcxx", wanted.judges.plcxx, "the tool that verifies");
  std::vector<std::string> compilers;
  app.add_option("--compiler", compilers, "with its flags: 'g++ -O2'")->allow_extra_args(false);
  app.add_option("--save", wanted.save, "the folder for what disagrees");
  std::string judged;
  app.add_option("--judge", judged, "compiled or emulated: the scenarios there only")
      ->check(CLI::IsMember({"compiled", "emulated"}));
  std::vector<std::string> scenarios;
  app.add_option("scenarios", scenarios, "these instead of random programs");
  CLI11_PARSE(app, argc, argv);
  if (wanted.programs == 0 && wanted.hours == 0) wanted.programs = 200;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::canonical(argv[0], error);
  wanted.judges.soak = error ? argv[0] : self.string();
  if (wanted.judges.plcxx.empty()) wanted.judges.plcxx = (self.parent_path().parent_path() / "bin/plcxx").string();
  if (!compilers.empty()) wanted.judges.compilers = compilers;
  try {
    if (!judged.empty()) {
      return RunJudge(judged == "emulated" ? Share::kEmulated : Share::kCompiled, compilers, scenarios);
    }
    if (!scenarios.empty()) return RunScenarios(scenarios);
    std::signal(SIGINT, [](int) { stopped = 1; });
    std::signal(SIGTERM, [](int) { stopped = 1; });
    // What the judges leave when they are ended goes with it.
    const plcxx::testing_support::TemporaryDirectory directory;
    setenv("TMPDIR", directory.path().c_str(), 1);
    return Soak(wanted).Run();
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << "\n";
    return 2;
  }
}
