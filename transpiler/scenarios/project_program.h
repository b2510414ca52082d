// The program of a scenario that names no sources: that of the project it belongs to.
#pragma once

#include <string>
#include <vector>

#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

/// Fills in what the scenario leaves out; `name` chooses among several programs (empty: the one whose folder it is in).
/// Without a plcxx.yaml nothing happens. Gives what is wrong.
std::vector<ScenarioError> TakeProgram(Scenario& scenario, const MarkedText& name, Reach reach);

}  // namespace plcxx::scenarios
