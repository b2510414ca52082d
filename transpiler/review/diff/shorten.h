// From a run that shows something to a short one: only what that needs.
//
// In: a run, and whether another one shows it still: a difference of two versions, a fault of one. Out: a run that
// does. Not its job: finding the first run, writing it as a scenario.
#pragma once

#include <chrono>
#include <functional>
#include <utility>
#include <vector>

#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/stimulus.h"

namespace plcxx::review::diff {

class Shortener {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// Whether what is sought is seen after the last stimulus. Late: it is not.
  using Shows = std::function<bool(const Stimuli& stimuli, Time end)>;

  /// After `end` nothing is tried any more.
  Shortener(Shows shows, Time end) : shows_(std::move(shows)), end_(end) {}

  /// A run that shows it, shortened as far as there is time, in a number of tries that has a bound.
  Stimuli Shorten(Stimuli stimuli);

 private:
  bool IsOver() const;
  bool Try(Stimuli shorter);
  /// Whether stimuli_, changed in place, is a run that shows it; of large ones no copy is made.
  bool StillShows();
  template <class Set>
  void DropSets(std::vector<Set>& sets);
  /// The last steps alone, with all that was set before them: mostly they are enough, and cost little.
  void KeepLastSteps();
  void DropSteps();
  /// The first steps where they only let time pass: the first wait behind them takes as long.
  void DropForTime();
  void DropInputs(Stimuli& stimuli);
  void DropTime();
  /// Each wait alone, repeated ones, too.
  void DropWaits(Stimuli& stimuli);
  /// Another time, if that shows it still.
  bool TakeTime(Stimulus& stimulus, const Stimulus& time);
  /// Waits take the shortest round time that shows it still.
  void RoundTime(Stimuli& stimuli);
  /// What two waiting steps set is set at once, and both waits come after it.
  void JoinWaits();

  Shows shows_;
  Time end_;
  Stimuli stimuli_;
  size_t tries_ = 0;
};

/// Whether one of the cells differs after the last stimulus. All but the cells outlive it.
Shortener::Shows ShowsDifference(const DiffSide& old_side, const DiffSide& new_side,
                                 const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                                 std::vector<execute::CellId> old_cells, std::vector<execute::CellId> new_cells);

/// Time that passes in several pieces, with nothing set between them, passes in one.
Stimuli Joined(const Stimuli& stimuli);

}  // namespace plcxx::review::diff
