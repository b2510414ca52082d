// Which ways of searching for runs are taken, and how long each: at little effort the cheap ones, later by turns.
//
// In: two versions, and from round to round which of their locations are still open. Out: the runs that show a
// difference, and the states that the search has come by. Not its job: the ways themselves (runs.h, search.h), making a
// run short.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/review/diff/causes.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/review/diff/search.h"
#include "transpiler/review/diff/turns.h"

namespace plcxx::review::diff {

class RunSearches {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// All outlive the object. `begin`: when the comparison began; nothing is begun after `end`.
  RunSearches(const Named& old_named, const Named& new_named, const prove::diff::Match& match,
              const DiffOptions& options, Time begin, Time end)
      : old_(old_named), new_(new_named), match_(match), options_(options), begin_(begin), end_(end) {}

  /// What a comparison asks of runs, answered by this object, which outlives them.
  prove::diff::SimulatedRuns Answers();
  const RandomRuns& runs() const { return runs_; }
  /// Whether both versions were run beside each other, and differed there.
  bool IsSeen(execute::CellId old_cell) const { return runs_.difference_of.contains(old_cell); }

 private:
  std::vector<execute::CellId> FindDifferent(const prove::diff::Sought& sought, prove::diff::Effort effort,
                                             uint64_t most_ms);
  bool IsSought(execute::CellId old_cell) const;
  void SearchQuickly(const prove::diff::Sought& sought);
  void SearchThoroughly(const prove::diff::Sought& sought);
  /// Once more, for up to `most_ms`.
  void SearchLasting(const prove::diff::Sought& sought, uint64_t most_ms);

  /// Of the open ones those that are sought still.
  std::vector<execute::CellId> Open(const prove::diff::Sought& sought) const;
  bool IsMuchOpen(const prove::diff::Sought& sought) const { return Open(sought).size() > kMostSought; }
  void RunRandom(const std::vector<execute::CellId>& cells, prove::diff::Effort effort, Time end);
  /// Only runs that wait and count.
  void RunWaiting(const std::vector<execute::CellId>& cells, Time end);
  RunRequest RequestOf(const std::vector<execute::CellId>& cells, prove::diff::Effort effort, Time end) const;
  void TakeTurn(Way way, const prove::diff::Sought& sought, Time end);
  void RunWide(const prove::diff::Sought& sought, Time end);
  /// To begin with a wide search executes both versions once more, which is worth it while most of the time is left.
  bool IsWorthExecuting() const;
  /// One part of so many of the comparison's time, from now on.
  Time EndOfShare(uint64_t share) const;
  uint64_t ShareForCounts() const;

  const Named& old_;
  const Named& new_;
  const prove::diff::Match& match_;
  const DiffOptions& options_;
  Time begin_, end_;
  RandomRuns runs_;
  std::optional<DirectedSearch> search_;  // made when something is not proved equal at once
  Turns turns_;
  uint32_t round_ = 0;
  bool scenarios_are_run_ = false;
};

}  // namespace plcxx::review::diff
