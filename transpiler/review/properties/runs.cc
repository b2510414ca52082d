#include "transpiler/review/properties/runs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::review::properties {
namespace {

using execute::CellId;

constexpr int kFirstRhythms = 160, kRandomRuns = 24;
/// What one scan does without the machine it does after a while with it.
constexpr uint32_t kStretches[] = {1, 10, 100};
/// In slices the plant sees an output some slices later or sooner than at the end of a pass.
constexpr uint32_t kSlicedPasses = 2;
/// The answer is there; a short one is read more easily.
constexpr std::chrono::seconds kShorteningTime{2};
constexpr uint32_t kMostTriedCuts = 40;

/// The program in the simulator, with the dialect's simulated control around it, watched period by period.
class Watched {
 public:
  Watched(const scenarios::ProveMachine& machine, const std::shared_ptr<const scenarios::BoundPlant>& plant,
          const prove::properties::Property& property)
      : machine_(machine),
        program_(machine.compilation.program),
        simulator_(program_),
        control_(program_, *machine.compilation.dialect, simulator_, scenarios::StubOf(machine.compilation)),
        clock_(program_, {&simulator_}),
        monitor_(program_, machine.version.cells, {property}) {
    if (plant) control_.Attach(plant);
    clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
    clock_.after_period = [this](uint32_t now_ms) {
      control_.AfterPeriod(now_ms);
      monitor_.AfterPart(simulator_, clock_.last_part());
    };
    clock_.PowerOn();
    control_.PowerOn();
  }

  void Set(CellId id, bool value) {
    const execute::Cell cell = execute::CellAt(program_, machine_.version.cells, id);
    dialects::Location location;
    location.place.type = ir::Type::kBit;
    location.place.space = cell.space;
    location.place.offset = cell.offset;
    location.place.bit = cell.bit;
    control_.Set(location, value ? 1 : 0);
  }

  /// false: the program got stuck.
  bool RunPeriod() { return clock_.RunMs(std::max(1U, program_.schedule.period_ms)) != sim::Step::kStuck; }
  bool violated() const { return monitor_.violation().has_value(); }

 private:
  const scenarios::ProveMachine& machine_;
  const ir::Program& program_;
  sim::Simulator simulator_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
  scenarios::PropertyMonitor monitor_;
};

std::vector<CellId> CellsAt(const dialects::Location& location, const scenarios::ProveMachine& machine) {
  const ir::Program& program = machine.compilation.program;
  std::vector<CellId> cells;
  if (location.cell || location.text_input || location.absent) return cells;
  if (!location.bits.empty()) {
    for (const ir::Place& bit : location.bits)
      cells.push_back(execute::CellsOf(program, machine.version.cells, bit).front());
  } else if (execute::IsInside(program, location.place)) {
    cells = execute::CellsOf(program, machine.version.cells, location.place);
  }
  return cells;
}

}  // namespace

std::vector<CellId> ReadsOf(const scenarios::BoundPlant& plant, const scenarios::ProveMachine& machine) {
  std::vector<CellId> reads;
  for (const dialects::Location& location : plant.reads()) {
    for (const CellId cell : CellsAt(location, machine)) {
      if (std::ranges::find(reads, cell) == reads.end()) reads.push_back(cell);
    }
  }
  return reads;
}

void NameReadsOf(const scenarios::BoundPlant& plant, scenarios::ProveMachine& machine) {
  for (size_t i = 0; i < plant.reads().size(); ++i) {
    std::vector<CellId> cells = CellsAt(plant.reads()[i], machine);
    if (!cells.empty()) machine.named.push_back({.name = plant.model().reads()[i].text, .cells = std::move(cells)});
  }
}

std::vector<std::string> DrivenBesideInputs(const scenarios::BoundPlant& plant,
                                            const scenarios::ProveMachine& machine) {
  const std::vector<bool> inputs = prove::machine::InputsOf(machine.version);
  std::vector<std::string> names;
  for (size_t i = 0; i < plant.drives().size(); ++i) {
    const std::vector<CellId> cells = CellsAt(plant.drives()[i], machine);
    if (!std::ranges::all_of(cells, [&](CellId cell) { return inputs[cell.index]; }))
      names.push_back(plant.model().drives()[i].name.text);
  }
  return names;
}

PropertyRuns::PropertyRuns(const scenarios::ProveMachine& machine,
                           const std::vector<std::vector<scenarios::KnownStep>>& known,
                           std::shared_ptr<const scenarios::BoundPlant> plant)
    : machine_(machine),
      plant_(std::move(plant)),
      inputs_(prove::machine::InputsOf(machine.version)),
      can_be_set_(machine.version.cells.count) {
  const ir::NameIndex names(machine.compilation.program);
  const std::vector<bool> requests = prove::machine::RequestCells(machine.version);
  std::vector<CellId> cells;
  for (uint32_t i = 0; i < inputs_.size(); ++i) {
    if (inputs_[i] || requests[i]) cells.emplace_back(i);
  }
  for (const scenarios::InputWord& word : scenarios::WordsOf(machine, cells)) {
    if (word.name.empty()) continue;
    if (plant_) {
      const std::optional<dialects::Location> location = machine.compilation.dialect->locate(names, word.name);
      if (location && plant_->DriverOf(*location) != nullptr) continue;
    }
    for (const CellId cell : word.cells) can_be_set_[cell.index] = inputs_[cell.index] || requests[cell.index];
  }
  for (const std::vector<scenarios::KnownStep>& steps : known) AddPlanOf(steps);
}

