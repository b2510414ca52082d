// What the cost model says of a compiled program: the compile report's figures, slices, budgets.
#pragma once

#include "transpiler/compilation/compilation.h"

namespace plcxx::compilation {

/// Prices the partitions and, where the program leaves the number of slices to the cost model, sets it.
void EstimateCosts(Compilation& compilation);
/// The figures and slices of `shipped`, which is the same program without assertions.
void TakeCosts(Compilation& compilation, const Compilation& shipped);
/// Reports what is above the limits among the options.
void CheckBudgets(Compilation& compilation);
/// Cuts what has more than one slice.
void CutSlices(Compilation& compilation);

}  // namespace plcxx::compilation
