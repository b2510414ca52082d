#include "transpiler/mutate/side_by_side.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "transpiler/ir/facts.h"
#include "transpiler/scenarios/calls.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/check.h"

namespace plcxx::mutate {
namespace {

using scenarios::PlannedStep;
using scenarios::PlannedValue;
using scenarios::ScenarioControl;

enum class Piece : uint8_t { kPowerOn, kPeriod, kFastOnly, kElapse };

/// The clock does not know how many machines there are.
class Driven : public sim::Clocked {
 public:
  Driven(sim::Engine& original, std::function<void(Piece, uint32_t)> run) : original_(original), run_(std::move(run)) {}
  void PowerOn() override { run_(Piece::kPowerOn, 0); }
  void RunPeriod(uint32_t now_ms) override { run_(Piece::kPeriod, now_ms); }
  void RunFastOnly(uint32_t now_ms) override { run_(Piece::kFastOnly, now_ms); }
  void RunElapse(uint32_t now_ms) override { run_(Piece::kElapse, now_ms); }
  uint64_t Read(const ir::Place& place) override { return original_.Read(place); }
  /// A power cycle is done machine by machine.
  void StoreRetentive() override { PLCXX_UNREACHABLE(); }

 private:
  sim::Engine& original_;
  std::function<void(Piece, uint32_t)> run_;
};

bool SameEvents(const std::vector<sim::HostEvent>& one, const std::vector<sim::HostEvent>& other) {
  return std::ranges::equal(
      one, other, [](const sim::HostEvent& a, const sim::HostEvent& b) { return a == b && a.exchange == b.exchange; });
}

class Runner {
 public:
  Runner(const SideBySide& request, const scenarios::ScenarioPlan& plan,
         std::unique_ptr<scenarios::PropertyMonitor> monitor)
      : request_(request),
        plan_(plan),
        program_(request.compilation.program),
        simulator_(program_),
        driven_(simulator_, [this](Piece piece, uint32_t now_ms) { RunOriginal(piece, now_ms); }),
        clock_(program_, {&driven_}),
        control_(program_, *request.compilation.dialect, simulator_, scenarios::StubOf(request.compilation)),
        monitor_(std::move(monitor)),
        endings_(request.changes.size(), Ending::kPasses),
        undecided_(request.changes.size()) {
    clock_.before_period = [this](uint32_t now_ms) {
      NoteStart();
      control_.BeforePeriod(now_ms);
    };
    clock_.after_period = [this](uint32_t now_ms) {
      AfterPeriod(now_ms);
      RunOthers(clock_.last_part() == sim::Clock::Part::kFastOnly ? Piece::kFastOnly : Piece::kPeriod, now_ms);
    };
    clock_.interrupted = [this] { return undecided_ == 0; };
    simulator_.StopWhen([this] { return simulator_.executed() > stop_at_; });
    simulator_.changes().LookForDifferences(request.changes);
    for (const PlannedStep& step : plan.steps) {
      looks_at_calls_ |= std::holds_alternative<scenarios::ExpectCallsStep>(step.written->action);
      looks_at_messages_ |= std::holds_alternative<scenarios::ExpectMessagesStep>(step.written->action);
    }
    if (!looks_at_messages_) control_.LookAway();
  }

  std::vector<Ending> Run() {
    if (plan_.plant) control_.Attach(plan_.plant);
    PowerOn();
    for (const PlannedStep& step : plan_.steps) {
      if (undecided_ == 0) break;
      std::visit([&](const auto& action) { Do(step, action); }, step.written->action);
    }
    return std::move(endings_);
  }

 private:
  /// All that decides how a machine goes on, and whether what is expected of it later holds.
  struct Moment {
    sim::Simulator::Saved memory;
    ScenarioControl::Moment control;
    std::optional<scenarios::PropertyMonitor::Moment> properties;
    std::vector<sim::HostEvent> calls;
  };
  /// A machine that is not the original's any more.
  struct Changed {
    uint32_t change = 0;
    Moment moment;
    uint64_t executed = 0;  // instructions, those of the original before it included
    std::optional<Ending> ending;
    bool is_original = false;  // again
  };

  // --- which machine is in the simulator; between two pieces and steps it is the original ---

  void NoteStart() {
    start_.emplace(Moment{.memory = simulator_.Save(), .control = control_.Now(), .properties = {}, .calls = {}});
    if (monitor_) start_->properties = monitor_->Now();
    calls_at_start_ = calls_.size();
  }

  Moment Start() const {
    Moment moment{
        .memory = start_->memory, .control = start_->control.Clone(), .properties = start_->properties, .calls = {}};
    moment.calls.assign(calls_.begin(), calls_.begin() + static_cast<std::ptrdiff_t>(calls_at_start_));
    return moment;
  }

