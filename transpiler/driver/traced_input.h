// A recorded trace on the command line: read, and how far a run of the program follows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/scenarios/traced_run.h"
#include "transpiler/sim/read_vcd.h"

namespace plcxx::driver {

/// None: it cannot be read, which is reported.
std::optional<sim::Vcd> ReadWaveform(const std::string& path);

/// What of the trace was not taken, and where the run is another one: a sentence each.
std::vector<std::string> TraceNotes(const scenarios::TracedRun& run,
                                    const std::vector<scenarios::Departure>& departures);
/// To standard error, for they are about the question.
void PrintTraceNotes(const std::vector<std::string>& notes);

}  // namespace plcxx::driver
