#include "transpiler/review/diff/runs.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <utility>

#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/stimuli.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using terms::Random;

constexpr int kMostRuns = 20, kSteps = 60;
constexpr int kSpareRuns = 6;
constexpr uint64_t kRandomShare = 5, kQuickShare = 80;  // of the time: a fifth, an eightieth
constexpr int kQuickRuns = 6, kHoldRuns = 64, kInputDepth = 6;
constexpr uint32_t kLeastPulses = 20;
constexpr uint64_t kWatchedMs = 30'000;  // from power-on

/// The control does what it was asked for now and then: the requests are cleared before some of the steps.
void AddDoneRequests(Random& random, const std::vector<prove::diff::SetCell>& requests, Stimuli& stimuli) {
  for (Stimulus& stimulus : stimuli) {
    for (const prove::diff::SetCell& request : requests) {
      if (random.OneIn(2)) stimulus.inputs.push_back(request);
    }
  }
}

/// Whether now and then nothing happens for a while, so that timers end.
enum class Waits : uint8_t { kNone, kSome };

/// Inputs change seldom in some runs and often in others.
Stimuli MakeStimuli(Random& random, const std::vector<prove::diff::SetCell>& inputs, int run, Waits waits,
                    bool has_fast) {
  const uint64_t one_in = uint64_t{2} << (run % 6);
  const uint64_t density = 1 + static_cast<uint64_t>(run) % 3;  // of ones, in quarters
  Stimuli stimuli;
  for (int step = 0; step < kSteps; ++step) {
    Stimulus stimulus;
    for (prove::diff::SetCell input : inputs) {
      if (step != 0 && !random.OneIn(one_in)) continue;
      input.value = random.Next() % 4 < density ? 1 : 0;
      stimulus.inputs.push_back(input);
    }
    if (waits == Waits::kSome && random.OneIn(8)) {
      stimulus.ms = static_cast<uint32_t>(100 * (1 + random.Next() % 30));
    } else if (has_fast && random.OneIn(6)) {
      stimulus.fast = 1;
    } else {
      stimulus.slow = 1;
    }
    stimuli.push_back(std::move(stimulus));
  }
  return stimuli;
}

/// The inputs from which the cells are computed, over a few statements and scans.
std::vector<prove::diff::SetCell> InputsBehind(const prove::machine::Version& version, std::vector<bool> wanted,
                                               const std::vector<prove::diff::SetCell>& inputs,
                                               CellId prove::diff::SetCell::* cell) {
  const std::vector<StatementAccess> accesses = AccessesOf(version);
  const auto touches = [&wanted](const StatementAccess& access) {
    for (uint32_t i = access.begin; i < access.end; ++i) {
      if (wanted[i]) return true;
    }
    return false;
  };
  for (int depth = 0; depth < kInputDepth; ++depth) {
    std::set<ir::StatementId> writers;
    for (const StatementAccess& access : accesses) {
      if (access.writes && access.statement.valid() && touches(access)) writers.insert(access.statement);
    }
    for (const StatementAccess& access : accesses) {
      if (access.writes || !writers.contains(access.statement)) continue;
      std::fill(wanted.begin() + access.begin, wanted.begin() + access.end, true);
    }
  }
  std::vector<prove::diff::SetCell> behind;
  for (const prove::diff::SetCell& input : inputs) {
    if (wanted[(input.*cell).index]) behind.push_back(input);
  }
  return behind;
}

/// What one version no longer reads decides what the other one does.
std::vector<prove::diff::SetCell> InputsBehindBoth(const RunRequest& request,
                                                   const std::vector<prove::diff::SetCell>& inputs) {
  std::vector<bool> old_wanted(request.old_version.cells.count), new_wanted(request.new_version.cells.count);
  for (const CellId cell : request.cells) {
    old_wanted[cell.index] = true;
    new_wanted[request.match.new_of_old[cell.index].index] = true;
  }
  const std::vector<prove::diff::SetCell> of_old = InputsBehind(request.old_version, std::move(old_wanted), inputs,
                                                                &prove::diff::SetCell::old_cell),
                                          of_new = InputsBehind(request.new_version, std::move(new_wanted), inputs,
                                                                &prove::diff::SetCell::new_cell);
  std::vector<prove::diff::SetCell> behind;
  std::ranges::set_union(of_old, of_new, std::back_inserter(behind), {}, &prove::diff::SetCell::old_cell,
                         &prove::diff::SetCell::old_cell);
  return behind;
}

/// Without memory that the host might write as well, such as data with presets: a random one there hides what differs.
std::vector<prove::diff::SetCell> InputsOfTheMachine(const prove::machine::Version& version,
                                                     std::vector<prove::diff::SetCell> inputs) {
  std::erase_if(inputs, [&version](const prove::diff::SetCell& input) {
    return prove::machine::DirectionOf(version, input.old_cell) != ir::Direction::kInput;
  });
  return inputs;
}

