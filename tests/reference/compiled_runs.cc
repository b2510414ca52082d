#include "tests/reference/compiled_runs.h"

#include <sstream>
#include <string_view>
#include <utility>
#include <variant>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/driver/embedded_consoles.h"
#include "transpiler/driver/scenario.h"
#include "transpiler/driver/scenario_program.h"
#include "transpiler/driver/scenario_suite.h"
#include "transpiler/support/check.h"

namespace plcxx::reference {

std::shared_ptr<const driver::Platform> MakeCompiler(const std::string& command) {
  auto platform = std::make_shared<driver::Platform>();
  platform->name = command;
  std::istringstream words(command);
  for (std::string word; words >> word;) platform->compile.push_back(word);
  const compile::TemporaryDirectory& shared = platform->shared;
  PLCXX_CHECK(shared.valid() && compile::WriteRuntime(shared.path()));
  for (unsigned i = 0; i < driver::kConsoleFilesCount; ++i) {
    if (std::string_view(driver::kConsoleFiles[i].name) != "host.h") continue;
    PLCXX_CHECK(shared.Write("console.h", {driver::kConsoleFiles[i].text, driver::kConsoleFiles[i].size}));
  }
  for (const char* flag : {"-std=c++17", "-ffp-contract=off", "-w", "-I"}) platform->compile.emplace_back(flag);
  platform->compile.push_back(shared.path());
  return platform;
}

std::string RunCompiled(const std::string& directory,
                        const std::vector<std::shared_ptr<const driver::Platform>>& compilers) {
  const driver::ScenarioOrErrors read = driver::ReadScenario(directory + "/scenario.yaml");
  const auto* const scenario = std::get_if<driver::Scenario>(&read);
  if (scenario == nullptr) return directory + ": no scenario";
  driver::SuiteOptions options;
  options.jobs = 1;
  for (const auto& compiler : compilers) options.platforms.push_back({compiler, 1});
  driver::ScenarioProgram program(driver::RequestOf(*scenario, {}));
  const driver::ScenarioResult result = driver::TestScenario(*scenario, options, program);
  return result.test.outcome == driver::TestOutcome::kPassed ? std::string() : result.test.text;
}

}  // namespace plcxx::reference