/// What the scenario sets beside inputs is left out: a proof is about power-on with all memory 0.
void PropertyRuns::AddPlanOf(const std::vector<scenarios::KnownStep>& steps) {
  const dialects::Dialect& dialect = *machine_.compilation.dialect;
  const ir::Program& program = machine_.compilation.program;
  const ir::NameIndex names(program);
  const prove::properties::PropertyTiming& timing = machine_.timing;
  Plan plan;
  for (const scenarios::KnownStep& step : steps) {
    if (step.power_cycle) break;
    for (const auto& [word, text] : step.words) {
      const std::optional<dialects::Location> location = dialect.locate(names, word);
      if (!location) continue;
      const std::vector<CellId> cells = CellsAt(*location, machine_);
      const std::optional<uint64_t> value = scenarios::ParseScenarioValue(text, location->place.type, dialect);
      for (size_t i = 0; value && i < cells.size(); ++i) {
        if (!can_be_set_[cells[i].index]) continue;
        const bool on = (*value >> i & 1) != 0;
        // Of a request the program alone decides when it begins.
        if (inputs_[cells[i].index] || !on) plan.events.push_back({plan.periods + 1, cells[i], on});
      }
    }
    const uint64_t fast =
        (uint64_t{step.fast} * timing.fast_periods + timing.fast_per_period - 1) / std::max(1U, timing.fast_per_period);
    const uint64_t periods =
        uint64_t{step.slow} * timing.slow_periods + fast + (step.ms == 0 ? 0 : PeriodsOfMs(machine_, step.ms));
    plan.periods = static_cast<uint32_t>(std::min<uint64_t>(kRunPeriods, plan.periods + periods));
  }
  if (plan.periods > 0) known_.push_back(std::move(plan));
}

PropertyRuns::Plan PropertyRuns::StretchedPlanOf(const prove::properties::PropertyRun& run, uint32_t stretch) const {
  Plan plan;
  for (const auto& period : run.periods) {
    for (const auto& part : period) {
      for (const prove::properties::InputValue& input : part) {
        if (can_be_set_[input.cell.index]) plan.events.push_back({plan.periods + 1, input.cell, input.value});
      }
    }
    plan.periods = std::min(kRunPeriods, plan.periods + stretch);
  }
  plan.periods = std::min(kRunPeriods, plan.periods + kShortHoldPeriods);
  return plan;
}

uint32_t PropertyRuns::ViolatedAfter(const prove::properties::Property& property, const Plan& plan) const {
  Watched watched(machine_, plant_, property);
  size_t next = 0;
  for (uint32_t period = 1; period <= plan.periods; ++period) {
    for (; next < plan.events.size() && plan.events[next].period <= period; ++next) {
      watched.Set(plan.events[next].cell, plan.events[next].value);
    }
    if (!watched.RunPeriod()) return 0;
    if (watched.violated()) return period;
    if (Late()) return 0;
  }
  return 0;
}

std::optional<PropertyRuns::Plan> PropertyRuns::FindPlan(const prove::properties::RunSearch& search) const {
  const prove::properties::Property& property = *search.property;
  const auto violates = [&](Plan& plan) {
    const uint32_t periods = ViolatedAfter(property, plan);
    if (periods == 0) return false;
    plan.periods = periods;
    std::erase_if(plan.events, [periods](const RunEvent& event) { return event.period > periods; });
    return true;
  };
  for (Plan plan : known_) {
    if (Late() || search.only_similar) break;
    if (violates(plan)) return plan;
  }
  for (const uint32_t stretch : kStretches) {
    if (search.similar == nullptr || Late()) break;
    Plan plan = StretchedPlanOf(*search.similar, stretch);
    if (violates(plan)) return plan;
  }
  if (search.only_similar) return std::nullopt;
  // Not the same runs each time.
  RunPlans plans(machine_, search, can_be_set_, known_, 0x9E3779B97F4A7C15 + searches_);
  for (int run = 0; run < kShortHoldRuns + kLongHoldRuns && !Late(); ++run) {
    // Long waits take longer than all of these.
    for (int steady = 0; run == kShortHoldRuns && steady < kFirstRhythms && !Late(); ++steady) {
      Plan plan = plans.AtSteadyPace(steady);
      if (violates(plan)) return plan;
    }
    Plan plan = plans.Holding(run);
    if (violates(plan)) return plan;
  }
  for (int run = 0; (run < kRandomRuns || search.thorough) && !Late(); ++run) {
    Plan plan = run % 3 != 0 ? plans.AtSteadyPace(run / 3 * 2 + run % 3) : plans.AtRandom(run);
    if (violates(plan)) return plan;
  }
  return std::nullopt;
}

