// The search for runs in which two versions differ, from the machine at work towards what was changed.
//
// Both versions run beside each other in the simulator. First come the scenarios that stand beside the old version, as
// they are. Then it goes back again and again to a moment that was seen, and does something unexpected there. Moments
// that are gone back to: those at which something differs already, for more follows from it; those at which what the
// changed statements read was not seen like this before; those at which something that this is computed from has a
// value for the first time, as the step of a sequence that leads there; those between two steps of a scenario. Of each
// such a solver is asked what has to be set there so that a difference is seen within a few periods: that hits what has
// to be set in one scan. In: two versions. Out: a run for each cell that was seen to differ. Not its job: making a run
// short, proofs.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/wide_runs.h"
#include "transpiler/review/diff/counts.h"
#include "transpiler/review/diff/paired_machines.h"
#include "transpiler/review/diff/runs.h"

namespace plcxx::review::diff {

class DirectedSearch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `cells`: of the old version, what is looked at. All outlive the search.
  DirectedSearch(const DiffSide& old_side, const DiffSide& new_side, const prove::machine::Version& old_version,
                 const prove::machine::Version& new_version, const prove::diff::Match& match,
                 const CellWords& old_words, const std::vector<execute::CellId>& cells);

  /// The scenarios, once; `end` is the time for that.
  void RunScenarios(Time end, RandomRuns& result);
  /// Runs that a solver computed, each once: from their ends there is more to be seen.
  void Follow(const std::vector<prove::diff::Run>& computed, Time end, RandomRuns& result);
  /// Until `end`, or until each of `sought` (old cells, those that matter most first) has differed.
  void Run(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// The same with runs that were seen to differ in many lanes at once (prove/diff/wide_runs.h), each repeated here.
  void RunWide(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// The same from the moments that are kept: where that was not done yet each input near the change is changed there,
  /// one by one, and held; then several are, of all moments.
  void RunWideFromMoments(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// Runs that begin with something in memory that is kept without power: to be called when others have shown nothing.
  void BeginWithKept(Time end, RandomRuns& result);
  /// See counts.h.
  void RunCounts(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result) {
    counts_->Run(sought, end, result);
  }
  /// Whether the versions have different constants, so that a limit of a count is another one, perhaps.
  bool has_changed_constants() const { return has_changed_constants_; }
  /// As PairedMachines.
  void ForEachSeenState(prove::diff::Which which,
                        const std::function<void(const prove::invariants::CellValues&, uint64_t now_ms)>& visit) {
    machines_.ForEachSeenState(which, visit);
  }
  void ForEachSeenPair(const std::function<void(const prove::invariants::CellValues& of_old,
                                                const prove::invariants::CellValues& of_new, uint64_t now_ms)>& visit) {
    machines_.ForEachSeenPair(visit);
  }

 private:
  using Moment = PairedMachines::Moment;
  using Moments = PairedMachines::Moments;
  using Kept = PairedMachines::Kept;

  /// The scenarios beside the old version; what has another name in the new version is set by its cells.
  void ReadScenarios();
  void SetKnown(const std::pair<std::string, std::string>& word, Stimulus& stimulus) const;
  /// What decides whether a statement is executed, and what it is computed from, is read with it.
  enum class Reads : uint8_t { kItsOwn, kAllNeeded };
  void FindInputs(Reads reads);
  /// All inputs, as words where they are; gives their cells.
  std::set<execute::CellId> FindWords();
  /// As words, too.
  void FindKept(std::set<execute::CellId> cells);
  void FindConstants();
  prove::diff::WideRuns& Wide();
  Moments& MomentsOf(Kept why) { return machines_.kept_moments(why); }
  /// Goes back to a moment.
  void GoBack();
  Stimulus Unexpected();
  /// A part of all inputs gets other values.
  void DisturbMany(Stimulus& stimulus);
  void Disturb(const Input& input, std::vector<prove::diff::SetCell>& sets);
  /// The next moment of which the solver was not asked yet; null: there is none.
  Moment* NextToAsk();
  /// The next moment at which nobody waited yet, what was kept last first; null: there is none.
  Moment* NextToWait();
  /// Lets time pass there, as timers need it.
  void Wait(Moment& moment, RandomRuns& result);
  /// Asks the solver what has to be set at the moment, and does that.
  void Aim(Moment& moment, const std::vector<execute::CellId>& sought, RandomRuns& result);

  const DiffSide& old_side_;
  const DiffSide& new_side_;
  const prove::machine::Version& old_version_;
  const prove::machine::Version& new_version_;
  const prove::diff::Match& match_;
  const CellWords& old_words_;
  PairedMachines machines_;
  std::vector<execute::CellId> cells_;         // what is looked at
  std::vector<Input> inputs_, behind_, near_;  // all; those after what was changed; those that it reads soon
  std::vector<Input> kept_;  // what the programs write, and keep without power: of it what that is computed from
  std::vector<prove::diff::SetCell> requests_;  // that the control clears
  std::vector<bool> is_settable_;  // by old cell: a scenario may; what one version alone has is nobody else's
  std::vector<uint64_t> constants_;
  bool has_changed_constants_ = false;
  std::vector<uint32_t> waits_ms_;
  std::vector<Stimuli> known_;
  std::optional<Counts> counts_;  // when inputs and constants are known
  std::optional<prove::diff::WideRuns> wide_;
  bool waits_next_ = false;                                              // what was begun is given time
  size_t followed_ = 0;                                                  // computed runs
  std::chrono::steady_clock::duration searched_{}, aimed_{}, waited_{};  // time that each way took
};

}  // namespace plcxx::review::diff
