// What was done to a machine as a scenario: written, read back, and run before anybody keeps it.
#pragma once

#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/live/timeline.h"

namespace plcxx::live {

struct Recording {
  std::string yaml;
  std::string refusal;  // not empty: there is none, or it does not pass, and why
};

/// From power-on to the present period. `directory`: where the scenario will stand. Not what a file must not say:
/// statements that were switched off.
Recording WriteRecording(const compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                         const Timeline& timeline, const std::string& directory);

/// The same, and whether it passes.
Recording CheckedRecording(compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                           const Timeline& timeline, const std::string& directory, const std::string& name);

/// A name that a scenario may have in the project's folder: letters, digits, "-" and "_", then ".yaml".
bool IsScenarioName(const std::string& name);

}  // namespace plcxx::live