/// The inputs as they stand after so many steps of a run.
std::vector<prove::diff::SetCell> InputsAfter(const Stimuli& stimuli, uint32_t steps) {
  std::map<CellId, prove::diff::SetCell> level;
  for (uint32_t step = 0; step < steps; ++step) {
    for (const prove::diff::SetCell& input : stimuli[step].inputs) level[input.old_cell] = input;
  }
  std::vector<prove::diff::SetCell> inputs;
  for (const auto& [cell, input] : level) inputs.push_back(input);
  return inputs;
}

/// Random runs of both versions beside each other, with what is the same for all of them.
class RandomSearch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// All outlive the object.
  RandomSearch(const DiffSide& old_side, const DiffSide& new_side, const RunRequest& request,
               const DiffOptions& options, RandomRuns& result)
      : old_side_(old_side),
        new_side_(new_side),
        request_(request),
        options_(options),
        result_(result),
        is_quick_(request.effort == prove::diff::Effort::kQuick),
        inputs_(InputsOf(request.old_version, request.new_version, request.match)),
        begin_(std::chrono::steady_clock::now()),
        end_(std::min(request.end,
                      begin_ + std::chrono::milliseconds(options.time_ms / (is_quick_ ? kQuickShare : kRandomShare)))),
        period_ms_(std::max(1U, old_side.compilation.program.schedule.period_ms)),
        random_((is_quick_ ? 0x9E3779B97F4A7C15 : 0xD1B54A32D192ED03) + request.round) {
    for (const CellId cell : prove::diff::MatchedRequests(request.old_version, request.new_version, request.match))
      requests_.push_back({.old_cell = cell, .new_cell = request.match.new_of_old[cell.index]});
    for (const CellId cell : request.cells) pairs_.emplace_back(cell, request.match.new_of_old[cell.index]);
  }

  /// Half of the time for what is needed to start a timer and wait, or to start a counter and count.
  void RunWaiting() {
    const std::vector<prove::diff::SetCell> behind = InputsBehindBoth(request_, inputs_);
    const ChangedConstants changed = FindChangedConstants(request_.old_version, request_.new_version);
    const uint32_t pulses = std::max(kLeastPulses, changed.counts + 2);
    const std::vector<prove::diff::SetCell> machines = InputsOfTheMachine(request_.old_version, behind);
    // Where nothing can be set there is one run, and all that it takes is patience.
    if (behind.empty() && request_.round <= 1) Run(HoldStimuli({}, kMostPatientRun, changed.times_ms));
    if (behind.empty()) return;
    if (request_.waits_only && changed.times_ms.empty() && changed.counts == 0) return;
    const auto first_run = static_cast<int>(request_.round) * kHoldRuns;
    for (int run = first_run; run < first_run + kHoldRuns && !Late(); ++run) {
      if (std::chrono::steady_clock::now() > begin_ + (end_ - begin_) / 2) break;
      const std::vector<prove::diff::SetCell>& set = machines.empty() || run % 4 == 3 ? behind : machines;
      Report("waiting run ", run);
      const bool near = !telling_.empty() && run % 2 == 0;
      RunAndLearn(HoldStimuli(near ? AlmostTheSame(random_, telling_) : RandomInputs(random_, set, run), run,
                              changed.times_ms));
      Report("counting run ", run);
      RunAndLearn(PulseStimuli(random_, set, run, pulses));
    }
  }

  void RunRandom() {
    const bool has_fast =
        prove::machine::HasFastPart(request_.old_version) || prove::machine::HasFastPart(request_.new_version);
    const std::vector<prove::diff::SetCell> of_the_machine = InputsOfTheMachine(request_.old_version, inputs_);
    const std::vector<prove::diff::SetCell>& all_of_the_machine = of_the_machine.empty() ? inputs_ : of_the_machine;
    for (int run = 0; run < (is_quick_ ? kQuickRuns : kMostRuns) && !Late(); ++run) {
      Report("random run ", run);
      // In a large program waiting costs much: the first runs show what differs without.
      const Waits waits = is_quick_ && run < kQuickRuns / 2 ? Waits::kNone : Waits::kSome;
      Run(MakeStimuli(random_, run % 3 == 2 ? inputs_ : all_of_the_machine, run, waits, has_fast));
    }
  }

 private:
  /// Both versions in one run.
  struct Both {
    DiffMachine old_machine, new_machine;
    uint64_t periods = 0;

    bool Differs(const std::pair<CellId, CellId>& pair) const {
      return old_machine.Seen(pair.first) != new_machine.Seen(pair.second);
    }
  };

  bool Late() const { return std::chrono::steady_clock::now() >= end_ || spare_ <= 0; }

  void Report(const char* what, int run) const {
    if (options_.progress) options_.progress(what + std::to_string(run + 1));
  }

  /// False: a version is stuck, or it is late.
  bool Apply(const Stimulus& stimulus, Both& both) const {
    if (!both.old_machine.Apply(stimulus, &prove::diff::SetCell::old_cell)) return false;
    if (!both.new_machine.Apply(stimulus, &prove::diff::SetCell::new_cell)) return false;
    both.old_machine.Look();
    both.new_machine.Look();
    both.periods += stimulus.slow + stimulus.ms / period_ms_;
    return true;
  }

  /// Shorter runs are better ones.
  void Add(CellId cell, const RandomRuns::Difference& difference) {
    const auto [at, added] = result_.difference_of.try_emplace(cell, difference);
    if (!added && difference.periods < at->second.periods) at->second = difference;
  }

  /// What differs for a moment only is seen by looking after every period of a step. `rest` becomes what is left of the
  /// step. False as Apply.
  bool WatchPeriods(const Stimuli& stimuli, uint32_t step, Stimulus& rest, Both& both) {
    const uint32_t all_ms = stimuli[step].ms;
    for (uint32_t passed_ms = period_ms_; passed_ms < all_ms && !Late(); passed_ms += period_ms_) {
      rest.ms = period_ms_;
      if (!Apply(rest, both)) return false;
      rest = {.inputs = {}, .words = {}, .slow = 0, .ms = all_ms - passed_ms};
      std::optional<RandomRuns::Difference> here;
      for (const std::pair<CellId, CellId>& pair : pairs_) {
        if (result_.difference_of.contains(pair.first) || !both.Differs(pair)) continue;
        if (!here) {
          here = {.run = static_cast<uint32_t>(result_.runs.size()), .steps = step + 1, .periods = both.periods};
          result_.runs.emplace_back(stimuli.begin(), stimuli.begin() + step + 1).back().ms = passed_ms;
        }
        Add(pair.first, *here);
      }
    }
    return true;
  }

  void Run(Stimuli stimuli) {
    AddDoneRequests(random_, requests_, stimuli);
    Both both{.old_machine = DiffMachine(old_side_, request_.old_version, end_),
              .new_machine = DiffMachine(new_side_, request_.new_version, end_)};
    const auto run = static_cast<uint32_t>(result_.runs.size());
    result_.runs.push_back(stimuli);
    for (uint32_t step = 0; step < stimuli.size() && !Late(); ++step) {
      Stimulus rest = stimuli[step];
      // As long as that does not take long.
      const bool watches = !is_quick_ && both.periods * period_ms_ < kWatchedMs;
      if (watches && !WatchPeriods(stimuli, step, rest, both)) return;
      if (Late() || !Apply(rest, both)) break;
      for (const std::pair<CellId, CellId>& pair : pairs_) {
        if (both.Differs(pair)) Add(pair.first, {.run = run, .steps = step + 1, .periods = both.periods});
      }
    }
    const auto is_found = [&](const auto& pair) { return result_.difference_of.contains(pair.first); };
    if (!is_quick_ && std::ranges::all_of(pairs_, is_found)) --spare_;
  }

  /// Near the inputs with which something was seen there is more to be seen: what follows from it.
  void RunAndLearn(const Stimuli& stimuli) {
    const size_t seen = result_.difference_of.size();
    const auto first_run = static_cast<uint32_t>(result_.runs.size());
    Run(stimuli);
    if (result_.difference_of.size() == seen) return;
    for (const auto& [cell, difference] : result_.difference_of) {
      if (difference.run >= first_run) telling_ = InputsAfter(result_.runs[difference.run], difference.steps);
    }
  }

  const DiffSide& old_side_;
  const DiffSide& new_side_;
  const RunRequest& request_;
  const DiffOptions& options_;
  RandomRuns& result_;
  bool is_quick_;
  std::vector<prove::diff::SetCell> inputs_;
  Time begin_, end_;
  uint32_t period_ms_;
  Random random_;
  std::vector<prove::diff::SetCell> requests_;
  std::vector<std::pair<CellId, CellId>> pairs_;  // that are looked at, old and new
  std::vector<prove::diff::SetCell> telling_;     // the inputs when something was seen the last time
  int spare_ = kSpareRuns;                        // some more runs than needed: a shorter one may come
};

}  // namespace