  void Exchange(Moment& other) {
    simulator_.Exchange(other.memory);
    control_.Exchange(other.control);
    if (monitor_) monitor_->Exchange(*other.properties);
    std::swap(calls_, other.calls);
  }

  bool IsOriginal(const Moment& other) const {
    return simulator_.IsAt(other.memory) && control_.IsAt(other.control) &&
           (!monitor_ || monitor_->Now() == *other.properties) && SameEvents(calls_, other.calls);
  }

  /// Of each machine, the original first.
  template <class Visit>
  void ForEach(Visit&& visit) {
    visit();
    ForEachChanged([&](Changed&) { visit(); });
  }
  template <class Visit>
  void ForEachChanged(Visit&& visit) {
    for (Changed& one : changed_) {
      Exchange(one.moment);
      visit(one);
      Exchange(one.moment);
    }
    Judge();
  }

  /// Takes out those that have ended, and those that are the original again.
  void Judge() {
    std::erase_if(changed_, [this](const Changed& one) {
      if (one.is_original) simulator_.changes().LookFor(one.change, true);
      if (!one.ending) return one.is_original;
      endings_[one.change] = *one.ending;
      --undecided_;
      if (*one.ending == Ending::kFails && request_.failed) request_.failed(one.change);
      return true;
    });
  }

  // --- pieces of the program ---

  void Execute(Piece piece, uint32_t now_ms) {
    switch (piece) {
      case Piece::kPowerOn:
        simulator_.PowerOn();
        break;
      case Piece::kPeriod:
        simulator_.RunPeriod(now_ms);
        break;
      case Piece::kFastOnly:
        simulator_.RunFastOnly(now_ms);
        break;
      case Piece::kElapse:
        simulator_.RunElapse(now_ms);
        break;
    }
    std::vector<sim::HostEvent> calls = simulator_.TakeEvents();
    false_fact_ = false_fact_function_.valid() &&
                  std::ranges::find(calls, false_fact_function_, &sim::HostEvent::function) != calls.end();
    if (looks_at_calls_) std::ranges::move(calls, std::back_inserter(calls_));
  }

  void AfterPeriod(uint32_t now_ms) {
    control_.AfterPeriod(now_ms);
    if (monitor_) monitor_->AfterPart(simulator_, clock_.last_part());
  }

  static bool IsPeriod(Piece piece) { return piece == Piece::kPeriod || piece == Piece::kFastOnly; }

  void RunOriginal(Piece piece, uint32_t now_ms) {
    if (!IsPeriod(piece)) NoteStart();
    const uint64_t before = simulator_.executed();
    executed_at_start_ = executed_;
    Execute(piece, now_ms);
    executed_ += simulator_.executed() - before;
    if (!IsPeriod(piece)) RunOthers(piece, now_ms);
  }

  /// What counts the scheduler's parts: the clock goes by them.
  std::pair<uint64_t, uint64_t> Counts() {
    const ir::Schedule& schedule = program_.schedule;
    const auto read = [this](ir::PlaceId place) { return place.valid() ? simulator_.Read(program_.places[place]) : 0; };
    return {read(schedule.slow_done), read(schedule.fast_done)};
  }

  void RunOthers(Piece piece, uint32_t now_ms) {
    for (const uint32_t change : simulator_.changes().TakeDifferences())
      changed_.push_back(
          {.change = change, .moment = Start(), .executed = executed_at_start_, .ending = {}, .is_original = false});
    if (changed_.empty()) return;
    const auto counts = Counts();
    for (Changed& one : changed_) {
      Exchange(one.moment);
      RunChanged(one, piece, now_ms);
      if (!one.ending && Counts() != counts) one.ending = Ending::kUnclear;
      Exchange(one.moment);
      one.is_original = !one.ending && IsOriginal(one.moment);
    }
    stop_at_ = UINT64_MAX;
    simulator_.changes().Change({});
    Judge();
  }

  void RunChanged(Changed& one, Piece piece, uint32_t now_ms) {
    simulator_.changes().Change(request_.changes[one.change]);
    const uint64_t before = simulator_.executed();
    stop_at_ = before + (request_.most - std::min(request_.most, one.executed));
    if (IsPeriod(piece)) control_.BeforePeriod(now_ms);
    Execute(piece, now_ms);
    one.executed += simulator_.executed() - before;
    if (simulator_.stopped() || false_fact_) {
      one.ending = Ending::kFails;
      return;
    }
    if (IsPeriod(piece)) AfterPeriod(now_ms);
    if (monitor_ && monitor_->violation()) one.ending = Ending::kFails;
  }

