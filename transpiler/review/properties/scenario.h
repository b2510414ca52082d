// Counterexamples as scenarios: written from the run of a proof, and run in the simulator.
#pragma once

#include <string>

#include "transpiler/prove/properties/check.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/scenarios/property_machine.h"

namespace plcxx::review::properties {

struct PropertyScenario {
  std::string yaml;
  std::string steps;   // the same in one line: "set START=1, slow 1"
  std::string reason;  // not empty: there is no such scenario, or it does not show the violation, and why
};

struct ScenarioPlace {
  std::string directory;  // where it will stand: its sources are named from there
  std::string name;       // of the file
  /// That of the runs that have one; may be null where none has.
  const scenarios::BoundPlant* plant = nullptr;
};

/// The scenario of a violation: it fails as long as the property is violated, and passes when the program is repaired.
/// That of "is never stuck" shows a run after which the output stays as it is: it passes as long as it is stuck.
PropertyScenario MakePropertyScenario(const scenarios::ProveMachine& machine,
                                      const compilation::CompilationRequest& request,
                                      const prove::properties::Property& property,
                                      const prove::properties::PropertyResult& result, const ScenarioPlace& place);

}  // namespace plcxx::review::properties
