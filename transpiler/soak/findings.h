// From a run in which something was seen to a short scenario that shows it, run before it is shown.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/soak/trial.h"

namespace plcxx::soak {

struct Finding {
  Cause cause;
  std::string steps;  // in one line
  std::string file;   // name of the scenario
  std::string yaml;
  std::string not_shown;  // not empty: the scenario does not show it, and why
};

/// Where scenarios will stand, and how long there is for them.
struct FindingPlace {
  std::string directory;
  std::function<bool(const std::string& name)> is_taken;  // a file that is not replaced; may be empty
  std::function<bool()> is_late;                          // then a run is not shortened any further; may be empty
};

class Findings {
 public:
  /// All outlive the object. `plant`: of the machines that are made.
  Findings(const scenarios::ProveMachine& machine, const compilation::CompilationRequest& request,
           const WatchPlan& plan, const MakeMachines& make, std::shared_ptr<const scenarios::BoundPlant> plant,
           FindingPlace place);

  /// None: a new machine does not show it.
  std::optional<Finding> Describe(const Cause& cause, const Stimuli& stimuli);
  /// How a scenario asks whether the message stands, "'U4A8': 1"; empty: it cannot.
  std::string MessageStands(uint32_t number) const;

 private:
  /// Whether the cause is seen in a run from power-on; `stimuli` ends with the step in which it is.
  bool Shows(const Cause& cause, const Stimuli& stimuli);
  std::string ExpectationOf(const Cause& cause) const;
  std::string NameOf(const Cause& cause);
  void Confirm(Finding& finding);

  const scenarios::ProveMachine& machine_;
  const compilation::CompilationRequest& request_;
  const WatchPlan& plan_;
  std::unique_ptr<Machines> machines_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  Words words_;
  FindingPlace place_;
  std::set<std::string> names_;
  uint64_t most_work_ = 0;  // of the finding at hand
};

/// The heading and steps of a scenario that does what a run did; `plant` may be none.
std::string ScenarioOf(const scenarios::ProveMachine& machine, const compilation::CompilationRequest& request,
                       const scenarios::BoundPlant* plant, const std::string& directory, const std::string& comment,
                       const Stimuli& stimuli);

}  // namespace plcxx::soak
