#include "transpiler/driver/plant_choice.h"

#include <filesystem>
#include <iostream>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

void PrintErrors(const std::vector<yaml::Error>& errors) {
  for (const yaml::Error& error : errors) std::cerr << ToText(error) << "\n";
}

using BoundPlantPointer = std::shared_ptr<const scenarios::BoundPlant>;

std::optional<BoundPlantPointer> Bound(std::shared_ptr<const plant::Model> model,
                                       const compilation::Compilation& compilation) {
  if (!model) return BoundPlantPointer();
  scenarios::BoundOrErrors bound = scenarios::BindPlant(std::move(model), *compilation.dialect, compilation.program);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&bound)) {
    PrintErrors(*errors);
    return std::nullopt;
  }
  return std::move(std::get<BoundPlantPointer>(bound));
}

}  // namespace

std::optional<BoundPlantPointer> ChoosePlant(const std::string& option, const CommonOptions& common,
                                             const compilation::Compilation& compilation) {
  if (option == kNoPlant) return BoundPlantPointer();
  if (option.empty() && IsScenario(common)) {
    const std::optional<scenarios::Scenario> scenario = ReadScenario(common.sources.front(), common);
    return scenario ? Bound(scenario->plant, compilation) : std::nullopt;
  }
  const std::string path = !option.empty() ? option : common.program ? common.program->plant : "";
  if (path.empty()) return BoundPlantPointer();
  plant::ModelOrErrors read = plant::ReadPlant(path);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    PrintErrors(*errors);
    return std::nullopt;
  }
  return Bound(std::move(std::get<std::shared_ptr<const plant::Model>>(read)), compilation);
}

std::optional<std::shared_ptr<const live::BoundPanel>> ChoosePanel(const std::string& option,
                                                                   const CommonOptions& common,
                                                                   const compilation::Compilation& compilation,
                                                                   const scenarios::BoundPlant* plant) {
  using Panel = std::shared_ptr<const live::BoundPanel>;
  std::string path = option;
  if (option.empty() && IsScenario(common)) {
    const std::optional<scenarios::Scenario> scenario = ReadScenario(common.sources.front(), common);
    if (scenario && scenario->program) path = scenario->program->panel;
  } else if (option.empty() && common.program) {
    path = common.program->panel;
  }
  if (path.empty() || path == kNoPlant) return Panel();
  plant::PanelOrErrors read = plant::ReadPanel(path);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    PrintErrors(*errors);
    return std::nullopt;
  }
  live::PanelOrErrors bound = live::BindPanel(std::move(std::get<plant::Panel>(read)), compilation, plant);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&bound)) {
    PrintErrors(*errors);
    return std::nullopt;
  }
  return std::move(std::get<Panel>(bound));
}

std::optional<BoundPlantPointer> ChooseSearchPlant(const std::string& option, const CommonOptions& common,
                                                   const compilation::Compilation& compilation) {
  const std::string named = option.empty() ? kNoPlant : option == kPlantOfProject ? "" : option;
  std::optional<BoundPlantPointer> plant = ChoosePlant(named, common, compilation);
  if (option == kPlantOfProject && plant && !*plant) {
    PrintUsageError("--plant project: the plcxx.yaml here names no plant; write 'plant: FILE' into it");
    return std::nullopt;
  }
  return plant;
}

std::string PlantName(const scenarios::BoundPlant& plant) {
  return std::filesystem::path(plant.model().path()).filename().string();
}

}  // namespace plcxx::driver
