#include "transpiler/live/opened.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/property_places.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::live {
namespace {

/// What a scenario may run at most while it is opened, in periods.
constexpr uint64_t kMostPeriods = 1'000'000;

class Opener {
 public:
  Opener(Session& session, const scenarios::Scenario& scenario, const scenarios::ScenarioPlan& plan)
      : session_(session), scenario_(scenario), plan_(plan), program_(session.program()) {}

  Opened Run() {
    if (Refusal refusal = MakeMonitor(); !refusal.empty()) return {{}, refusal};
    session_.Restart();
    if (monitor_) monitor_->PowerOn();
    for (const scenarios::PlannedStep& step : plan_.steps) {
      step_ = &step;
      std::visit([this](const auto& action) { Do(action); }, step.written->action);
      if (!refusal_.empty()) return {{}, refusal_};
      if (!failure_.empty()) return {Where() + failure_, {}};
    }
    return {scenario_.path + ": at its end", {}};
  }

 private:
  std::string Where() const {
    return scenario_.path + ":" + std::to_string(step_->written->mark.line) + ": step " +
           std::to_string(step_->written->number) + " (" + step_->written->name + "): ";
  }

  Refusal MakeMonitor() {
    if (scenario_.properties.empty()) return {};
    const dialects::Dialect& dialect = *session_.compilation().dialect;
    cells_ = execute::MakeCells(program_);
    std::vector<scenarios::ScenarioError> errors;
    auto properties = scenarios::WatchedProperties(
        scenario_, dialect.name, scenarios::PropertyContextOf(dialect, program_, cells_, scenarios::TimingOf(program_)),
        errors);
    if (!errors.empty()) return ToText(errors.front());
    monitor_.emplace(program_, cells_, std::move(properties));
    return {};
  }

  void DoEach(ActionKind kind) {
    for (const scenarios::PlannedValue& planned : step_->values) {
      if (planned.location.absent) continue;  // it changes nothing that is executed
      session_.DoRecorded({.kind = planned.location.text_input ? ActionKind::kText : kind,
                           .name = planned.written.text,
                           .location = planned.location,
                           .value = planned.value,
                           .text = planned.text,
                           .statement = {}});
    }
  }

  void Do(const scenarios::SetStep&) { DoEach(ActionKind::kSet); }
  void Do(const scenarios::ForceStep&) { DoEach(ActionKind::kForce); }
  void Do(const scenarios::ReleaseStep&) { DoEach(ActionKind::kRelease); }
  void Do(const scenarios::ExpectCallsStep&) {}
  void Do(const scenarios::ExpectMessagesStep&) {}

  void Do(const scenarios::PowerCycleStep&) {
    session_.DoRecorded({.kind = ActionKind::kPowerCycle, .name = {}, .location = {}, .text = {}, .statement = {}});
    if (monitor_) monitor_->PowerOn();
  }

  void Do(const scenarios::ExpectStep&) {
    for (const scenarios::PlannedValue& planned : step_->values) {
      const dialects::Location& location = planned.location;
      if (location.text_input || location.absent) continue;
      const uint64_t found = session_.timeline().machine().Read(location);
      const ir::Type type = location.place.type;
      if (sim::SameValue(type, found, planned.value)) continue;
      const sim::Sign sign = scenarios::SignOf(location);
      failure_ += (failure_.empty() ? "" : "; ") + planned.written.text + " is " + sim::ValueDigits(type, found, sign) +
                  ", expected " + sim::ValueDigits(type, planned.value, sign);
    }
  }

  void Do(const scenarios::RunStep& run) {
    for (const scenarios::RunPart& part : run.parts) {
      switch (part.unit) {
        case scenarios::RunUnit::kMilliseconds:
          RunMs(part.count);
          break;
        case scenarios::RunUnit::kSlowCycles:
          RunParts(AdvanceKind::kSlowPeriod,
                   program_.schedule.fast_ms == 0 ? program_.schedule.slow_done : ir::PlaceId(), part.count);
          break;
        case scenarios::RunUnit::kFastTicks:
          RunParts(AdvanceKind::kFastPeriod,
                   program_.schedule.fast_ms == 0 ? program_.schedule.fast_done : ir::PlaceId(), part.count);
          break;
      }
    }
  }

  /// Period by period on the grid of periods; what is off it as one piece, for the end of a run is a moment of its own.
  void RunMs(uint32_t ms) {
    const uint32_t unit = session_.unit_ms();
    const bool on_grid = session_.timeline().machine().time_ms() % unit == 0;
    while (on_grid && ms >= unit && failure_.empty()) {
      Advance({.kind = AdvanceKind::kMs, .ms = unit});
      ms -= unit;
    }
    if (ms != 0 && failure_.empty()) Advance({.kind = AdvanceKind::kMs, .ms = ms});
  }

  /// As sim::Clock counts them.
  void RunParts(AdvanceKind kind, ir::PlaceId counter, uint32_t count) {
    const auto completed = [&] {
      return static_cast<uint32_t>(session_.timeline().machine().simulator().Read(program_.places[counter]));
    };
    for (uint32_t done = 0; done < count && failure_.empty();) {
      if (!counter.valid()) {
        Advance({.kind = kind});
        ++done;
        continue;
      }
      const uint32_t before = completed();
      uint32_t more = 0;
      for (uint32_t periods = 0; more == 0 && failure_.empty(); ++periods) {
        if (periods == program_.schedule.most_periods) {
          failure_ = "the part was not completed within " + std::to_string(periods) + " periods";
          return;
        }
        Advance({.kind = kind});
        more = completed() - before;
      }
      done += std::min(more, count - done);
    }
  }

  void Advance(const live::Advance& advance) {
    if (++periods_ > kMostPeriods) {
      failure_ = "it runs longer than a scenario is opened for";
      return;
    }
    session_.RunRecorded(advance);
    if (!monitor_) return;
    Machine& machine = session_.timeline().machine();
    monitor_->AfterPart(machine.simulator(), machine.last_part());
    if (monitor_->violation()) failure_ = *monitor_->violation();
  }

  Session& session_;
  const scenarios::Scenario& scenario_;
  const scenarios::ScenarioPlan& plan_;
  const ir::Program& program_;
  execute::Cells cells_;
  std::optional<scenarios::PropertyMonitor> monitor_;
  const scenarios::PlannedStep* step_ = nullptr;
  std::string failure_;
  Refusal refusal_;
  uint64_t periods_ = 0;
};

}  // namespace

Opened OpenScenario(Session& session, const scenarios::Scenario& scenario, const scenarios::ScenarioPlan& plan) {
  Opened opened = Opener(session, scenario, plan).Run();
  session.SetOpened(opened.text);
  return opened;
}

}  // namespace plcxx::live
