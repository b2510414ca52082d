// Executes a plan of `plcxx sim` and writes what happened: a table row per scan, host calls, operator messages.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/sim/trace.h"

namespace plcxx::driver {

enum class Rows : uint8_t { kEveryScan, kChangesOnly };

struct SimOutcome {
  uint64_t periods = 0;
  uint64_t time_ms = 0;
  uint64_t slow_cycles = 0;
  bool out_of_time = false;  // the limit of real time was reached
  sim::Graph::Phase graph = sim::Graph::Phase::kArmed;
  sim::Trace trace{{}};  // of the watched locations, when asked for
};

struct SimRunOptions {
  Rows rows = Rows::kEveryScan;
  bool with_trace = false;
  uint32_t seconds = 60;                               // of real time, at most
  std::shared_ptr<const scenarios::BoundPlant> plant;  // may be none
};

/// `stub` may be none.
SimOutcome RunSimulation(const compilation::Compilation& compilation, const SimPlan& plan, const SimRunOptions& options,
                         std::unique_ptr<dialects::ControlStub> stub, std::ostream& out);

}  // namespace plcxx::driver
