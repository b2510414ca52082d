#include "transpiler/scenarios/project_program.h"

#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <variant>

namespace plcxx::scenarios {
namespace {

namespace fs = std::filesystem;

fs::path Canonical(const std::string& folder) {
  std::error_code error;
  return fs::weakly_canonical(folder.empty() ? "." : folder, error);
}

std::string NamesOf(const project::Project& project) {
  std::string names;
  for (const project::Program& program : project.programs)
    names += (names.empty() ? "" : ", ") + project::NameOf(program);
  return names;
}

/// The only program, or the only one in whose folder, or the nearest one above it, the scenario is.
const project::Program* NearestProgram(const project::Project& project, const std::string& directory) {
  if (project.programs.size() == 1) return &project.programs.front();
  const fs::path place = Canonical(directory);
  const project::Program* nearest = nullptr;
  size_t deepest = 0;
  for (const project::Program& program : project.programs) {
    const fs::path folder = Canonical(program.folder);
    if (!project::IsBelow(place, folder)) continue;
    const auto depth = static_cast<size_t>(std::distance(folder.begin(), folder.end()));
    if (depth > deepest || nearest == nullptr) {
      nearest = &program;
      deepest = depth;
    } else if (depth == deepest) {
      return nullptr;
    }
  }
  return nearest;
}

}  // namespace

std::vector<ScenarioError> TakeProgram(Scenario& scenario, const MarkedText& name, Reach reach) {
  const std::optional<std::string> path = project::FindProject(scenario.path);
  if (!path) {
    if (name.text.empty()) return {};
    return {{scenario.path, name.mark, "'program' names one of plcxx.yaml, and there is none here or above",
             "write plcxx.yaml, or name 'sources'"}};
  }
  project::ProjectOrErrors read = project::ReadProject(*path, reach);
  if (auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) return std::move(*errors);
  const auto& project = std::get<project::Project>(read);
  const project::Program* program =
      name.text.empty() ? NearestProgram(project, scenario.directory) : project::FindProgram(project, name.text);
  if (program == nullptr) {
    const std::string message =
        name.text.empty() ? "which program of " + *path + "?" : "there is no program '" + name.text + "' in " + *path;
    return {{scenario.path, name.mark, message, "write 'program: NAME'; there are: " + NamesOf(project)}};
  }
  scenario.program = *program;
  if (scenario.dialect.empty()) scenario.dialect = program->dialect;
  const fs::path from = Canonical(scenario.directory);
  for (const std::string& source : program->sources) {
    const fs::path meant = Canonical((fs::path(program->folder) / source).string());
    scenario.sources.push_back(meant.lexically_relative(from).generic_string());
  }
  return {};
}

}  // namespace plcxx::scenarios
