// What plcxx answers to the process that called it; pipelines depend on these four numbers.
#pragma once

#include "transpiler/support/exit_code.h"

namespace plcxx::driver {

enum ExitCode : int {
  kDone = 0,
  kProgramHasErrors = 1,  // or a scenario failed, or a difference was found
  kWrongUse = 2,          // or a result cannot be written
  kInternalFault = support::kInternalFaultExit
};

}  // namespace plcxx::driver
