// Machines in the simulator, one after the other, each with the dialect's simulated control around it.
#pragma once

#include <memory>

#include "transpiler/compilation/compilation.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/soak/machines.h"

namespace plcxx::soak {

/// `compilation` is without errors, optimized, and outlives the machines. `plant` may be none: then nothing moves by
/// itself.
MakeMachines SimulatedMachines(const compilation::Compilation& compilation,
                               std::shared_ptr<const scenarios::BoundPlant> plant);

}  // namespace plcxx::soak
