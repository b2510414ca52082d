#include "transpiler/driver/lsp_scenarios.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/live/panel.h"
#include "transpiler/plant/panel.h"
#include "transpiler/plant/plant.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/scenarios/why.h"
#include "transpiler/source/find_file.h"

namespace plcxx::driver {
namespace {

/// A message in an editor is no page.
constexpr size_t kMostLines = 25;

std::string TextOfErrors(const std::vector<scenarios::ScenarioError>& errors) {
  std::string text;
  for (const scenarios::ScenarioError& error : errors) text += (text.empty() ? "" : "\n") + ToText(error);
  return text;
}

std::vector<std::string> ScenariosOfProgram(const std::vector<std::string>& paths,
                                            const std::vector<std::string>& sources) {
  const auto found = scenarios::FindScenarios(paths);
  const auto* files = std::get_if<std::vector<std::string>>(&found);
  if (files == nullptr) return {};
  std::vector<std::string> of_program;
  for (const std::string& path : *files) {
    const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path);
    const auto* scenario = std::get_if<scenarios::Scenario>(&read);
    if (scenario == nullptr || !scenario->steps || scenario->steps->empty()) continue;
    const compilation::CompilationRequest request = scenarios::RequestOf(*scenario, {});
    const bool runs_it = std::ranges::any_of(request.sources, [&](const std::string& source) {
      const std::string identity = source::FileIdentity(compilation::FromBase(request.base_directory, source));
      return std::ranges::find(sources, identity) != sources.end();
    });
    if (runs_it) of_program.push_back(path);
  }
  return of_program;
}

std::string WhyAtItsEnd(const std::string& path, const std::string& signal) {
  const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) return TextOfErrors(*errors);
  const scenarios::Scenario& scenario = std::get<scenarios::Scenario>(read);
  const compilation::Compilation compilation = compilation::Compile(scenarios::RequestOf(scenario, {}));
  if (!compilation.ok()) return "the program of " + path + " has errors";
  const auto location = compilation.dialect->locate(ir::NameIndex(compilation.program), signal);
  if (!location) return "'" + signal + "' is no location of the program of " + path;
  if (const std::string why = scenarios::CannotBeExplained(compilation, *location); !why.empty()) {
    return "'" + signal + "' cannot be explained: " + why;
  }
  auto plan = scenarios::PlanScenario(scenario, *compilation.dialect, compilation.program);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&plan)) return TextOfErrors(*errors);
  const scenarios::WhyQuestion question{
      .name = signal, .location = *location, .steps = std::nullopt, .time_ms = std::nullopt};
  const scenarios::WhyAnswer answer =
      scenarios::ExplainInScenario(compilation, scenario, std::move(std::get<scenarios::ScenarioPlan>(plan)), question);
  std::string text = scenarios::WhyText(answer, question, compilation, kMostLines);
  return answer.failure.empty() ? text : text + "the scenario did not come to its end: " + answer.failure;
}

std::vector<yaml::Error> MachineFaults(const lsp::FileText& plant, const lsp::FileText& panel,
                                       const compilation::Compilation& compilation) {
  std::vector<yaml::Error> faults;
  const auto add = [&](const auto& read_or_bound) {
    const auto* errors = std::get_if<std::vector<yaml::Error>>(&read_or_bound);
    if (errors != nullptr) faults.insert(faults.end(), errors->begin(), errors->end());
    return errors == nullptr;
  };
  std::shared_ptr<const scenarios::BoundPlant> bound;
  if (!plant.path.empty()) {
    const plant::ModelOrErrors read = plant::ParsePlant(plant.path, plant.text);
    if (add(read)) {
      const scenarios::BoundOrErrors joined = scenarios::BindPlant(std::get<std::shared_ptr<const plant::Model>>(read),
                                                                   *compilation.dialect, compilation.program);
      if (add(joined)) bound = std::get<std::shared_ptr<const scenarios::BoundPlant>>(joined);
    }
  }
  if (!panel.path.empty()) {
    const plant::PanelOrErrors read = plant::ParsePanel(panel.path, panel.text);
    if (add(read)) add(live::BindPanel(std::get<plant::Panel>(read), compilation, bound.get()));
  }
  return faults;
}

}  // namespace

lsp::ScenarioAnswers AnswersOfScenarios() {
  return {.of_program = ScenariosOfProgram, .why = WhyAtItsEnd, .machine_faults = MachineFaults};
}

}  // namespace plcxx::driver
