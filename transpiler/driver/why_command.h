// The subcommand `why`.
#pragma once

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

void AddWhy(CLI::App& app, Run& run);

}  // namespace plcxx::driver
