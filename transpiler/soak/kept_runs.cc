#include "transpiler/soak/kept_runs.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/soak/inputs.h"

namespace plcxx::soak {
namespace {

using review::diff::Stimuli;
using review::diff::Stimulus;

/// In one line: however many steps set what is set before time passes.
std::string LineOf(Stimuli stimuli) {
  // What is set at last does nothing, and is no step of a known run.
  const auto does_nothing = [](const Stimulus& last) {
    return last.slow == 0 && last.fast == 0 && last.ms == 0 && !last.power_cycle;
  };
  while (!stimuli.empty() && does_nothing(stimuli.back())) stimuli.pop_back();
  review::diff::WrittenSteps steps;
  for (const Stimulus& stimulus : stimuli) {
    if (stimulus.power_cycle) steps.AddPowerCycle();
    steps.Add(stimulus);
  }
  return steps.line;
}

}  // namespace

std::set<std::string> FitTo(const compilation::Compilation& compilation, std::vector<Stimuli>& runs) {
  std::set<std::string> dropped;
  Words words(compilation);
  const uint32_t period = std::max(1U, compilation.program.schedule.period_ms);
  for (Stimuli& run : runs) {
    for (Stimulus& stimulus : run) {
      std::erase_if(stimulus.words, [&](const std::pair<std::string, std::string>& word) {
        if (words.Find(word)) return false;
        dropped.insert(word.first);
        return true;
      });
      if (compilation.dialect->whole_periods && stimulus.ms % period != 0) stimulus.ms += period - stimulus.ms % period;
    }
  }
  return dropped;
}

std::string WhyNotReadBack(const scenarios::ProveMachine& machine, const std::string& path, const std::string& text,
                           const Stimuli& stimuli) {
  const scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, text);
  if (const auto* const errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    return errors->front().message;
  }
  const auto& scenario = std::get<scenarios::Scenario>(read);
  if (!scenario.steps) return "it has no steps";
  const auto plan = scenarios::PlanScenario(scenario, *machine.compilation.dialect, machine.compilation.program);
  if (const auto* const errors = std::get_if<std::vector<scenarios::ScenarioError>>(&plan)) {
    return errors->front().message;
  }
  Stimuli again;
  for (const scenarios::KnownStep& step : scenarios::KnownStepsOf(scenario)) {
    again.emplace_back(review::diff::WithoutWords(step)).words = step.words;
  }
  return LineOf(std::move(again)) == LineOf(stimuli) ? "" : "it is read as another run";
}

}  // namespace plcxx::soak
