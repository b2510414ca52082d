// Runs the steps of a scenario on engines in lockstep.
//
// In: a plan, the engines, the simulated control if there is one. Out: nothing when every expectation holds and the
// engines agree, else the text of the first failing step. Not its job: compiling, files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/program.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/last_writes.h"
#include "transpiler/sim/trace.h"
#include "transpiler/source/source.h"

namespace plcxx::scenarios {

struct ScenarioRun {
  const Scenario& scenario;
  const ScenarioPlan& plan;
  const dialects::Dialect& dialect;
  const ir::Program& program;
  const source::SourceManager& sources;
  engines::Lockstep& engines;
  const sim::LastWrites* writes = nullptr;            // of the simulator; none without one
  std::unique_ptr<dialects::ControlStub> stub;        // may be none
  sim::Trace* trace = nullptr;                        // sampled after each period; may be none
  PropertyMonitor* monitor = nullptr;                 // of the scenario's properties; may be none
  std::vector<const PlannedValue*>* unmet = nullptr;  // gets the expectations that do not hold; may be none
};

/// A part of a `run` step.
sim::Step RunOn(sim::Clock& clock, const RunPart& part);

/// EngineFault of an engine passes through.
std::optional<std::string> RunScenario(ScenarioRun run);

/// Everything readable that the plan names, once each.
std::vector<sim::Watched> WatchedLocations(const ScenarioPlan& plan, const ir::Program& program);

}  // namespace plcxx::scenarios
