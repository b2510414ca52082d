// The beginning of a scenario that the tool writes: which program it drives, with which options.
#pragma once

#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/scenarios/bound_plant.h"

namespace plcxx::scenarios {

/// Keys `dialect`, `sources`, `options`: the program of `request`, which `compilation` is of, named from `directory`
/// where the scenario will stand.
std::string ScenarioHeading(const compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                            const std::string& directory);

/// Key `plant`, likewise; none: no key.
std::string PlantHeading(const BoundPlant* plant, const std::string& directory);

}  // namespace plcxx::scenarios
