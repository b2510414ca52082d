// Values that nothing uses disappear, with what only they used.
//
//   %0 = load a                 stmt s1
//   %1 = not.bit %0       ->    step.on_delay T5 ...
//   step.on_delay T5 ...
//
// Only what has no effect: pure operations, constants, loads. Steps, calls and stores stay, whether their results are
// used or not; so do markers, Ifs and everything else that holds statements.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void RemoveDead(ir::Program& program);

}  // namespace plcxx::passes
