#include "transpiler/review/properties/run_plans.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "transpiler/ir/constants.h"

namespace plcxx::review::properties {
namespace {

using execute::CellId;

constexpr uint32_t kRandomPeriods = 200;
/// Of runs at a steady pace, shorter ones first; no more periods than this.
constexpr uint64_t kRhythmPasses[] = {100, 400, 100, 1600};
constexpr uint32_t kRhythmPeriods = 60'000;
constexpr int kDisturbedPeriods = 6;
constexpr uint32_t kHoldMs = 30'000;

std::vector<uint64_t> ConstantsOf(const ir::Program& program) {
  std::set<uint64_t> constants;
  ir::ForEachNumber(program, [&constants](uint64_t number) { constants.insert(number); });
  return {constants.begin(), constants.end()};
}

}  // namespace

uint32_t PeriodsOfMs(const scenarios::ProveMachine& machine, uint64_t ms) {
  const uint32_t period_ms = std::max(1U, machine.timing.period_ms);
  return static_cast<uint32_t>(std::clamp<uint64_t>((ms + period_ms - 1) / period_ms, 1, kRunPeriods));
}

RunPlans::RunPlans(const scenarios::ProveMachine& machine, const prove::properties::RunSearch& search,
                   const std::vector<bool>& can_be_set, const std::vector<RunPlan>& known, uint64_t seed)
    : machine_(machine),
      can_be_set_(can_be_set),
      known_(known),
      rhythm_{.words = {},
              .constants = ConstantsOf(machine.compilation.program),
              .pass_periods = std::max(1U, machine.timing.slow_periods)},
      random_(seed) {
  for (const CellId cell : search.inputs) {
    if (!can_be_set_[cell.index]) continue;
    inputs_.push_back(cell);
    if (prove::machine::DirectionOf(machine_.version, cell) == ir::Direction::kInput) of_machine_.push_back(cell);
  }
  for (const CellId cell : search.requests) {
    if (can_be_set_[cell.index]) requests_.push_back(cell);
  }
  FindWords();
}

/// The inputs as words of the program, where all of a word may be set.
void RunPlans::FindWords() {
  for (const CellId cell : inputs_) {
    const auto has_cell = [cell](const std::vector<CellId>& word) {
      return std::ranges::find(word, cell) != word.end();
    };
    if (std::ranges::any_of(rhythm_.words, has_cell)) continue;
    std::vector<CellId> word = scenarios::WordsOf(machine_, {cell}).front().cells;
    const auto is_settable = [this](CellId bit) { return bool{can_be_set_[bit.index]}; };
    if (!std::ranges::all_of(word, is_settable)) word = {cell};
    rhythm_.words.push_back(std::move(word));
  }
}

/// In every other run the control does what it is asked for, after a while or at once.
void RunPlans::AddDoneRequests(int run, RunPlan& plan) {
  if (requests_.empty() || run % 2 == 0) return;
  const uint64_t pause = uint64_t{1} << random_.Next() % 6;
  for (uint32_t period = 2; period <= plan.periods; period += static_cast<uint32_t>(1 + random_.Next() % pause)) {
    for (const CellId cell : requests_) plan.events.push_back({period, cell, false});
  }
  std::ranges::stable_sort(plan.events, {}, &RunEvent::period);
}

RunPlan RunPlans::AtSteadyPace(int run) {
  const uint64_t passes = std::min<uint64_t>(kRhythmPasses[static_cast<size_t>(run) % std::size(kRhythmPasses)],
                                             kRhythmPeriods / rhythm_.pass_periods);
  RunPlan plan = MakeRhythm(rhythm_, passes, random_);
  AddDoneRequests(run, plan);
  return plan;
}

RunPlan RunPlans::Holding(int run) {
  const bool is_short = run < kShortHoldRuns;
  const uint32_t hold = std::min(kRunPeriods, PeriodsOfMs(machine_, kHoldMs));
  RunPlan plan{.events = {}, .periods = is_short ? std::min(hold, kShortHoldPeriods) : hold};
  // Settings that the host might change say little about most machines.
  for (const CellId cell : is_short ? of_machine_ : inputs_) {
    // First all at once.
    const bool value = run == 0 || run == kShortHoldRuns || (random_.Next() >> 7 & 1) != 0;
    if (value) plan.events.push_back({1, cell, true});
  }
  AddDoneRequests(run, plan);
  return plan;
}

/// The machine at work, and then something unexpected.
RunPlan RunPlans::Disturbed() {
  RunPlan plan = known_[random_.Next() % known_.size()];
  plan.periods = static_cast<uint32_t>(1 + random_.Next() % plan.periods);
  std::erase_if(plan.events, [&plan](const RunEvent& event) { return event.period > plan.periods; });
  for (int i = 0; i < kDisturbedPeriods && !inputs_.empty(); ++i) {
    ++plan.periods;
    for (uint64_t changes = 1 + random_.Next() % 3; changes > 0; --changes)
      plan.events.push_back({plan.periods, inputs_[random_.Next() % inputs_.size()], (random_.Next() >> 7 & 1) != 0});
    if (random_.OneIn(3)) plan.periods += static_cast<uint32_t>(random_.Next() % kRandomPeriods);
  }
  return plan;
}

/// Inputs change seldom in some runs and often in others.
RunPlan RunPlans::Changing(int run) {
  const uint64_t one_in = uint64_t{2} << (run % 6), density = 1 + static_cast<uint64_t>(run) % 3;
  RunPlan plan{.events = {}, .periods = kRandomPeriods};
  for (uint32_t period = 1; period <= plan.periods; ++period) {
    for (const CellId cell : run % 4 == 0 ? of_machine_ : inputs_) {
      if (period == 1 || random_.OneIn(one_in)) plan.events.push_back({period, cell, random_.Next() % 4 < density});
    }
    if (random_.OneIn(8)) {
      const auto wait = static_cast<uint32_t>(random_.Next() % kRandomPeriods);
      period += wait;
      plan.periods = std::min(kRunPeriods, plan.periods + wait);
    }
  }
  return plan;
}

RunPlan RunPlans::AtRandom(int run) {
  RunPlan plan = !known_.empty() && run % 2 == 1 ? Disturbed() : Changing(run);
  // Not the same runs in which the known ones are disturbed.
  AddDoneRequests(run / 2, plan);
  return plan;
}

}  // namespace plcxx::review::properties
