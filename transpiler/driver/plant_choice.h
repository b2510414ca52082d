// Which plant and panel a command works with: those of its options, of its scenario, or of plcxx.yaml.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/live/panel.h"
#include "transpiler/scenarios/bound_plant.h"

namespace plcxx::driver {

/// As the value of --plant and --panel: not even the one of plcxx.yaml.
inline constexpr const char* kNoPlant = "none";

/// None: what is wrong has been printed. A null pointer: nothing moves by itself. `option` is that of --plant; empty:
/// it was not given.
std::optional<std::shared_ptr<const scenarios::BoundPlant>> ChoosePlant(const std::string& option,
                                                                        const CommonOptions& common,
                                                                        const compilation::Compilation& compilation);

/// Likewise, of --panel.
std::optional<std::shared_ptr<const live::BoundPanel>> ChoosePanel(const std::string& option,
                                                                   const CommonOptions& common,
                                                                   const compilation::Compilation& compilation,
                                                                   const scenarios::BoundPlant* plant);

/// As the value of --plant of a search for runs: the one of plcxx.yaml.
inline constexpr const char* kPlantOfProject = "project";

/// The plant of a search for runs, in which nothing moves by itself unless `option` says so: a file, or
/// kPlantOfProject, which must be there. None: what is wrong has been printed.
std::optional<std::shared_ptr<const scenarios::BoundPlant>> ChooseSearchPlant(
    const std::string& option, const CommonOptions& common, const compilation::Compilation& compilation);

/// Its file, without the folder.
std::string PlantName(const scenarios::BoundPlant& plant);

}  // namespace plcxx::driver
