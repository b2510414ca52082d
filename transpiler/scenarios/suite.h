// Runs scenario files: compiles what they name, drives the engines, tells which passed.
//
// In: paths of scenarios. Out: one TestCase for each, in the order of the paths. Not its job: the command line
// (test_command.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/engines/platform.h"
#include "transpiler/fleet/library.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/test_case.h"

namespace plcxx::scenarios {

/// A platform that runs scenarios: all of them, or one in `one_in`, chosen by the scenario's bytes, so that it is the
/// same choice everywhere.
struct PlatformUse {
  std::shared_ptr<const engines::Platform> platform;
  uint32_t one_in = 1;
};

/// Many machines at once, a few of which carry the scenario.
struct FleetUse {
  fleet::LibraryRequest library;
  uint32_t one_in = 1;
};

/// What the simulator saw of one scenario.
struct Observation {
  std::vector<uint8_t> given;  // by InstId, as Simulator::NoteGiven has it
  uint64_t executed = 0;       // instructions
  uint64_t most = UINT64_MAX;  // instructions after which the simulator ends what it does
  bool stopped = false;        // it did
};

/// What runs a scenario, in lockstep. A program that uses a function of the regular exchange for itself, too, has the
/// simulator beside it in any case, which tells the one from the other.
struct SuiteOptions {
  bool simulator = true;
  std::vector<PlatformUse> platforms;
  std::optional<FleetUse> fleet;
  ProgramOverrides programs;
  Reach reach = Reach::kProject;
  unsigned jobs = 2;                   // processes that run scenarios at a time
  unsigned time_limit = 60;            // seconds of real time for a scenario: reading its program, then running it
  bool waveform = false;               // record one
  bool explains = true;                // why an expectation does not hold, in the text of a failure
  Observation* observation = nullptr;  // of TestScenario: gets what the simulator saw; may be none
};

struct ScenarioResult {
  TestCase test;
  std::string ran;                        // "3 steps in simulator and compiled"
  std::string waveform;                   // VCD text; empty when no step ran
  std::vector<std::string> sources = {};  // of its program, as they are opened
};

/// The scenarios that `paths` name: files as they are, directories by all their *.yaml files, sorted by path.
/// None with the reason when a directory holds none.
std::variant<std::vector<std::string>, std::string> FindScenarios(const std::vector<std::string>& paths);

/// Whether the platform runs this scenario, one in `one_in`.
bool RunsOn(uint32_t one_in, const Scenario& scenario);

/// What watches the scenario's properties while its steps run; none: it has none.
std::unique_ptr<PropertyMonitor> MonitorOf(const Scenario& scenario, const compilation::Compilation& compilation,
                                           std::vector<ScenarioError>& errors);

/// One scenario, read before, in this process and without a limit.
ScenarioResult TestScenario(const Scenario& scenario, const SuiteOptions& options, ScenarioProgram& program);

/// All of them, in child processes: one that crashes plcxx, or does not end, fails, and the others go on. Their
/// programs are compiled for a platform together (groups.h). `report` is called once for each, in order, as
/// soon as it and those before it are done.
std::vector<ScenarioResult> TestScenarios(const std::vector<std::string>& paths, const SuiteOptions& options,
                                          const std::function<void(const ScenarioResult&)>& report);

}  // namespace plcxx::scenarios
