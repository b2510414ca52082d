// `plcxx test`: runs scenario files and tells which passed.
#pragma once

#include <CLI/CLI.hpp>

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

void AddTest(CLI::App& app, Run& run);

}  // namespace plcxx::driver
