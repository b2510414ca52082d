// What a timer, a counter or an edge has kept, in words: how long a timer has run, and what is left.
#pragma once

#include <string>

#include "transpiler/ir/program.h"
#include "transpiler/sim/instances.h"

namespace plcxx::explanation {

/// "1200 of 3000 ms, 1800 ms left"; of what is no timer its fields: "count 3, input 1".
std::string InstanceText(const ir::Program& program, ir::StateId state, const sim::Instances& instances);

}  // namespace plcxx::explanation
