// Does a property hold after every period, for all inputs and all answers of the host?
//
// Runs from power-on are searched, one period deeper each time, for one that violates it. Between two depths
// k-induction is tried: from any state, k periods without a violation are followed by another one. When that fails,
// invariants of the program are found and proved (prove/invariants) and assumed, then those that the property asks
// for (reachable.h). The slow part is one piece here, however it is sliced. In: a structured program, a property. Out:
// a verdict. Not its job: words about it, replaying runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/prove/invariants/invariants.h"
#include "transpiler/prove/machine/unroll.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/prove/properties/reachable.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::properties {

enum class RetentiveMemory : uint8_t { kZero, kAny };

struct InputValue {
  execute::CellId cell;
  bool value = false;
};

/// A run from power-on: inputs that are set before each part of each period, and requests that are taken back. All
/// inputs that matter are set in the first part; later only those that change.
struct PropertyRun {
  bool has_plant = false;  // the plant moves in it, and drives inputs that are not named here
  /// Stored memory, and what the program reads when power comes: set before a power cycle; what is not named is 0.
  std::vector<InputValue> before_power_on;
  std::vector<std::vector<std::vector<InputValue>>> periods;
};

/// Runs that are tried instead of computed.
struct RunSearch {
  const Property* property = nullptr;
  std::vector<execute::CellId> inputs;    // on which the property depends, the nearest first
  std::vector<execute::CellId> requests;  // bits on which it depends and that the control takes back when it likes
  uint64_t milliseconds = 0;
  bool thorough = false;  // take all of the time
  /// A run without the plant that violates it: what it sets is worth trying with the plant. May be null.
  const PropertyRun* similar = nullptr;
  bool only_similar = false;
};

using FindRun = std::function<std::optional<PropertyRun>(const RunSearch& search)>;

/// Runs of a machine whose plant moves: they are among those of all inputs, and nothing is proved by them.
struct PlantedRuns {
  FindRun try_runs;                    // empty: there is no plant
  std::vector<execute::CellId> reads;  // on what the plant depends
};

enum class PropertyVerdict : uint8_t { kProved, kViolated, kUndecided };

struct PropertyResult {
  PropertyVerdict verdict = PropertyVerdict::kUndecided;
  uint32_t periods = 0;            // kProved: k; kViolated: of the run
  uint32_t searched = 0;           // no run of so many periods violates it
  uint32_t invariants = 0;         // that the proof assumes, all of them proved
  std::string reason;              // of kUndecided; lower case, no full stop
  std::optional<PropertyRun> run;  // of kViolated; of kUndecided one that the machine does not show
  std::string remark;              // why the verdict may say little; lower case, no full stop
  bool stuck_at = false;           // kViolated of kNeverStuck: what the output is behind the run, and stays
  uint32_t replay = 0;             // where there is a run: which of those of this check that were asked why, from 0
};

struct CheckOptions {
  uint64_t time_ms = 60'000;   // for one property
  uint32_t most_periods = 50;  // of runs from power-on that are computed, and of k
  RetentiveMemory retentive = RetentiveMemory::kZero;
  bool only_runs = false;  // only runs that violate it are wanted: no proof is tried
  uint32_t slices = 1;     // of the slow part in the machine; here it is one piece
  /// Told what is being done, for a progress line; may be empty.
  std::function<void(const std::string& what)> progress;
  /// Tries runs until one violates the property; may be empty. Not asked with any retentive memory.
  FindRun try_runs;
  /// Likewise, and before those: what the machine shows says more than what no plant does.
  PlantedRuns planted;
  /// Runs the machine as the result's run says: empty when it shows the violation, else why it does not. May be empty.
  std::function<std::string(const Property& property, const PropertyResult& result)> why_not_shown;
};

class WideSearch;

/// Checks the properties of one program one after the other; what they share is executed once.
class PropertyChecker {
 public:
  /// `version` outlives it. Without a solver every check is refused.
  PropertyChecker(const machine::Version& version, CheckOptions options);
  ~PropertyChecker();

  /// Not empty: nothing can be checked, and why.
  const std::string& refusal() const { return refusal_; }
  PropertyResult Check(const Property& property);

 private:
  PropertyResult CheckInTime(const Property& property);
  /// Whether the property depends on what the fast part makes of more than inputs: in slices it runs in each of them.
  bool DependsOnFastPart(const Property& property);
  /// Whether a proved property says little: it speaks of what nothing changes, or of a case that does not come.
  std::string RemarkOn(const Property& property);
  /// Whether a violated property speaks of an output that no statement writes: the run sets it like an input.
  std::string RemarkOnOutputs(const Property& property) const;
  uint32_t RestMs() const;
  bool Late() const { return RestMs() == 0; }
  void Report(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }
  ValueAfter ValuesOf(machine::Unrolled& unrolled);

