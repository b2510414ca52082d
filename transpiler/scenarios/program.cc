#include "transpiler/scenarios/program.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace plcxx::scenarios {

std::string KeyOf(const compilation::CompilationRequest& request) {
  std::string key;
  const auto add = [&key](const std::string& word) { key += std::to_string(word.size()) + ":" + word; };
  add(request.dialect);
  add(request.base_directory);
  for (const std::string& path : request.sources) add(path);
  for (const auto& [path, text] : request.texts) {
    add(path);
    add(text);
  }
  key += ";";
  for (const auto& [name, value] : request.options) {
    add(name);
    add(value);
  }
  key += ";";
  if (request.encoding) add(std::string(source::Name(*request.encoding)));
  key += ";";
  for (const std::string& directory : request.include_directories) add(directory);
  key += ";";
  for (const std::string& directory : request.system_include_directories) add(directory);
  key += ";";
  for (const dialects::MacroOption& macro : request.macros) {
    add(macro.name);
    add(macro.text ? "=" + *macro.text : "");
  }
  key += ";";
  for (const std::string& code : request.warnings.enabled) add(code);
  return key;
}

std::string WhyNoProgram(const Scenario& scenario, const std::vector<std::string>& sources) {
  if (!scenario.sources.empty() || !sources.empty()) return {};
  return scenario.path + ": no 'sources': the scenario names no program";
}

namespace {

/// Options that are the tool's own and not the dialect's; a name that is none is refused as an option.
void AddOptions(const Scenario& scenario, compilation::CompilationRequest& request) {
  for (const auto& [name, value] : scenario.options) {
    const std::optional<source::Encoding> encoding =
        name == "encoding" ? source::EncodingByName(value) : std::optional<source::Encoding>();
    if (encoding) {
      request.encoding = encoding;
    } else if (name == "system-include") {
      request.system_include_directories.push_back((std::filesystem::path(scenario.directory) / value).string());
    } else if (name != "encoding" || value != "auto") {
      request.options.emplace_back(name, value);
    }
  }
}

}  // namespace

compilation::CompilationRequest RequestOf(const Scenario& scenario, const ProgramOverrides& overrides) {
  const Scenario& named = overrides.program != nullptr ? *overrides.program : scenario;
  compilation::CompilationRequest request;
  if (named.program) {
    request = project::RequestOf(*named.program);
    request.include_directories.push_back(named.directory.empty() ? "." : named.directory);
  } else {
    request.base_directory = named.directory;
    request.sources = named.sources;
    request.texts = named.texts;
    // A source that is written in the scenario includes what is beside the scenario.
    if (!named.texts.empty()) request.include_directories.push_back(named.directory.empty() ? "." : named.directory);
  }
  request.dialect = named.dialect.empty() ? scenario.dialect : named.dialect;
  if (!overrides.sources.empty() && overrides.program == nullptr) {
    // Named on the command line: relative to the current directory, not to the scenario.
    request.sources.clear();
    for (const std::string& path : overrides.sources)
      request.sources.push_back(std::filesystem::absolute(path).string());
  }
  // The later one counts: what the project says, the command line, the scenario.
  request.options.insert(request.options.end(), overrides.options.begin(), overrides.options.end());
  if (overrides.program != nullptr) AddOptions(named, request);
  AddOptions(scenario, request);
  // What the command line says of warnings comes before what the project does.
  for (const std::string& code : overrides.warnings.enabled) request.warnings.disabled.erase(code);
  request.warnings.enabled.insert(overrides.warnings.enabled.begin(), overrides.warnings.enabled.end());
  request.warnings.disabled.insert(overrides.warnings.disabled.begin(), overrides.warnings.disabled.end());
  request.warnings.errors.insert(overrides.warnings.errors.begin(), overrides.warnings.errors.end());
  request.warnings.all_errors = request.warnings.all_errors || overrides.warnings.all_errors;
  for (const ExpectedWarning& warning : scenario.warnings.value_or(std::vector<ExpectedWarning>())) {
    request.warnings.enabled.insert(warning.code);
  }
  return request;
}

emit::Flavour FlavourFor(const Scenario& scenario) {
  const bool forces =
      scenario.steps && std::ranges::any_of(*scenario.steps, [](const ScenarioStep& step) {
        return std::holds_alternative<ForceStep>(step.action) || std::holds_alternative<ReleaseStep>(step.action);
      });
  return forces ? emit::Flavour::kDebug : emit::Flavour::kRelease;
}

compilation::Compilation& ScenarioProgram::Compiled() {
  if (compiled_ != nullptr) return *compiled_;
  std::call_once(compile_once_, [this] { compilation_ = compilation::Compile(request_); });
  return compilation_;
}

ScenarioProgram::Built& ScenarioProgram::BuiltOn(const engines::Platform& platform, emit::Flavour flavour) {
  const std::lock_guard lock(built_mutex_);
  return built_[{platform.name, flavour}];
}

engines::CompiledOrFailure ScenarioProgram::On(const std::shared_ptr<const engines::Platform>& platform,
                                               emit::Flavour flavour) {
  const compilation::Compilation& compilation = Compiled();
  Built& built = BuiltOn(*platform, flavour);
  std::call_once(built.once, [&] {
    built.result = engines::CompileFor(platform, compilation.program, *compilation.sources, flavour);
  });
  return built.result;
}

fleet::LibraryOrFailure ScenarioProgram::AsFleet(const fleet::LibraryRequest& request) {
  const compilation::Compilation& compilation = Compiled();
  const std::lock_guard lock(built_mutex_);
  const auto known = fleets_.find(request.forces);
  if (known != fleets_.end()) return known->second;
  return fleets_.emplace(request.forces, fleet::CompileFleet(compilation.program, request)).first->second;
}

void ScenarioProgram::Give(const engines::Platform& platform, emit::Flavour flavour,
                           engines::CompiledOrFailure result) {
  Built& built = BuiltOn(platform, flavour);
  std::call_once(built.once, [&] { built.result = std::move(result); });
}

}  // namespace plcxx::scenarios
