// What the scenarios beside a program do to it: where a search for runs begins, because a machine at work is hard to
// guess.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

/// A power cycle, perhaps; locations set, as the scenario writes them with their values, then time.
struct KnownStep {
  std::vector<std::pair<std::string, std::string>> words;
  // One of them is not 0.
  uint32_t slow = 0;  // complete slow passes
  uint32_t fast = 0;  // ticks of the fast part
  uint32_t ms = 0;
  bool power_cycle = false;
};

/// The steps of the scenarios in the directory of the first source, by name, up to the first force;
/// without what they expect. Files that are no scenarios, or have no steps, are left out.
std::vector<std::vector<KnownStep>> KnownRuns(const compilation::CompilationRequest& request);

/// The same of a folder; `reach`: what these scenarios may name.
std::vector<std::vector<KnownStep>> KnownRunsIn(const std::string& directory, Reach reach);

}  // namespace plcxx::scenarios
