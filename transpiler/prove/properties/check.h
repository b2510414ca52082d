// Does a property hold after every period, for all inputs and all answers of the host?
//
// Runs from power-on are searched, one period deeper each time, for one that violates it. Between two depths
// k-induction is tried: from any state, k periods without a violation are followed by another one. When that fails,
// invariants of the program are found and proved (compare/invariants.h) and assumed. The slow part is one piece here,
// however it is sliced. In: a structured program, a property. Out: a verdict. Not its job: words about it, replaying
// runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/compare/invariants.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/prove/properties/unroll.h"
#include "transpiler/prove/solver/solver.h"

namespace plcxx::prove {

enum class RetentiveMemory : uint8_t { kZero, kAny };

struct CheckOptions {
  uint64_t time_ms = 60'000;   // for one property
  uint32_t most_periods = 50;  // of runs from power-on, and of k
  RetentiveMemory retentive = RetentiveMemory::kZero;
  /// Told what is being done, for a progress line; may be empty.
  std::function<void(const std::string& what)> progress;
};

struct InputValue {
  CellId cell;
  bool value = false;
};

/// A run from power-on: inputs that are set before each part of each period. All inputs that matter are set in the
/// first part; later only those that change.
struct PropertyRun {
  std::vector<std::vector<std::vector<InputValue>>> periods;
};

enum class PropertyVerdict : uint8_t { kProved, kViolated, kUndecided };

struct PropertyResult {
  PropertyVerdict verdict = PropertyVerdict::kUndecided;
  uint32_t periods = 0;     // kProved: k; kViolated: of the run
  uint32_t searched = 0;    // no run of so many periods violates it
  uint32_t invariants = 0;  // that the proof assumes, all of them proved
  std::string reason;       // of kUndecided; lower case, no full stop
  std::optional<PropertyRun> run;
  bool stuck_at = false;  // kViolated of kNeverStuck: what the output is behind the run, and stays
};

/// Checks the properties of one program one after the other; what they share is executed once.
class PropertyChecker {
 public:
  /// `version` outlives it. Without a solver every check is refused.
  PropertyChecker(const Version& version, CheckOptions options);

  /// Not empty: nothing can be checked, and why.
  const std::string& refusal() const { return refusal_; }
  PropertyResult Check(const Property& property);

 private:
  uint32_t RestMs() const;
  bool Late() const { return RestMs() == 0; }
  void Report(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }
  ValueAfter ValuesOf(Unrolled& unrolled);

  /// Whether this is the end of the check: `result` has a verdict or a reason.
  bool Extend(Unrolled& unrolled, uint32_t periods, PropertyResult& result);
  bool SearchRuns(const Property& property, uint32_t period, PropertyResult& result);
  bool TryInduction(const Property& property, uint32_t k, PropertyResult& result);
  void FindInvariantsFor(const Property& property);
  void FindInvariantsAround(const std::vector<CellId>& cells);
  PropertyRun RunOf(Unrolled& unrolled, TermId violated, uint32_t periods);

  // "is never stuck" (stuck.cc).
  /// Values of inputs, by period, part and cell; what is not in them is 0.
  using Strategy = std::vector<std::vector<std::map<CellId, uint64_t>>>;
  struct StuckSearch {
    const Property& property;
    bool wanted;  // the value that the output is to reach
    std::vector<Strategy> strategies;
    /// A state from which no inputs reach it; by cell, what is not in it is 0.
    std::map<CellId, uint64_t> stuck;
  };
  enum class Reach : uint8_t { kAlways, kStuck, kUnknown };
  PropertyResult CheckNeverStuck(const Property& property);
  Reach ReachFromAnywhere(StuckSearch& search, PropertyResult& result);
  Reach ReachAfter(StuckSearch& search, uint32_t period, PropertyResult& result);
  Reach FindStrategy(StuckSearch& search, const std::map<CellId, uint64_t>& state, uint64_t time,
                     PropertyResult& result);
  std::optional<TermId> Reached(const StuckSearch& search, const Strategy& strategy, Unrolled& from, uint32_t period,
                                PropertyResult& result);

  const Version& version_;
  CheckOptions options_;
  Terms terms_;
  std::unique_ptr<Solver> solver_;
  std::string refusal_;
  std::vector<bool> inputs_;
  bool answers_matter_ = false;
  std::unique_ptr<Unrolled> plain_;     // from power-on, the host answers 0
  std::unique_ptr<Unrolled> answered_;  // from power-on, the host answers anything; none where that makes no difference
  std::unique_ptr<Unrolled> anywhere_;  // from any state
  std::vector<Invariant> invariants_;
  std::chrono::steady_clock::time_point deadline_;
};

}  // namespace plcxx::prove
