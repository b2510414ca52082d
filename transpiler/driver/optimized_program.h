// The last stage of a compilation on its own, for who wants the program before it, too.
#pragma once

#include "transpiler/driver/compilation.h"

namespace plcxx::driver {

/// A compilation that stopped at Stage::kChecked without errors goes on to kOptimized.
void OptimizeProgram(Compilation& compilation);

}  // namespace plcxx::driver
