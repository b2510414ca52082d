#include "transpiler/driver/scenario_choice.h"

#include <algorithm>
#include <iostream>
#include <utility>
#include <variant>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::driver {
namespace {

/// False when that cannot be, which is reported.
bool TakeOfProject(CommonOptions& options, ChosenScenarios& chosen) {
  const std::optional<std::vector<project::Program>> programs = ChoosePrograms(options);
  if (!programs) return false;
  std::vector<std::string> without;  // what is said of programs that have no scenario
  for (const project::Program& program : *programs) {
    // One program of a park without a scenario is no reason not to run those of the others.
    const auto found = scenarios::FindScenarios(program.scenarios);
    if (const auto* why = std::get_if<std::string>(&found); why != nullptr && programs->size() > 1) {
      without.push_back(project::NameOf(program) + ": " + *why);
      continue;
    }
    for (const std::string& path : program.scenarios) {
      if (std::ranges::find(chosen.paths, path) == chosen.paths.end()) chosen.paths.push_back(path);
    }
    for (const project::Target& target : program.targets) {
      if (target.name == "host" && chosen.host_compiler.empty()) chosen.host_compiler = target.compiler;
    }
  }
  for (const std::string& text : without) std::cerr << "note: " << diag::Escaped(text) << '\n';
  if (without.size() < programs->size()) return true;
  PrintUsageError("no program of the project has a scenario; plcxx init writes a first one");
  return false;
}

}  // namespace

std::optional<ChosenScenarios> ChooseScenarios(CommonOptions& options, const std::vector<std::string>& named) {
  ChosenScenarios chosen{.paths = named, .host_compiler = {}};
  if (named.empty()) {
    if (!TakeOfProject(options, chosen)) return std::nullopt;
  } else if (!options.project.empty() || !options.program_names.empty() || options.all) {
    PrintUsageError("scenarios and a project are named: leave one of them out");
    return std::nullopt;
  }
  std::variant<std::vector<std::string>, std::string> found = scenarios::FindScenarios(chosen.paths);
  if (const auto* why = std::get_if<std::string>(&found)) {
    PrintUsageError(*why);
    return std::nullopt;
  }
  chosen.paths = std::move(std::get<std::vector<std::string>>(found));
  return chosen;
}

}  // namespace plcxx::driver
