// The subcommand `mutate`.
#pragma once

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

void AddMutate(CLI::App& app, Run& run);

}  // namespace plcxx::driver
