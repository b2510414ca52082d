// What a scenario expects of the compiler: its first error, its warnings.
//
// In: a scenario and its compilation. Out: nothing when all is as expected, else why not, in words, each line with the
// place in the scenario file. Not its job: the list of all diagnostics that is shown after it.
#pragma once

#include <optional>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/source/source.h"

namespace plcxx::scenarios {

/// The first error in source order must be at the expected line and contain the expected words.
std::optional<std::string> CheckExpectedError(const Scenario& scenario, const diag::Engine& diagnostics,
                                              const source::SourceManager& sources);

/// Each listed warning must be there, and a listed code nowhere else; an empty list allows none at all.
std::optional<std::string> CheckExpectedWarnings(const Scenario& scenario, const diag::Engine& diagnostics,
                                                 const source::SourceManager& sources);

/// "W356" names "nc110-W356"; without regard to case.
bool CodeMatches(std::string_view code, std::string_view wanted);

}  // namespace plcxx::scenarios
