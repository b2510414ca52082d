// What --engine of `plcxx test` says: which engines run the scenarios, side by side.
//
// In: "all", "sim", "host,cortex-m", "all,riscv/8". Out: the simulator or not, and the platforms, ready to build
// programs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/scenarios/suite.h"

namespace plcxx::driver {

/// For --help: all names.
std::vector<std::string_view> EngineNames();

/// The C++ compiler of an engine that is compiled here: `named`, or what is found when that is empty. None: there is
/// none; reported.
std::optional<std::string> CompilerOf(std::string_view engine, const std::string& named);

/// Fills `simulator` and `platforms` of the options. `compiler` is that of the host, empty when it is to be found.
/// Emulated machines have the simulator beside them, whose trace is the measure. The environment variable
/// PLCXX_ALL_TARGETS takes all scenarios where NAME/N takes one in N. False when it cannot be; reported.
bool ChooseEngines(const std::string& choice, const std::string& compiler, scenarios::SuiteOptions& options);

}  // namespace plcxx::driver
