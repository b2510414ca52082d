#include "transpiler/review/diff/runs.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <utility>

#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/search.h"
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
  const prove::machine::Version& old_version = request.old_version;
  const prove::machine::Version& new_version = request.new_version;
  const bool quick = request.effort == prove::diff::Effort::kQuick;
  if (!quick && request.cells.size() > kMostSought) return;  // what a change induces that reaches everything
  const std::vector<prove::diff::SetCell> inputs = InputsOf(old_version, new_version, request.match);
  std::vector<prove::diff::SetCell> requests;
  for (const CellId cell : prove::diff::MatchedRequests(old_version, new_version, request.match))
    requests.push_back({.old_cell = cell, .new_cell = request.match.new_of_old[cell.index]});
  std::vector<std::pair<CellId, CellId>> pairs;
  for (const CellId cell : request.cells) pairs.emplace_back(cell, request.match.new_of_old[cell.index]);
  const auto begin = std::chrono::steady_clock::now();
  const auto end =
      std::min(request.end, begin + std::chrono::milliseconds(options.time_ms / (quick ? kQuickShare : kRandomShare)));
  const uint32_t period_ms = std::max(1U, old_side.compilation.program.schedule.period_ms);
  // Some more runs than needed: a shorter one may come.
  int spare = kSpareRuns;
  const auto late = [&] { return std::chrono::steady_clock::now() >= end || spare <= 0; };
  const bool has_fast = prove::machine::HasFastPart(old_version) || prove::machine::HasFastPart(new_version);
  Random random((quick ? 0x9E3779B97F4A7C15 : 0xD1B54A32D192ED03) + request.round);
  const auto run_both = [&](Stimuli stimuli) {
    AddDoneRequests(random, requests, stimuli);
    DiffMachine old_machine(old_side, old_version, end), new_machine(new_side, new_version, end);
    const auto run = static_cast<uint32_t>(result.runs.size());
    result.runs.push_back(stimuli);
    uint64_t periods = 0;
    // Shorter runs are better ones.
    const auto add = [&](CellId cell, const RandomRuns::Difference& difference) {
      const auto [at, added] = result.difference_of.try_emplace(cell, difference);
      if (!added && difference.periods < at->second.periods) at->second = difference;
    };
    for (uint32_t step = 0; step < stimuli.size() && !late(); ++step) {
      const Stimulus& stimulus = stimuli[step];
      uint32_t passed_ms = 0;
      const auto apply = [&](const Stimulus& piece) {
        if (!old_machine.Apply(piece, &prove::diff::SetCell::old_cell)) return false;
        if (!new_machine.Apply(piece, &prove::diff::SetCell::new_cell)) return false;
        old_machine.Look();
        new_machine.Look();
        periods += piece.slow + piece.ms / period_ms;
        passed_ms += piece.ms;
        return true;
      };
      // What differs for a moment only is seen by who looks after every period, as long as that does not take long.
      const bool watches = !quick && periods * period_ms < kWatchedMs;
      Stimulus piece = stimulus;
      while (watches && passed_ms + period_ms < stimulus.ms && !late()) {
        piece.ms = period_ms;
        if (!apply(piece)) return;
        piece = {.inputs = {}, .words = {}, .slow = 0, .ms = stimulus.ms - passed_ms};
        std::optional<RandomRuns::Difference> here;
        for (const auto& [old_cell, new_cell] : pairs) {
          if (result.difference_of.contains(old_cell)) continue;
          if (old_machine.Seen(old_cell) == new_machine.Seen(new_cell)) continue;
          if (!here) {
            here = {.run = static_cast<uint32_t>(result.runs.size()), .steps = step + 1, .periods = periods};
            result.runs.emplace_back(stimuli.begin(), stimuli.begin() + step + 1).back().ms = passed_ms;
          }
          add(old_cell, *here);
        }
      }
      if (late() || !apply(piece)) break;
      for (const auto& [old_cell, new_cell] : pairs) {
        if (old_machine.Seen(old_cell) == new_machine.Seen(new_cell)) continue;
        add(old_cell, {.run = run, .steps = step + 1, .periods = periods});
      }
    }
    if (quick) return;
    const auto differs = [&](const auto& pair) { return result.difference_of.contains(pair.first); };
    if (std::ranges::all_of(pairs, differs)) --spare;
  };
  std::vector<prove::diff::SetCell> behind;
  if (!quick) behind = InputsBehindBoth(request, inputs);
  // Half of the time for what is needed to start a timer and wait, or to start a counter and count.
  const ChangedConstants changed = quick ? ChangedConstants() : FindChangedConstants(old_version, new_version);
  const uint32_t pulses = std::max(kLeastPulses, changed.counts + 2);
  const std::vector<prove::diff::SetCell> machines = InputsOfTheMachine(old_version, behind);
  // Near the inputs with which something was seen there is more to be seen: what follows from it.
  std::vector<prove::diff::SetCell> telling;
  const auto run_and_learn = [&](const Stimuli& stimuli) {
    const size_t seen = result.difference_of.size();
    const auto first_run = static_cast<uint32_t>(result.runs.size());
    run_both(stimuli);
    if (result.difference_of.size() == seen) return;
    for (const auto& [cell, difference] : result.difference_of) {
      if (difference.run >= first_run) telling = InputsAfter(result.runs[difference.run], difference.steps);
    }
  };
  // Where nothing can be set there is one run, and all that it takes is patience.
  if (!quick && behind.empty() && request.round <= 1) run_both(HoldStimuli({}, kMostPatientRun, changed.times_ms));
  if (request.waits_only && changed.times_ms.empty() && changed.counts == 0) return;
  const auto first_run = static_cast<int>(request.round) * kHoldRuns;
  for (int run = first_run; !quick && run < first_run + kHoldRuns && !behind.empty() && !late(); ++run) {
    if (std::chrono::steady_clock::now() > begin + (end - begin) / 2) break;
    const std::vector<prove::diff::SetCell>& set = machines.empty() || run % 4 == 3 ? behind : machines;
    if (options.progress) options.progress("waiting run " + std::to_string(run + 1));
    const bool near = !telling.empty() && run % 2 == 0;
    run_and_learn(
        HoldStimuli(near ? AlmostTheSame(random, telling) : RandomInputs(random, set, run), run, changed.times_ms));
    if (options.progress) options.progress("counting run " + std::to_string(run + 1));
    run_and_learn(PulseStimuli(random, set, run, pulses));
  }
  if (request.waits_only) return;
  const std::vector<prove::diff::SetCell> of_the_machine = InputsOfTheMachine(old_version, inputs);
  const std::vector<prove::diff::SetCell>& all_of_the_machine = of_the_machine.empty() ? inputs : of_the_machine;
  for (int run = 0; run < (quick ? kQuickRuns : kMostRuns) && !late(); ++run) {
    if (options.progress) options.progress("random run " + std::to_string(run + 1));
    // In a large program waiting costs much: the first runs show what differs without.
    const Waits waits = quick && run < kQuickRuns / 2 ? Waits::kNone : Waits::kSome;
    run_both(MakeStimuli(random, run % 3 == 2 ? inputs : all_of_the_machine, run, waits, has_fast));
  }
}

}  // namespace plcxx::review::diff
