// Does a property hold after every period, for all inputs and all answers of the host?
//
// Runs from power-on are searched, one period deeper each time, for one that violates it. Between two depths
// k-induction is tried: from any state, k periods without a violation are followed by another one. When that fails,
// invariants of the program are found and proved (prove/invariants) and assumed, then those that the property asks
// for (reachable.h). The slow part is one piece here, however it is sliced; what no run violates is checked again slice
// by slice by whoever knows the slices. In: a structured program, a property. Out:
// a verdict. Not its job: words about it, replaying runs.
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/program_invariants.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/prove/properties/result.h"
#include "transpiler/prove/properties/run_trials.h"

namespace plcxx::prove::properties {

/// Checks the properties of one program one after the other; what they share is executed once.
class PropertyChecker {
 public:
  /// `version` outlives it. Without a solver every check is refused.
  PropertyChecker(const machine::Version& version, CheckOptions options)
      : options_(std::move(options)), checked_(version, options_) {}

  /// Not empty: nothing can be checked, and why.
  const std::string& refusal() const { return checked_.refusal; }
  PropertyResult Check(const Property& property) { return Check(property, options_.time_ms); }
  /// Within another time than that of all checks.
  PropertyResult Check(const Property& property, uint64_t milliseconds);

 private:
  PropertyResult CheckInTime(const Property& property);
  bool TryInduction(const Property& property, uint32_t k, PropertyResult& result);
  /// What is left of the verdict with the slow part in one piece when inputs change between its slices; of what is
  /// never stuck that one says nothing.
  void CheckInSlices(const Property& property, PropertyResult& result);
  /// Whether a proved property says little: it speaks of what nothing changes, or of a case that does not come.
  std::string RemarkOn(const Property& property);

  CheckOptions options_;
  CheckedProgram checked_;
  RunTrials trials_{checked_};
  ProgramInvariants invariants_{checked_, trials_};
};

}  // namespace plcxx::prove::properties
