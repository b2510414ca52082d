// Host functions that a version calls whenever power comes: that is certain without a run.
// In: a version. Not its job: what follows from the calls.
#pragma once

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::diff {

/// `calls`: of any kind; false of what are no calls of one function.
bool IsCalledAtPowerOn(const machine::Version& version, execute::CellId calls);

}  // namespace plcxx::prove::diff
