// The subcommand `live`.
#pragma once

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

void AddLive(CLI::App& app, Run& run);

}  // namespace plcxx::driver
