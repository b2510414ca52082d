#include "transpiler/review/properties/coarse_runs.h"

#include <numeric>
#include <utility>

namespace plcxx::review::properties {

using prove::properties::Property;
using prove::properties::PropertyRun;

struct CoarseRuns::Machine {
  Machine(const ir::Program& of, uint32_t period_ms) : program(of) {
    program.schedule.period_ms = period_ms;
    program.schedule.slot_ms = period_ms;
    version = prove::machine::MakeVersion(program);
  }
  ir::Program program;
  prove::machine::Version version;
};

namespace {

uint32_t Rounded(uint32_t periods, uint32_t by) { return (periods + by - 1) / by; }

/// The same in the periods of the host that calls the program seldom.
Property InCoarsePeriods(Property property, uint32_t by) {
  property.periods = Rounded(property.periods, by);
  for (prove::properties::Condition& condition : property.conditions)
    condition.periods = Rounded(condition.periods, by);
  return property;
}

/// The inputs of a coarse period are set before the first one of its periods, and stay.
PropertyRun InOwnPeriods(PropertyRun coarse, uint32_t by) {
  PropertyRun run{.has_plant = false, .before_power_on = std::move(coarse.before_power_on), .periods = {}};
  for (std::vector<std::vector<prove::properties::InputValue>>& period : coarse.periods) {
    // A violation is seen behind the call that makes it: the last wait is none.
    if (!run.periods.empty()) run.periods.resize(run.periods.size() + by - 1, {{}});
    run.periods.push_back(std::move(period));
  }
  return run;
}

}  // namespace

CoarseRuns::CoarseRuns(const scenarios::ProveMachine& machine) : machine_(machine) {
  const ir::Schedule& schedule = machine.compilation.program.schedule;
  const uint32_t wait_ms = std::gcd(schedule.fast_every_ms, schedule.slow_every_ms);
  const bool are_known = schedule.fast_every_ms != 0 && schedule.slow_every_ms != 0;
  if (are_known && machine.slices == 1 && wait_ms % schedule.period_ms == 0) periods_ = wait_ms / schedule.period_ms;
}

CoarseRuns::~CoarseRuns() = default;

std::optional<PropertyRun> CoarseRuns::Find(const Property& property, uint64_t milliseconds) {
  if (!AreUseful() || property.kind == prove::properties::PropertyKind::kNeverStuck) return std::nullopt;
  const ir::Program& program = machine_.compilation.program;
  if (!coarse_) coarse_ = std::make_unique<Machine>(program, program.schedule.period_ms * periods_);
  prove::properties::PropertyChecker checker(coarse_->version, {.time_ms = milliseconds, .only_runs = true});
  if (!checker.refusal().empty()) return std::nullopt;
  prove::properties::PropertyResult found = checker.Check(InCoarsePeriods(property, periods_));
  if (found.verdict != prove::properties::PropertyVerdict::kViolated || !found.run) return std::nullopt;
  return InOwnPeriods(std::move(*found.run), periods_);
}

}  // namespace plcxx::review::properties
