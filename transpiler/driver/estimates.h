// What the cost model says of a compiled program: the compile report's figures, slices, budgets.
#pragma once

#include "transpiler/driver/compilation.h"

namespace plcxx::driver {

/// Prices the partitions and, where the program leaves the number of slices to the cost model, sets it.
void EstimateCosts(Compilation& compilation);
/// Reports what is above the limits among the options.
void CheckBudgets(Compilation& compilation);
/// Cuts what has more than one slice.
void CutSlices(Compilation& compilation);

}  // namespace plcxx::driver
