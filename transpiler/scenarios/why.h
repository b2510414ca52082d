// Why a signal is what it is in a state of a scenario: its run is repeated in the simulator, and the scans that decided
// are explained, from the newest one back.
//
// In: a scenario with its plan, a location, and which state is meant. Out: conditions down to inputs, timers and what
// was kept from earlier scans, with the statements that wrote. Not its job: one scan (explanation/explain.h), and
// whether the signal can be anything else at all (plcxx prove).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/explanation/explain.h"
#include "transpiler/explanation/recorder.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

struct WhyQuestion {
  std::string name;  // the location as the user writes it
  dialects::Location location;
  std::optional<uint32_t> steps;    // after so many steps; none: all
  std::optional<uint64_t> time_ms;  // after the last scan that begins by then, since power-on
};

struct WhyAnswer {
  std::string value;
  uint64_t time_ms = 0;  // of the last scan
  bool has_run = false;  // at least one scan since power-on
  /// The first one is the signal. Conditions of earlier scans are reasons of what was kept from them.
  std::vector<explanation::Condition> conditions;
  std::string refusal;  // why there are none; lower case, no full stop
  std::string failure;  // the scenario did not come to its end: why
};

/// Whether a location can be asked about: why not, or nothing.
std::string CannotBeExplained(const compilation::Compilation& compilation, const dialects::Location& location);

/// Repeats the run that is asked about on a recorder, and lets it be looked at before it is gone. Gives why the run did
/// not come to its end, or nothing.
using RepeatRun = std::function<std::optional<std::string>(std::unique_ptr<explanation::Recorder> recorder,
                                                           const std::function<void()>& look)>;

/// Of any run that can be repeated; `steps` of the question mean nothing.
WhyAnswer ExplainInRun(const compilation::Compilation& compilation, const WhyQuestion& question, RepeatRun repeat);

/// The compilation is without errors; it, scenario and plan are of each other.
WhyAnswer ExplainInScenario(const compilation::Compilation& compilation, const Scenario& scenario, ScenarioPlan plan,
                            const WhyQuestion& question);

/// Tells the times of an answer from another moment than power-on: that one is `origin_ms` then.
void ShiftTimes(WhyAnswer& answer, uint64_t origin_ms);

/// Indented lines: the signal, then its conditions, each below what it is a reason of. At most so many lines.
std::string WhyText(const WhyAnswer& answer, const WhyQuestion& question, const compilation::Compilation& compilation,
                    size_t most_lines);

/// How a condition came about, in words: "an input, as at power-on".
std::string OriginText(const explanation::Condition& condition, const ir::Program& program,
                       const source::SourceManager& sources);

}  // namespace plcxx::scenarios
