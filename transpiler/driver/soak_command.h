// The subcommand `soak`.
#pragma once

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

void AddSoak(CLI::App& app, Run& run);

}  // namespace plcxx::driver
