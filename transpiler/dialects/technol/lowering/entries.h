// Where the routine of a mechanism may begin, and whether its segments are the cases of a `switch` (routine.h).
#pragma once

#include "transpiler/dialects/technol/analysis/flow.h"
#include "transpiler/dialects/technol/lowering/routine.h"

namespace plcxx::technol {

/// Of a module or mechanism whose instructions are known.
void FindSegments(const Flow& flow, Routine& routine);

}  // namespace plcxx::technol
