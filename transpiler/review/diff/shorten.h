// From a run that shows a difference to a short one: only what the difference needs.
//
// In: both versions, the cells of one item, a run. Out: a run that shows it still. Not its job: finding the first run,
// writing it as a scenario.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/runs.h"

namespace plcxx::review::diff {

class Shortener {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// All but the time outlive the object; after `end` nothing is tried any more.
  Shortener(const DiffSide& old_side, const DiffSide& new_side, const prove::machine::Version& old_version,
            const prove::machine::Version& new_version, std::vector<execute::CellId> old_cells,
            std::vector<execute::CellId> new_cells, Time end)
      : old_side_(old_side),
        new_side_(new_side),
        old_version_(old_version),
        new_version_(new_version),
        old_cells_(std::move(old_cells)),
        new_cells_(std::move(new_cells)),
        end_(end) {}

  /// Whether the item differs behind the last stimulus. Late: it does not.
  bool Shows(const Stimuli& stimuli, Time end) const;
  /// A run that shows it, shortened as far as there is time.
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
  void DropInputs();
  void DropTime();
  void RoundTime();
  /// What two waiting steps set is set at once, and both waits come behind it.
  void JoinWaits();

  const DiffSide& old_side_;
  const DiffSide& new_side_;
  const prove::machine::Version& old_version_;
  const prove::machine::Version& new_version_;
  std::vector<execute::CellId> old_cells_, new_cells_;
  Time end_;
  Stimuli stimuli_;
  size_t tries_ = 0;
};

/// Time that passes in several pieces, with nothing set between them, passes in one.
Stimuli Joined(const Stimuli& stimuli);

}  // namespace plcxx::review::diff
