#include "transpiler/review/diff/examples.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using std::chrono::steady_clock;

constexpr int kMostExamples = 60;
constexpr uint64_t kExampleShare = 10;  // of the time: for shorter runs
constexpr int kRestShare = 3;           // or of what is left of it, for a busy machine needs longer

/// What a solver says counts when both versions were run. `is_seen`: they were, beside each other in the simulator, and
/// differed.
void KeepWhatWasReplayed(DiffItem& item, bool is_seen) {
  const auto not_decided = [&item](const std::string& reason) {
    item.verdict = ItemVerdict::kUndecided;
    item.reason = reason;
    item.counterexample.reset();
  };
  if (!item.counterexample) {
    if (item.verdict == ItemVerdict::kDifferent && !is_seen)
      not_decided("a run was computed that should show a difference, and could not be repeated");
    return;
  }
  switch (item.counterexample->replay) {
    case Replay::kSideBySide:
    case Replay::kSimulator:
    case Replay::kCompiled:
      // Nobody knows whether the machine comes to a state that is only set.
      if (item.counterexample->from_state) {
        const std::string& steps = item.counterexample->steps;
        not_decided("they differ from a state " + (steps.empty()
                                                       ? "that no scenario can set, and no run to it is known"
                                                       : "to which no run from power-on is known (" + steps + ")"));
      } else {
        item.verdict = ItemVerdict::kDifferent;
      }
      return;
    case Replay::kRefuted:
      not_decided("a run shows a difference that its scenario does not show");
      return;
  }
}

/// Both versions have the same cells of it.
bool IsComparable(const NamedItem& named) {
  return !named.old_cells.empty() && named.old_cells.size() == named.new_cells.size();
}

bool IsShown(const NamedItem& named) {
  if (named.item.declared) return false;
  return (named.item.verdict == ItemVerdict::kDifferent || named.worst->run.has_value()) && IsComparable(named);
}

/// Until when what is done for the items.
struct ExampleTimes {
  steady_clock::time_point shortened;  // runs are made shorter
  steady_clock::time_point shown;      // a run that is known is shown, shortened or not
  steady_clock::time_point reused;     // it is tried what was shown for another item
};

ExampleTimes TimesUntil(steady_clock::time_point end, uint64_t time_ms) {
  const steady_clock::time_point now = steady_clock::now();
  const steady_clock::duration shortening =
      std::max<steady_clock::duration>(std::chrono::milliseconds(time_ms / kExampleShare), (end - now) / kRestShare);
  const auto a_little = std::chrono::milliseconds(time_ms / kExampleShare / 4);
  ExampleTimes times;
  times.shortened = std::min(end, now + shortening);
  times.shown = std::min(end, times.shortened + a_little);
  times.reused = std::min(end, times.shown + a_little);
  return times;
}

}  // namespace

void AddExamples(DiffSide& old_side, DiffSide& new_side, const Named& old_named, const Named& new_named,
                 const prove::diff::Match& match, const RandomRuns& runs, const DiffOptions& options,
                 steady_clock::time_point end, std::vector<NamedItem>& items) {
  const ExampleTimes times = TimesUntil(end, options.time_ms);
  auto waiting = std::ranges::count_if(items, IsShown);
  ExampleBudget budget{.left = kMostExamples,
                       .end = times.shortened,
                       .last_end = times.shown,
                       .all_end = end,
                       .old_program = scenarios::ScenarioProgram(old_side.compilation),
                       .new_program = scenarios::ScenarioProgram(new_side.compilation)};
  for (NamedItem& named : items) {
    if (named.item.verdict == ItemVerdict::kEqual) continue;
    const steady_clock::time_point now = steady_clock::now();
    const CounterexampleRequest request{.old_version = old_named.version,
                                        .new_version = new_named.version,
                                        .old_words = old_named.words,
                                        .new_words = new_named.words,
                                        .name = named.item.name,
                                        .kind = named.item.kind,
                                        .old_cells = named.old_cells,
                                        .run = named.worst->run,
                                        .runs = runs,
                                        .match = match};
    std::optional<Counterexample>& example = named.item.counterexample;
    if (IsShown(named) && budget.left > 0 && now < times.shown) {
      // Each has its share, and what the ones before it left over.
      budget.end = now + std::max(steady_clock::duration::zero(), times.shortened - now) /
                             std::max<int64_t>(1, std::min<int64_t>(waiting--, budget.left));
      example = FindCounterexample(old_side, new_side, request, options, budget);
    }
    if (IsShown(named) && !example && budget.left > 0 && steady_clock::now() < times.reused) {
      example = FindAmongShown(old_side, new_side, request, options, budget);
    }
    const auto is_run = [&runs](CellId cell) { return runs.difference_of.contains(cell); };
    if (IsComparable(named) && !named.item.declared)
      KeepWhatWasReplayed(named.item, std::ranges::any_of(named.old_cells, is_run));
  }
}

}  // namespace plcxx::review::diff
