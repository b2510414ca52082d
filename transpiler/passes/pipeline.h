// The passes in their order. Structure comes before the checks, which want regions; the rest after them, so that the
// checks see what the source says. CutSlices comes last and apart: it takes the weights of the cost model.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

/// structured IR -> structured IR
void Optimize(ir::Program& program);

}  // namespace plcxx::passes
