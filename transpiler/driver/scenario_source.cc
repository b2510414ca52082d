#include "transpiler/driver/scenario_source.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/driver/terminal.h"

namespace plcxx::driver {

bool IsScenario(const std::string& path) { return std::filesystem::path(path).extension() == ".yaml"; }

bool IsScenario(const CommonOptions& options) {
  return !options.program && options.sources.size() == 1 && IsScenario(options.sources.front());
}

std::optional<scenarios::Scenario> ReadScenario(const std::string& path, const CommonOptions& options) {
  scenarios::ScenarioOrErrors read =
      scenarios::ReadScenario(path, options.allow_outside ? scenarios::Reach::kAnywhere : scenarios::Reach::kProject);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    for (const scenarios::ScenarioError& error : *errors) std::cerr << ToText(error) << "\n";
    return std::nullopt;
  }
  return std::move(std::get<scenarios::Scenario>(read));
}

std::optional<compilation::CompilationRequest> RequestOfScenario(const CommonOptions& options,
                                                                 const compilation::CompilationRequest& request) {
  const std::optional<scenarios::Scenario> scenario = ReadScenario(options.sources.front(), options);
  if (!scenario) return std::nullopt;
  if (const std::string why = scenarios::WhyNoProgram(*scenario, {}); !why.empty()) {
    PrintUsageError(why);
    return std::nullopt;
  }
  compilation::CompilationRequest own = scenarios::RequestOf(
      *scenario, {.sources = {}, .program = nullptr, .options = request.options, .warnings = request.warnings});
  if (!request.dialect.empty()) own.dialect = request.dialect;
  if (request.encoding) own.encoding = request.encoding;
  own.include_directories.insert(own.include_directories.begin(), request.include_directories.begin(),
                                 request.include_directories.end());
  own.system_include_directories.insert(own.system_include_directories.begin(),
                                        request.system_include_directories.begin(),
                                        request.system_include_directories.end());
  own.macros.insert(own.macros.end(), request.macros.begin(), request.macros.end());
  return own;
}

std::optional<scenarios::ProgramOverrides> OverridesOf(const std::vector<std::string>& sources,
                                                       const compilation::CompilationRequest& request,
                                                       const CommonOptions& options) {
  scenarios::ProgramOverrides overrides{
      .sources = sources, .program = nullptr, .options = request.options, .warnings = request.warnings};
  if (sources.size() != 1 || !IsScenario(sources.front())) return overrides;
  std::optional<scenarios::Scenario> named = ReadScenario(sources.front(), options);
  if (!named) return std::nullopt;
  if (const std::string why = scenarios::WhyNoProgram(*named, {}); !why.empty()) {
    PrintUsageError(why);
    return std::nullopt;
  }
  overrides.program = std::make_shared<const scenarios::Scenario>(std::move(*named));
  return overrides;
}

}  // namespace plcxx::driver
