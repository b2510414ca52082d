// Executing a program with a change, and finding where one would make a difference.
#pragma once

#include "transpiler/sim/decoded.h"

namespace plcxx::sim {

/// The region of the change.
Flow ExecuteChangedRegion(Execution& execution, const DecodedRegion& region);
/// Executes it, and notes which of its changes would make a difference.
Flow ExecuteLookingForDifferences(Execution& execution, const Decoded& inst);

}  // namespace plcxx::sim
