// Host calls that a scenario expects, compared with those that happened.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/sim/engine.h"

namespace plcxx::scenarios {

/// The events must be the expected calls, in order; of the arguments only those named count. Calls of the regular
/// exchange do not count, those of a polled function only where the list names the function. None when all is as
/// expected, else both lists in words.
std::optional<std::string> CallsMismatch(const ir::Program& program, const std::vector<PlannedCall>& expected,
                                         const std::vector<sim::HostEvent>& events);

}  // namespace plcxx::scenarios
