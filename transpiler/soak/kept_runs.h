// Runs in files: what is read fits the program, what is written is read back first.
//
// In: runs of scenarios and of earlier times, which may have been made for another version of the program; runs as they
// are to be written. Out: runs of which each word means something, and what is wrong with a text. Not its job: files.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/review/diff/stimulus.h"
#include "transpiler/scenarios/property_machine.h"

namespace plcxx::soak {

/// Drops what a scenario of this program could not set, and gives the names; times become whole periods where the
/// control takes no others.
std::set<std::string> FitTo(const compilation::Compilation& compilation, std::vector<review::diff::Stimuli>& runs);

/// Empty: `text`, at `path`, is read as a scenario of the program, and as this run. Else why not.
std::string WhyNotReadBack(const scenarios::ProveMachine& machine, const std::string& path, const std::string& text,
                           const review::diff::Stimuli& stimuli);

}  // namespace plcxx::soak
