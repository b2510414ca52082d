// Machines in the simulator, one after the other, each with the dialect's simulated control around it.
#pragma once

#include "transpiler/compilation/compilation.h"
#include "transpiler/soak/machines.h"

namespace plcxx::soak {

/// `compilation` is without errors, optimized, and outlives the machines.
MakeMachines SimulatedMachines(const compilation::Compilation& compilation);

}  // namespace plcxx::soak