bool PropertyRuns::Try(const prove::properties::Property& property, Plan& plan, Plan shorter) const {
  if (Late()) return false;
  const uint32_t periods = ViolatedAfter(property, shorter);
  if (periods == 0 || periods > plan.periods) return false;
  shorter.periods = periods;
  std::erase_if(shorter.events, [periods](const RunEvent& event) { return event.period > periods; });
  plan = std::move(shorter);
  return true;
}

/// Leaves out what need not be set, in halves and smaller pieces, and what need not be waited for.
void PropertyRuns::Shorten(const prove::properties::Property& property, Plan& plan) const {
  ShortenWaits(property, plan, Cuts::kHalves);  // first: a short run is soon tried
  for (size_t piece = std::max<size_t>(1, plan.events.size() / 2); piece > 0; piece /= 2) {
    for (size_t begin = 0; begin < plan.events.size() && !Late();) {
      Plan shorter = plan;
      const size_t end = std::min(begin + piece, shorter.events.size());
      shorter.events.erase(shorter.events.begin() + static_cast<ptrdiff_t>(begin),
                           shorter.events.begin() + static_cast<ptrdiff_t>(end));
      if (!Try(property, plan, std::move(shorter))) begin += piece;
    }
  }
  Join(property, plan);
  const bool waits = std::max(machine_.timing.slow_periods, machine_.timing.fast_periods) > 1;
  ShortenWaits(property, plan, waits ? Cuts::kEach : Cuts::kHalves);
}

/// What is set a little before something else is set with it, where that does as well.
void PropertyRuns::Join(const prove::properties::Property& property, Plan& plan) const {
  for (size_t i = 0; i + 1 < plan.events.size() && !Late();) {
    const uint32_t period = plan.events[i].period;
    size_t end = i;  // of what is set at once
    while (end < plan.events.size() && plan.events[end].period == period) ++end;
    if (end == plan.events.size()) return;
    Plan joined = plan;
    for (size_t at = i; at < end; ++at) joined.events[at].period = plan.events[end].period;
    // The same events again, now with those that follow.
    if (!Try(property, plan, std::move(joined))) i = end;
  }
}

void PropertyRuns::ShortenWaits(const prove::properties::Property& property, Plan& plan, Cuts cuts) const {
  const uint32_t most_tried = cuts == Cuts::kEach ? kMostTriedCuts : 0;
  for (size_t i = 0; i < plan.events.size(); ++i) {
    const uint32_t before = i == 0 ? 1 : plan.events[i - 1].period;
    for (uint32_t cut = std::max(plan.events[i].period - before, most_tried); cut > 0 && !Late();) {
      Plan shorter = plan;
      for (size_t later = i; later < shorter.events.size(); ++later) {
        uint32_t& period = shorter.events[later].period;
        period = period - before > cut ? period - cut : before;
      }
      if (shorter.events.back().period == plan.events.back().period) break;
      if (!Try(property, plan, std::move(shorter))) {
        cut = cut <= most_tried ? cut - 1 : cut / 2;
      } else if (i >= plan.events.size()) {
        return;
      }
    }
  }
}

std::optional<prove::properties::PropertyRun> PropertyRuns::Find(const prove::properties::RunSearch& search) {
  ++searches_;
  deadline_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(search.milliseconds);
  std::optional<Plan> plan = FindPlan(search);
  if (!plan) return std::nullopt;
  deadline_ = std::chrono::steady_clock::now() + kShorteningTime;
  Shorten(*search.property, *plan);
  if (plant_ && machine_.slices > 1) plan->periods += kSlicedPasses;
  prove::properties::PropertyRun run;
  run.has_plant = plant_ != nullptr;
  const uint32_t parts =
      machine_.compilation.program.schedule.fast_ms == 0 ? 1 : std::max(1U, machine_.timing.fast_per_period);
  run.periods.assign(plan->periods, std::vector<std::vector<prove::properties::InputValue>>(parts));
  const std::vector<bool> handshakes = prove::machine::HandshakeCells(machine_.version);
  std::map<CellId, bool> now;
  for (const RunEvent& event : plan->events) {
    const auto [at, added] = now.try_emplace(event.cell, false);
    // What the program writes, too, may be something else by now.
    const bool stays = inputs_[event.cell.index] && !handshakes[event.cell.index];
    if (!added && at->second == event.value && stays) continue;
    at->second = event.value;
    std::vector<prove::properties::InputValue>& inputs = run.periods[event.period - 1].front();
    const auto same = std::ranges::find(inputs, event.cell, &prove::properties::InputValue::cell);
    if (same == inputs.end()) {
      inputs.push_back({event.cell, event.value});
    } else {
      same->value = event.value;
    }
  }
  return run;
}

bool PropertyRuns::Late() const { return std::chrono::steady_clock::now() >= deadline_; }

}  // namespace plcxx::review::properties
