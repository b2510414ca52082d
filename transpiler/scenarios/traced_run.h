// A waveform as a scenario: what the trace says of inputs is set when it says so, and the program does the rest.
//
// In: a program and the changes of a VCD file, in which locations have the names that people give them. Out: a scenario
// whose run is that of the trace as far as the trace determines it, what of the trace is no input, and where a run of
// it departs from the trace. A trace has no power-on: the run begins with one at the trace's first time, so that what
// was kept from before is missing. Not its job: reading the file (sim/read_vcd.h), explaining (why.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/read_vcd.h"

namespace plcxx::scenarios {

/// A signal of the trace that is a location of the program.
struct TracedSignal {
  std::string name;     // as scenarios write it; the trace's own name may have other brackets
  uint32_t signal = 0;  // of Vcd::signals
  dialects::Location location;
};

struct TracedRun {
  Scenario scenario;
  uint64_t begins_ms = 0;             // the trace's time that is 0 in the scenario
  std::vector<TracedSignal> inputs;   // set by the scenario
  std::vector<TracedSignal> written;  // by the program, and compared
  std::vector<std::string> left_out;  // names that are no location of the program, or that it does not use
};

/// The first moment at which the run is not what the trace says, of one signal.
struct Departure {
  std::string name;
  uint64_t time_ms = 0;  // of the trace
  std::string traced, run;
};

/// `path` is that of the file: messages about the scenario have it.
TracedRun RunOfTrace(const compilation::Compilation& compilation, const sim::Vcd& trace, const std::string& path);

/// Runs the scenario in the simulator. A value that the trace has up to a period earlier or later counts as the same:
/// who recorded it looked at another moment of the scan. By time, then in the order of TracedRun::written.
std::vector<Departure> Departures(const compilation::Compilation& compilation, const sim::Vcd& trace,
                                  const TracedRun& run);

}  // namespace plcxx::scenarios
