#include "transpiler/driver/property_choice.h"

#include <optional>
#include <utility>

#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/named_file.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/byte_order_mark.h"

namespace plcxx::driver {
namespace {

bool TakeScenario(const std::string& path, const CommonOptions& options, ChosenProperties& chosen) {
  std::optional<scenarios::Scenario> scenario = ReadScenario(path, options);
  if (scenario) chosen.scenarios.push_back(std::move(*scenario));
  return scenario.has_value();
}

}  // namespace

bool ChooseProperties(const CommonOptions& options, ChosenProperties& chosen) {
  std::optional<compilation::CompilationRequest> request = MakeRequest(options);
  if (!request) return false;
  chosen.request = std::move(*request);
  for (const std::string& path : chosen.files) {  // of the command line: lines of properties
    if (!IsScenario(path)) continue;
    PrintUsageError("'" + path +
                    "' is YAML, as scenarios are: --property names a file of properties, one a line; those "
                    "of a scenario are proved by 'plcxx prove " +
                    path + "'");
    return false;
  }
  if (!options.program) return !IsScenario(options) || TakeScenario(options.sources.front(), options, chosen);
  // What the project wants to hold, where the command line names nothing.
  if (!chosen.files.empty()) return true;
  for (const std::string& path : options.program->properties) {
    if (!IsScenario(path)) {
      chosen.files.push_back(path);
    } else if (!TakeScenario(path, options, chosen)) {
      return false;
    }
  }
  return true;
}

int ReadProperties(const ChosenProperties& chosen, const CommonOptions& options, scenarios::ProveMachine& machine,
                   std::vector<scenarios::PlacedProperty>& properties) {
  compilation::Compilation& compilation = machine.compilation;
  const dialects::Dialect& dialect = *compilation.dialect;
  const prove::properties::PropertyContext context =
      scenarios::PropertyContextOf(dialect, compilation.program, machine.version.cells, machine.timing);
  const auto add = [&properties](std::vector<scenarios::PlacedProperty> more) {
    for (scenarios::PlacedProperty& one : more) properties.push_back(std::move(one));
  };
  diag::Engine diagnostics;
  std::swap(diagnostics, compilation.diagnostics);  // warnings of the program are not this command's
  for (const scenarios::Scenario& scenario : chosen.scenarios) {
    if (scenario.properties.empty()) continue;
    add(scenarios::PropertiesOfScenario(scenario, dialect.name, context, *compilation.sources,
                                        compilation.diagnostics));
  }
  for (const std::string& path : chosen.files) {
    std::optional<std::string> text = ReadNamedFile(path, "--property names a file of properties, one a line");
    if (!text) return kWrongUse;
    support::RemoveByteOrderMark(*text);
    add(scenarios::PropertiesOfFile(path, *text, dialect.name, context, *compilation.sources, compilation.diagnostics));
  }
  if (compilation.ok()) return kDone;
  PrintDiagnosticsBeside(compilation, MessagesOf(options));
  return kWrongUse;
}

}  // namespace plcxx::driver
