// Runs that are worth trying where a property is to be violated: what is set in them, and when.
//
// In: the inputs and requests that matter to the property, the nearest ones first; the runs of the scenarios. Out: one
// run after the other, the same ones for the same seed. Not its job: executing them (runs.h).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/prove/properties/check.h"
#include "transpiler/review/properties/rhythm.h"
#include "transpiler/review/properties/run_plan.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::properties {

inline constexpr uint32_t kRunPeriods = 20'000;  // of one run
inline constexpr int kShortHoldRuns = 96, kLongHoldRuns = 24;
/// Waiting after all has been set: a run looks at every period, so that the shortest wait is found.
inline constexpr uint32_t kShortHoldPeriods = 300;

/// At least one, at most kRunPeriods.
uint32_t PeriodsOfMs(const scenarios::ProveMachine& machine, uint64_t ms);

class RunPlans {
 public:
  /// `can_be_set`: by cell. All outlive the object.
  RunPlans(const scenarios::ProveMachine& machine, const prove::properties::RunSearch& search,
           const std::vector<bool>& can_be_set, const std::vector<RunPlan>& known, uint64_t seed);

  /// The inputs are set once, and then nothing happens: first kShortHoldRuns short ones, then long ones.
  RunPlan Holding(int run);
  /// Inputs change at a steady pace.
  RunPlan AtSteadyPace(int run);
  /// Inputs change now and then; or a scenario, and something unexpected after a part of it.
  RunPlan AtRandom(int run);

 private:
  void FindWords();
  RunPlan Disturbed();
  RunPlan Changing(int run);
  void AddDoneRequests(int run, RunPlan& plan);

  const scenarios::ProveMachine& machine_;
  const std::vector<bool>& can_be_set_;
  const std::vector<RunPlan>& known_;
  std::vector<execute::CellId> inputs_, of_machine_, requests_;  // nearest first; `of_machine_`: no settings
  RhythmInputs rhythm_;
  terms::Random random_;
};

}  // namespace plcxx::review::properties
