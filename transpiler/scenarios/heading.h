// The beginning of a scenario that the tool writes: which program it drives, with which options.
#pragma once

#include <string>

#include "transpiler/compilation/compilation.h"

namespace plcxx::scenarios {

/// Keys `dialect`, `sources`, `options`: the program of `request`, which `compilation` is of, named from `directory`
/// where the scenario will stand.
std::string ScenarioHeading(const compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                            const std::string& directory);

}  // namespace plcxx::scenarios
