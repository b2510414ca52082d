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
  // One of them is not 0, unless another power cycle or nothing follows.
  uint32_t slow = 0;  // complete slow passes
  uint32_t fast = 0;  // ticks of the fast part
  uint32_t ms = 0;
  bool power_cycle = false;
};

/// The steps of the scenarios in the directory of the first source, by name, up to the first force;
/// without what they expect. Files that are no scenarios, or have no steps, are left out.
std::vector<std::vector<KnownStep>> KnownRuns(const compilation::CompilationRequest& request);

/// Of one scenario.
std::vector<KnownStep> KnownStepsOf(const Scenario& scenario);

/// The same of a folder by their files, and what is there and is no scenario.
struct RunFiles {
  struct Run {
    std::string path;
    std::vector<KnownStep> steps;
  };
  struct Unreadable {
    std::string path;
    ScenarioError error;  // the first one
  };
  std::vector<Run> runs;
  std::vector<Unreadable> unreadable;
};
/// `reach`: what these scenarios may name.
RunFiles ReadRunsIn(const std::string& directory, Reach reach);

}  // namespace plcxx::scenarios
