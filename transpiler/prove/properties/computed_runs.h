// Runs from power-on that a solver finds, one period deeper each time.
#pragma once

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/run_trials.h"

namespace plcxx::prove::properties {

/// Looks for one of so many periods that violates the property; true: `result` has a verdict or a reason.
bool SearchRuns(CheckedProgram& checked, RunTrials& trials, const Property& property, uint32_t period,
                PropertyResult& result);

}  // namespace plcxx::prove::properties
