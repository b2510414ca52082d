// What a check of a property is told and gives: runs, verdicts, options.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/properties/property.h"
#include "transpiler/symbolic/execute/cells.h"

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
  /// Of a machine with slices: asked for what no run has violated, checks it slice by slice within the time.
  std::function<PropertyResult(const Property& property, uint64_t milliseconds)> check_in_slices;
  /// Told what is being done, for a progress line; may be empty.
  std::function<void(const std::string& what)> progress;
  /// Tries runs until one violates the property; may be empty. Not asked with any retentive memory.
  FindRun try_runs;
  /// Likewise, and before those: what the machine shows says more than what no plant does.
  PlantedRuns planted;
  /// Runs the machine as the result's run says: empty when it shows the violation, else why it does not. May be empty.
  std::function<std::string(const Property& property, const PropertyResult& result)> why_not_shown;
};

}  // namespace plcxx::prove::properties
