// Which properties a command is about: files and scenarios of the command line, or those that plcxx.yaml names.
#pragma once

#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_places.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::driver {

struct ChosenProperties {
  std::vector<std::string> files;              // of properties; those of the command line are there before
  std::vector<scenarios::Scenario> scenarios;  // whose properties are meant
  compilation::CompilationRequest request;     // of the program
};

/// False: what is wrong has been printed.
bool ChooseProperties(const CommonOptions& options, ChosenProperties& chosen);

/// Reads them for the program of `machine`; what is wrong with them is printed, and the exit code is not kDone then.
int ReadProperties(const ChosenProperties& chosen, const CommonOptions& options, scenarios::ProveMachine& machine,
                   std::vector<scenarios::PlacedProperty>& properties);

}  // namespace plcxx::driver
