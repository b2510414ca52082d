// A part of a scenario's run as a frame, and the judge of what is said about it.
//
// The judge shares nothing with the explanation but its leaves: it executes the part again in the simulator, from
// states in which everything but the leaves is something else, and looks whether the signal is still what it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/explanation/explain.h"
#include "transpiler/explanation/recorder.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::explanation {

/// A scenario with its program; none: it does not compile, or has no steps.
struct Machine {
  scenarios::Scenario scenario;
  compilation::Compilation compilation;
};
std::optional<Machine> LoadMachine(const std::string& path);
std::optional<Machine> ReadMachine(const std::string& path, const std::string& yaml);

/// Parts that the scenario runs.
uint32_t PartsOf(const Machine& machine);
/// None: there is no such part.
std::optional<Frame> FrameOf(const Machine& machine, uint32_t part);

struct Judged {
  uint32_t tried = 0;
  uint32_t moved = 0;  // leaves that, changed alone, change the signal
  uint32_t leaves = 0;
  std::string refuted;  // not empty: another state with the same leaves gives another value, and what it differs in
};
Judged Judge(const Subject& subject, const Frame& frame, const std::vector<execute::CellId>& cells,
             const Explanation& explanation, uint64_t seed);

}  // namespace plcxx::explanation
