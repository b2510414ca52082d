// A fleet as an Engine: some of its lanes carry the scenario, all others execute the same program with inputs of their
// own, so that a lane that is disturbed by its neighbours shows.
//
// In: a compiled program. Out: what the first carrier does; where another one does something else, that one's state and
// calls, under its own name, so that whoever compares finds it.
#pragma once

#include <memory>

#include "transpiler/fleet/library.h"
#include "transpiler/sim/engine.h"

namespace plcxx::fleet {

std::unique_ptr<sim::Engine> StartFleet(std::shared_ptr<const Library> library);

}  // namespace plcxx::fleet
