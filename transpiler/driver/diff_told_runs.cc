#include "transpiler/driver/diff_told_runs.h"

#include <algorithm>

namespace plcxx::driver {
namespace {

using review::diff::Counterexample;
using review::diff::DiffItem;

/// Runs of one group that are shown; each location has one in JSON and among the written scenarios.
constexpr size_t kMostRunsTold = 8;
/// A shorter run is read more easily than what it has in common with another one.
constexpr size_t kLeastShared = 40;

std::string RestOfRuns(size_t count) {
  return "and " + std::to_string(count) + " more, each with a run of its own in --format json and --counterexamples";
}

bool IsShownAlike(const Counterexample& one, const Counterexample& other) {
  return one.steps == other.steps && one.old_value == other.old_value && one.new_value == other.new_value &&
         one.from_state == other.from_state && one.replay == other.replay && !one.steps.empty();
}

std::string ResultOfRun(const Counterexample& example) {
  std::string text = example.old_value == example.new_value
                         ? "the calls differ"
                         : example.old_value + " in the old version, " + example.new_value + " in the new one";
  if (example.from_state) text += " (from this state; no run from power-on to it is known)";
  if (example.replay == review::diff::Replay::kSideBySide)
    text += " (both versions beside each other; not as a scenario)";
  return text;
}

}  // namespace

std::string ToldRuns::StepsOf(const Counterexample& example, const std::string& name) {
  const std::string& steps = example.steps;
  if (steps.empty()) return "a run that no scenario can say";
  const Told* begin = nullptr;
  for (const Told& told : told_) {
    if (told.steps == steps) {
      const bool is_last = told_.size() > of_this_group_ && &told == &told_.back();
      return is_last ? "after the same run" : "after the run of " + told.name;
    }
    const bool begins_with_it = told.steps.size() >= kLeastShared && steps.starts_with(told.steps + ", ");
    if (begins_with_it && (begin == nullptr || begin->steps.size() < told.steps.size())) begin = &told;
  }
  const std::string text =
      begin == nullptr ? steps : "after the run of " + begin->name + ", then " + steps.substr(begin->steps.size() + 2);
  told_.push_back({.steps = steps, .name = name});
  return text;
}

std::vector<std::string> ToldRuns::Of(const review::diff::DiffGroup& group) {
  of_this_group_ = told_.size();
  std::vector<const DiffItem*> shown;
  std::ranges::copy_if(group.items, std::back_inserter(shown),
                       [](const DiffItem* item) { return item->counterexample.has_value(); });
  std::vector<std::string> lines;
  for (size_t i = 0; i < shown.size();) {
    if (lines.size() == kMostRunsTold) {
      lines.push_back(RestOfRuns(shown.size() - i));
      break;
    }
    const Counterexample& example = *shown[i]->counterexample;
    std::vector<std::string> names;
    const std::string& first = shown[i]->name;
    for (; i < shown.size() && (names.empty() || IsShownAlike(example, *shown[i]->counterexample)); ++i)
      names.push_back(shown[i]->name);
    lines.push_back((group.items.size() == 1 ? std::string() : review::diff::NamesAsRanges(names) + ": ") +
                    StepsOf(example, first) + ": " + ResultOfRun(example));
  }
  return lines;
}

}  // namespace plcxx::driver
