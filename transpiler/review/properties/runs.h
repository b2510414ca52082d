// Runs of a program in the simulator that violate a property: found by trying, then shortened.
//
// In: a program, a property, the inputs and requests that matter to it. Out: a run from power-on after which the
// property is violated, also where that takes a long start-up or a timer of minutes, which a solver does not reach. Not
// its job: showing that there is none (prove/properties/check.h).
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/properties/check.h"
#include "transpiler/review/properties/run_plans.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/property_machine.h"

namespace plcxx::review::properties {

class PropertyRuns {
 public:
  /// `known`: what the scenarios beside the program do. With a plant, which may be none, the machine moves as it does
  /// in all runs, and what it drives, or some of it, is left to it. The machine outlives it.
  PropertyRuns(const scenarios::ProveMachine& machine, const std::vector<std::vector<scenarios::KnownStep>>& known,
               std::shared_ptr<const scenarios::BoundPlant> plant = nullptr);

  /// Those of the scenarios; what a similar run sets, at several speeds; those in which the inputs are set once and
  /// then nothing happens; random ones; the scenarios with something unexpected in the middle. Ends with the first
  /// violation, or the time.
  std::optional<prove::properties::PropertyRun> Find(const prove::properties::RunSearch& search);

 private:
  using Plan = RunPlan;
  using Events = std::vector<RunEvent>;

  void AddPlanOf(const std::vector<scenarios::KnownStep>& steps);
  /// What the run sets, with `stretch` periods for each of its own, and a wait at the end.
  Plan StretchedPlanOf(const prove::properties::PropertyRun& run, uint32_t stretch) const;
  bool Late() const;
  /// The period after which the property is violated in this run; 0: in none of its periods, or it is late.
  uint32_t ViolatedAfter(const prove::properties::Property& property, const Plan& plan) const;
  std::optional<Plan> FindPlan(const prove::properties::RunSearch& search) const;
  void Shorten(const prove::properties::Property& property, Plan& plan) const;
  void Join(const prove::properties::Property& property, Plan& plan) const;
  /// All that may be cut, then half of it and so on; or every number: where parts wait for some periods, what is cut
  /// must be as long as they wait, and what comes before it may come sooner.
  enum class Cuts : uint8_t { kHalves, kEach };
  void ShortenWaits(const prove::properties::Property& property, Plan& plan, Cuts cuts) const;
  bool Try(const prove::properties::Property& property, Plan& plan, Plan shorter) const;

  const scenarios::ProveMachine& machine_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  std::vector<Plan> known_;
  std::vector<bool> inputs_;      // by cell
  std::vector<bool> can_be_set_;  // by cell: it is an input or a request, and has a name in scenarios
  std::chrono::steady_clock::time_point deadline_;
  uint64_t searches_ = 0;
};

/// Where the plant reads and drives: cells of memory, each once. Ports of the control have none.
std::vector<execute::CellId> ReadsOf(const scenarios::BoundPlant& plant, const scenarios::ProveMachine& machine);
/// Notes what the plant reads: runs set it although the program itself may have no place there.
void NameReadsOf(const scenarios::BoundPlant& plant, scenarios::ProveMachine& machine);
/// What the plant drives beside inputs, as its file names it: a proof for all inputs says nothing of that.
std::vector<std::string> DrivenBesideInputs(const scenarios::BoundPlant& plant, const scenarios::ProveMachine& machine);

}  // namespace plcxx::review::properties