std::vector<prove::diff::SetCell> InputsOf(const prove::machine::Version& old_version,
                                           const prove::machine::Version& new_version,
                                           const prove::diff::Match& match) {
  const prove::machine::Uses old_uses = prove::machine::UsesOf(old_version),
                             new_uses = prove::machine::UsesOf(new_version);
  std::vector<prove::diff::SetCell> inputs;
  for (uint32_t i = 0; i < old_version.cells.calls; ++i) {
    const CellId old_cell(i), new_cell = match.new_of_old[i];
    if (match.starts_otherwise[i] || !new_cell.valid() || !(old_uses.reads[i] || new_uses.reads[new_cell.index]))
      continue;
    if (prove::diff::IsInputPair(old_version, new_version, old_uses, new_uses, match, old_cell)) {
      inputs.push_back({.old_cell = old_cell, .new_cell = new_cell});
    }
  }
  return inputs;
}

void RunBoth(const DiffSide& old_side, const DiffSide& new_side, const RunRequest& request, const DiffOptions& options,
             RandomRuns& result) {
  const bool is_quick = request.effort == prove::diff::Effort::kQuick;
  if (!is_quick && request.cells.size() > kMostSought) return;  // what a change induces that reaches everything
  RandomSearch search(old_side, new_side, request, options, result);
  if (!is_quick) search.RunWaiting();
  if (!request.waits_only) search.RunRandom();
}

}  // namespace plcxx::review::diff
