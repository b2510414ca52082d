#include "transpiler/driver/scenario_program.h"

#include <filesystem>
#include <utility>

namespace plcxx::driver {
namespace {

/// All that distinguishes one request from another, as one text.
std::string KeyOf(const CompilationRequest& request) {
  std::string key;
  const auto add = [&key](const std::string& word) { key += std::to_string(word.size()) + ":" + word; };
  add(request.dialect);
  add(request.base_directory);
  for (const std::string& path : request.sources) add(path);
  key += ";";
  for (const auto& [name, value] : request.options) {
    add(name);
    add(value);
  }
  key += ";";
  if (request.encoding) add(std::string(source::Name(*request.encoding)));
  key += ";";
  for (const std::string& directory : request.system_include_directories) add(directory);
  key += ";";
  for (const std::string& code : request.warnings.enabled) add(code);
  return key;
}

}  // namespace

CompilationRequest RequestOf(const Scenario& scenario, const ProgramOverrides& overrides) {
  CompilationRequest request;
  request.dialect = scenario.dialect;
  request.base_directory = scenario.directory;
  request.sources = scenario.sources;
  if (!overrides.sources.empty()) {
    // Named on the command line: relative to the current directory, not to the scenario.
    request.sources.clear();
    for (const std::string& path : overrides.sources)
      request.sources.push_back(std::filesystem::absolute(path).string());
  }
  request.options = overrides.options;
  for (const auto& [name, value] : scenario.options) {
    // Options that are the tool's own and not the dialect's; a name that is none is refused as an option.
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
  request.warnings = overrides.warnings;
  for (const ExpectedWarning& warning : scenario.warnings.value_or(std::vector<ExpectedWarning>())) {
    request.warnings.enabled.insert(warning.code);
  }
  return request;
}

Compilation& ScenarioProgram::Compiled() {
  if (compiled_ != nullptr) return *compiled_;
  std::call_once(compile_once_, [this] { compilation_ = Compile(request_); });
  return compilation_;
}

CompiledOrFailure ScenarioProgram::On(const std::shared_ptr<const Platform>& platform) {
  const Compilation& compilation = Compiled();
  Built* built = nullptr;
  {
    const std::lock_guard lock(built_mutex_);
    built = &built_[platform->name];
  }
  std::call_once(built->once, [&] { built->result = CompileFor(platform, compilation.program, *compilation.sources); });
  return built->result;
}

void ScenarioPrograms::Announce(const Scenario& scenario) {
  CompilationRequest request = RequestOf(scenario, overrides_);
  const std::string key = KeyOf(request);
  Entry& entry = entries_[key];
  if (!entry.program) entry.program = std::make_shared<ScenarioProgram>(std::move(request));
  ++entry.awaited;
}

std::shared_ptr<ScenarioProgram> ScenarioPrograms::Take(const Scenario& scenario) {
  const std::string key = KeyOf(RequestOf(scenario, overrides_));
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(key);
  std::shared_ptr<ScenarioProgram> program = found->second.program;
  if (--found->second.awaited == 0) entries_.erase(found);
  return program;
}

}  // namespace plcxx::driver
