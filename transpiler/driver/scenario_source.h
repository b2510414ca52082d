// A scenario named where sources are expected: it stands for its program, with its options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/driver/common_options.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::driver {

/// Do the sources consist of one scenario?
bool IsScenario(const CommonOptions& options);
bool IsScenario(const std::string& path);

/// None when the file is wrong: its errors have been printed.
std::optional<scenarios::Scenario> ReadScenario(const std::string& path, const CommonOptions& options);

/// The program of the scenario that `options` name, where `request` is what the command line says beside it; of an
/// option that both set, the scenario's value counts. None: the error has been printed.
std::optional<compilation::CompilationRequest> RequestOfScenario(const CommonOptions& options,
                                                                 const compilation::CompilationRequest& request);

/// What the command line says about the programs of scenarios: `sources`, among them a scenario for its program, and
/// what `request` has of options and warnings. None: the error has been printed.
std::optional<scenarios::ProgramOverrides> OverridesOf(const std::vector<std::string>& sources,
                                                       const compilation::CompilationRequest& request,
                                                       const CommonOptions& options);

}  // namespace plcxx::driver