  /// Whether this is the end of the check: `result` has a verdict or a reason.
  bool Extend(machine::Unrolled& unrolled, uint32_t periods, PropertyResult& result);
  /// That what the host may write beside inputs of the machine stays as it is behind power-on.
  std::vector<terms::TermId> StaysQuiet(machine::Unrolled& unrolled, uint32_t periods);
  bool SearchRuns(const Property& property, uint32_t period, PropertyResult& result);
  bool TryRuns(const Property& property, uint64_t milliseconds, bool thorough, PropertyResult& result);
  /// Many of them side by side; what is found counts when it was repeated.
  bool TryWideRuns(const Property& property, uint64_t milliseconds, PropertyResult& result);
  bool TryPlantedRuns(const Property& property, RunSearch search, PropertyResult& result);
  bool TryFound(const Property& property, std::optional<PropertyRun> run, PropertyResult& result);
  /// A run without the plant violates it: one with the plant takes its place where a short search finds one.
  void PreferPlanted(const Property& property, PropertyResult& result);
  /// Inputs and requests on which the cells depend.
  void AddInputsBehind(const std::vector<execute::CellId>& cells, RunSearch& search);
  /// A run has been found: whether the machine shows it.
  void Conclude(const Property& property, PropertyResult found, terms::TermId violated, PropertyResult& result);
  bool TryInduction(const Property& property, uint32_t k, PropertyResult& result);
  // By facts about the reachable states (check_reachable.cc).
  bool TryReachable(const Property& property, PropertyResult& result);
  /// Only what is proved in so short a time counts.
  bool TryReachableFor(uint32_t milliseconds, const Property& property, PropertyResult& result);
  /// Whether no reachable state, after whole periods, is bad; `bad` is over the variables of Widest() and those of
  /// `more`. Counts the facts.
  bool IsNeverReached(terms::TermId bad, const std::function<std::optional<StateWord>(terms::TermId variable)>& more,
                      PropertyResult& result);
  bool IsNeverReached(const ReachQuestion& question, PropertyResult& result);
  ReachQuestion QuestionOf(terms::TermId bad,
                           const std::function<std::optional<StateWord>(terms::TermId variable)>& more);
  // By counting periods (check_counting.cc).
  bool TryCounting(const Property& property, PropertyResult& result);
  /// The same within a part of the time that is left.
  bool TryCountingIn(uint32_t milliseconds, const Property& property, PropertyResult& result);
  /// Numbers of the program in some cells, the nearest ones first: fields, and what places of whole bytes name.
  std::vector<std::vector<execute::CellId>> NumbersAmong(const std::vector<execute::CellId>& cells) const;
  void FindInvariantsFor(const Property& property);
  void FindInvariantsAround(const std::vector<execute::CellId>& cells);
  PropertyRun RunOf(machine::Unrolled& unrolled, terms::TermId violated, uint32_t periods);
  std::vector<InputValue> RetentiveOf(const Cone& cone);
  std::vector<InputValue> BeforePowerOn(machine::Unrolled& unrolled, const Cone& cone);
  /// Whether what the program begins with depends on what the host answers and writes at power-on.
  bool DependsOnPowerOn() const;
  /// What the solver answers; kUnknown, too, when the question is so large that it would not come to an answer.
  solver::Answer Ask(std::span<const terms::TermId> conditions, uint32_t milliseconds);
  std::string WhyUnknown() const;
  machine::Relation& Widest() const { return any_ ? *any_ : *silent_; }
  /// From power-on, all that may happen.
  machine::Unrolled& Base() const { return answered_ ? *answered_ : *plain_; }

  // "is never stuck" (stuck.cc).
  /// Values of inputs, by period, part and cell; what is not in them is 0.
  using Strategy = std::vector<std::vector<std::map<execute::CellId, uint64_t>>>;
  struct StuckSearch {
    const Property& property;
    bool wanted;  // the value that the output is to reach
    std::vector<Strategy> strategies;
    /// A state from which no inputs reach it; by cell, what is not in it is 0.
    std::map<execute::CellId, uint64_t> stuck;
  };
  enum class Reach : uint8_t { kAlways, kStuck, kUnknown };
  PropertyResult CheckNeverStuck(const Property& property);
  Reach ReachFromAnywhere(StuckSearch& search, PropertyResult& result);
  Reach ReachAfter(StuckSearch& search, uint32_t period, PropertyResult& result);
  Reach FindStrategy(StuckSearch& search, const std::map<execute::CellId, uint64_t>& state, uint64_t time,
                     PropertyResult& result);
  bool IsNeverStuck(const StuckSearch& search, PropertyResult& result);
  std::optional<terms::TermId> Reached(const StuckSearch& search, const Strategy& strategy, machine::Unrolled& from,
                                       uint32_t period, PropertyResult& result);

  const machine::Version& version_;
  CheckOptions options_;
  terms::Terms terms_;
  std::unique_ptr<solver::Solver> solver_;
  std::string refusal_;
  std::vector<bool> inputs_;
  std::vector<bool> requests_;                 // by cell: see machine/requests.h
  std::vector<bool> new_each_time_;            // by cell: inputs, and the operator's texts
  std::unique_ptr<machine::Relation> silent_;  // the host answers 0
  std::unique_ptr<machine::Relation> any_;     // it answers anything; none where that makes no difference
  std::unique_ptr<machine::Unrolled> plain_;   // from power-on, the host answers 0
  std::unique_ptr<machine::Unrolled>
      answered_;  // from power-on, the host answers anything; none where that makes no difference
  std::unique_ptr<machine::Unrolled> anywhere_;   // from any state
  std::optional<machine::Transition> fast_part_;  // alone, over the variables of Widest(), once it was needed
  std::unique_ptr<WideSearch> wide_;              // of the present check, once it was needed
  uint32_t not_repeated_ = 0;                     // runs of it
  std::vector<invariants::Invariant> invariants_;
  bool too_large_ = false;  // the last question was not asked
  uint32_t replays_ = 0;    // runs of this check that were asked why they are not shown
  std::chrono::steady_clock::time_point deadline_;
};

}  // namespace plcxx::prove::properties