  void PowerOn() {
    clock_.PowerOn();
    ForEach([this] {
      control_.PowerOn();
      if (monitor_) monitor_->PowerOn();
    });
  }

  // --- steps; a location that the program does not have is the same in all machines, and nothing new ---

  void Do(const PlannedStep& step, const scenarios::SetStep&) {
    ForEach([&] {
      for (const PlannedValue& planned : step.values) {
        if (planned.location.text_input) {
          simulator_.SendText(planned.text);
        } else if (!planned.location.absent) {
          control_.Set(planned.location, planned.value);
        }
      }
    });
  }

  template <class Visit>
  void ForEachPlace(const PlannedStep& step, Visit&& visit) {
    ForEach([&] {
      for (const PlannedValue& planned : step.values) {
        if (planned.location.absent) continue;
        for (const auto& [place, value] : scenarios::WritesTo(planned.location, planned.value)) visit(place, value);
      }
    });
  }
  void Do(const PlannedStep& step, const scenarios::ForceStep&) {
    ForEachPlace(step, [this](const ir::Place& place, uint64_t value) { simulator_.Force(place, value); });
  }
  void Do(const PlannedStep& step, const scenarios::ReleaseStep&) {
    ForEachPlace(step, [this](const ir::Place& place, uint64_t) { simulator_.Release(place); });
  }

  void Do(const PlannedStep&, const scenarios::RunStep& run) {
    for (const scenarios::RunPart& part : run.parts) scenarios::RunOn(clock_, part);
  }

  void Do(const PlannedStep& step, const scenarios::ExpectStep&) {
    ForEachChanged([&](Changed& one) {
      const bool holds =
          std::ranges::all_of(step.values, [this](const PlannedValue& planned) { return Holds(planned); });
      if (!holds) one.ending = Ending::kFails;
    });
  }
  bool Holds(const PlannedValue& planned) {
    const dialects::Location& location = planned.location;
    if (location.absent) return true;
    return sim::SameValue(location.place.type, control_.Read(location), planned.value);
  }

  void Do(const PlannedStep& step, const scenarios::ExpectCallsStep&) {
    ForEachChanged([&](Changed& one) {
      if (scenarios::CallsMismatch(program_, step.calls, calls_)) one.ending = Ending::kFails;
      calls_.clear();
    });
    calls_.clear();
  }

  void Do(const PlannedStep&, const scenarios::ExpectMessagesStep& expect) {
    ForEachChanged([&](Changed& one) {
      const std::vector<scenarios::ShownMessage> shown = control_.TakeMessages();
      if (!std::ranges::equal(expect.messages, shown, scenarios::Names)) one.ending = Ending::kFails;
    });
    control_.TakeMessages();
  }

  void Do(const PlannedStep&, const scenarios::PowerCycleStep&) {
    ForEach([this] {
      control_.PowerOff();
      sim::Clock::PowerOff(program_, simulator_);
    });
    PowerOn();
  }

  const SideBySide& request_;
  const scenarios::ScenarioPlan& plan_;
  const ir::Program& program_;
  sim::Simulator simulator_;
  Driven driven_;
  sim::Clock clock_;
  ScenarioControl control_;
  std::unique_ptr<scenarios::PropertyMonitor> monitor_;
  std::vector<sim::HostEvent> calls_;  // since they were looked at
  std::optional<Moment> start_;        // of the original, at the beginning of the piece; without calls
  size_t calls_at_start_ = 0;
  uint64_t executed_ = 0, executed_at_start_ = 0;  // by the original
  uint64_t stop_at_ = UINT64_MAX;
  const ir::HostFunctionId false_fact_function_ = ir::FalseFactOf(program_);
  bool false_fact_ = false;  // was found in the last piece
  std::vector<Changed> changed_;
  std::vector<Ending> endings_;
  size_t undecided_;
  bool looks_at_calls_ = false, looks_at_messages_ = false;
};

}  // namespace

std::vector<Ending> RunSideBySide(const SideBySide& request) {
  const compilation::Compilation& compilation = request.compilation;
  const auto plan = scenarios::PlanScenario(request.scenario, *compilation.dialect, compilation.program);
  std::vector<scenarios::ScenarioError> errors;
  std::unique_ptr<scenarios::PropertyMonitor> monitor = scenarios::MonitorOf(request.scenario, compilation, errors);
  const auto* const planned = std::get_if<scenarios::ScenarioPlan>(&plan);
  PLCXX_CHECK(planned != nullptr && errors.empty());  // it was run before
  return Runner(request, *planned, std::move(monitor)).Run();
}

}  // namespace plcxx::mutate
