// A scenario in the session: its steps are done as the operator would do them, up to the moment that matters.
//
// In: a scenario with its plan. Out: the machine where an expectation fails first or a property is violated, else at
// the end; the way back leads through everything that came before. Not its job: files, and what a plan is (scenarios/).
#pragma once

#include <string>

#include "transpiler/live/session.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::live {

/// Why it stands where it stands: "step 4 (expect): U4A8 is 0, expected 1". What a step asks of host calls and messages
/// is not looked at. Or why the scenario cannot be opened, as a refusal.
struct Opened {
  std::string text;
  Refusal refusal;
};
Opened OpenScenario(Session& session, const scenarios::Scenario& scenario, const scenarios::ScenarioPlan& plan);

}  // namespace plcxx::live
