#include "transpiler/scenarios/known_runs.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

namespace plcxx::scenarios {
namespace {

/// The scenario files of one directory, sorted; none when there are none.
std::vector<std::string> FindScenariosIn(const std::string& directory) {
  std::vector<std::string> found;
  std::error_code error;
  const std::string where = directory.empty() ? "." : directory;
  for (const auto& entry : std::filesystem::directory_iterator(where, error)) {
    if (entry.path().extension() == ".yaml") found.push_back(entry.path().string());
  }
  std::ranges::sort(found);
  return found;
}

std::vector<KnownStep> StepsOf(const std::vector<ScenarioStep>& steps) {
  std::vector<KnownStep> known;
  KnownStep next;
  for (const ScenarioStep& step : steps) {
    if (const auto* const set = std::get_if<SetStep>(&step.action)) {
      for (const Assignment& assignment : set->assignments) {
        next.words.emplace_back(assignment.location.text, assignment.value.text);
      }
    } else if (const auto* const run = std::get_if<RunStep>(&step.action)) {
      for (const RunPart& part : run->parts) {
        switch (part.unit) {
          case RunUnit::kSlowCycles:
            next.slow = part.count;
            break;
          case RunUnit::kFastTicks:
            next.fast = part.count;
            break;
          case RunUnit::kMilliseconds:
            next.ms = part.count;
            break;
        }
        known.push_back(std::exchange(next, {}));
      }
    } else if (std::holds_alternative<PowerCycleStep>(step.action)) {
      // What was set before holds while the power is off, and what the power cycle before this one did is done.
      if (!next.words.empty() || next.power_cycle) known.push_back(std::exchange(next, {}));
      next.power_cycle = true;
    } else if (!std::holds_alternative<ExpectStep>(step.action) &&
               !std::holds_alternative<ExpectCallsStep>(step.action) &&
               !std::holds_alternative<ExpectMessagesStep>(step.action)) {
      break;
    }
  }
  // What power-on does needs no time. What is set at last does nothing.
  if (next.power_cycle) known.push_back(std::move(next));
  return known;
}

}  // namespace

std::vector<KnownStep> KnownStepsOf(const Scenario& scenario) {
  return scenario.steps ? StepsOf(*scenario.steps) : std::vector<KnownStep>();
}

RunFiles ReadRunsIn(const std::string& directory, Reach reach) {
  RunFiles files;
  for (const std::string& path : FindScenariosIn(directory)) {
    const ScenarioOrErrors read = ReadScenario(path, reach);
    if (const auto* const errors = std::get_if<std::vector<ScenarioError>>(&read)) {
      files.unreadable.push_back({path, errors->front()});
      continue;
    }
    std::vector<KnownStep> steps = KnownStepsOf(std::get<Scenario>(read));
    if (!steps.empty()) files.runs.push_back({path, std::move(steps)});
  }
  return files;
}

std::vector<std::vector<KnownStep>> KnownRuns(const compilation::CompilationRequest& request) {
  const std::filesystem::path source = std::filesystem::path(request.base_directory) / request.sources.front();
  std::vector<std::vector<KnownStep>> runs;
  for (RunFiles::Run& run : ReadRunsIn(source.parent_path().string(), Reach::kProject).runs)
    runs.push_back(std::move(run.steps));
  return runs;
}

}  // namespace plcxx::scenarios
