// Running: periods, steps, ways back, where it stops.

#include "transpiler/live/session.h"

#include <algorithm>
#include <utility>

#include "transpiler/engines/lockstep.h"
#include "transpiler/live/fault_statement.h"
#include "transpiler/live/locations.h"

namespace plcxx::live {
namespace {

constexpr const char* kOffText = "the machine is switched off";

}  // namespace

Session::Session(const compilation::Compilation& compilation, const report::ProgramInput& input)
    : compilation_(compilation),
      names_(compilation.program),
      input_(input),
      uses_(report::MakeCrossReference(input)),
      signals_(MakeSignals(compilation, uses_)),
      conditions_(compilation),
      timeline_(compilation),
      breakpoints_(compilation.program),
      hands_(timeline_, [this](Action action) { Do(std::move(action)); }) {}

void Session::Equip(std::shared_ptr<const scenarios::BoundPlant> plant, std::shared_ptr<const BoundPanel> panel) {
  plant_ = std::move(plant);
  hands_.Equip(std::move(panel));
  timeline_.Attach(plant_);
  Restart();
}

void Session::BeginAnew() {
  Restart();
  hands_.PutAsDelivered();
}

void Session::Restart() {
  timeline_.Restart();
  is_on_ = true;
  is_running_ = false;
  opened_.clear();
  why_stopped_.clear();
  WentElsewhere();
}

/// The machine is at a moment that does not follow from the one before.
void Session::WentElsewhere() {
  timeline_.machine().simulator().TakeEvents();
  timeline_.machine().control().TakeMessages();
  hands_.TakeOff();
  notes_.GoBack(timeline_.period());
  chart_.GoBack(timeline_.period());
  breakpoints_.Forget();
  FindForced();
}

void Session::FindForced() {
  forced_.clear();
  for (const Entry& entry : timeline_.entries()) {
    if (entry.period > timeline_.period()) break;
    const Action& action = entry.action;
    if (action.kind == ActionKind::kForce || action.kind == ActionKind::kRelease) {
      std::erase_if(forced_, [&](const Forced& forced) { return forced.name == action.name; });
    }
    if (action.kind == ActionKind::kForce) forced_.push_back({action.name, action.location, action.value});
  }
}

std::variant<dialects::Location, std::string> Session::Find(const std::string& name) const {
  return FindLocation(*compilation_.dialect, names_, name);
}

Refusal Session::Do(Action action) {
  if (!timeline_.is_between()) {
    const uint64_t period = timeline_.period();
    timeline_.Forward({}, nullptr);
    Observe(period);
  }
  timeline_.Do(std::move(action));
  FindForced();
  return {};
}

std::string Session::DriverOf(const dialects::Location& location) const {
  const plant::Driven* const driver = plant_ ? plant_->DriverOf(location) : nullptr;
  return driver == nullptr ? std::string() : scenarios::DriverText(*driver, plant_->model().path());
}

Refusal Session::PowerOff() {
  if (!is_on_) return "the machine is off already";
  Pause("switched off");
  is_on_ = false;
  return {};
}

Refusal Session::PowerOn() {
  if (is_on_) return "the machine is on already";
  is_on_ = true;
  why_stopped_.clear();
  const std::vector<ControlState> panel = hands_.States();
  hands_.TakeOff();
  Do({.kind = ActionKind::kPowerCycle, .name = {}, .location = {}, .text = {}, .statement = {}});
  hands_.PutBack(panel);
  return {};
}

Refusal Session::Run() {
  if (!is_on_) return kOffText;
  is_running_ = true;
  why_stopped_.clear();
  return {};
}

void Session::Pause(std::string why) {
  is_running_ = false;
  why_stopped_ = std::move(why);
}

Refusal Session::SetSpeed(double times) {
  constexpr double kSlowest = 0.001, kFastest = 1000;
  if (!(times == 0 || (times >= kSlowest && times <= kFastest))) return "a speed is 0.001 to 1000, or 0 for no limit";
  speed_ = times;
  return {};
}

uint64_t Session::RunPeriods(uint64_t most) {
  for (uint64_t done = 0; done < most; ++done) {
    if (!is_running_) return done;
    if (!Period({.kind = AdvanceKind::kMs, .ms = unit_ms()})) return done + 1;
  }
  return most;
}

bool Session::Period(const Advance& advance) {
  const uint64_t period = timeline_.period();
  if (!timeline_.Forward(advance, breakpoints_.StatementStops())) {
    Pause(timeline_.is_between() ? "the program does not come to the end of this period"
                                 : "at a statement with a breakpoint");
    return false;
  }
  Observe(period);
  hands_.LetButtonsGo();
  std::string why = breakpoints_.AfterPeriod(timeline_.machine());
  if (why.empty()) return true;
  Pause(std::move(why));
  return false;
}

void Session::Observe(uint64_t period) {
  Machine& machine = timeline_.machine();
  const uint64_t time_ms = machine.time_ms();
  for (const scenarios::ShownMessage& message : machine.control().TakeMessages()) {
    const std::string& shown = message.shown.empty() ? scenarios::TextOf(message) : message.shown;
    notes_.Add({period, time_ms, NoteKind::kMessage, std::to_string(message.number) + "  " + shown, {}});
  }
  for (const sim::HostEvent& event : machine.simulator().TakeEvents()) {
    if (event.exchange || program().host_functions[event.function].polled) continue;
    const std::optional<ir::StatementId> statement = FaultStatement(program(), event);
    notes_.Add({period, time_ms, statement ? NoteKind::kFault : NoteKind::kCall, engines::ToText(program(), event),
                statement.value_or(ir::StatementId())});
  }
  chart_.Record(period, time_ms, machine.control().Reader(), machine.simulator(), machine.last_part());
}

uint64_t Session::Count(ir::PlaceId counter) { return timeline_.machine().simulator().Read(program().places[counter]); }

Refusal Session::StepUntil(ir::PlaceId counter) {
  const uint64_t before = Count(counter);
  for (uint32_t periods = 0; periods < program().schedule.most_periods; ++periods) {
    if (!Period({.kind = AdvanceKind::kMs, .ms = unit_ms()}) || Count(counter) != before) return {};
  }
  return "the part was not completed within " + std::to_string(program().schedule.most_periods) + " periods";
}

bool Session::CanStep(StepKind kind) const {
  const ir::Schedule& schedule = program().schedule;
  const auto is_sliced = [](const ir::Routine& routine) { return routine.sliced && routine.slices > 1; };
  switch (kind) {
    case StepKind::kPeriod:
    case StepKind::kStatement:
      return true;
    case StepKind::kFast:
      return schedule.fast_ms != 0 || schedule.fast_done.valid();
    case StepKind::kSlow:
      return schedule.fast_ms != 0 || schedule.slow_done.valid();
    case StepKind::kSlice:
      return std::ranges::any_of(program().routines, is_sliced);
  }
  return false;
}

Refusal Session::Step(StepKind kind) {
  if (!is_on_) return kOffText;
  if (!CanStep(kind)) return "this program has no such part";
  Pause("");
  const ir::Schedule& schedule = program().schedule;
  const Advance unit{.kind = AdvanceKind::kMs, .ms = unit_ms()};
  switch (kind) {
    case StepKind::kPeriod:
    case StepKind::kSlice:
      Period(unit);
      return {};
    case StepKind::kFast:
      if (schedule.fast_done.valid()) return StepUntil(schedule.fast_done);
      Period(unit);
      return {};
    case StepKind::kSlow: {
      if (schedule.fast_ms == 0) return StepUntil(schedule.slow_done);
      const uint32_t most = schedule.period_ms / schedule.fast_ms + 1;
      for (uint32_t i = 0; i < most; ++i) {
        if (!Period(unit) || timeline_.machine().last_part() == sim::Clock::Part::kWholePeriod) return {};
      }
      return {};
    }
    case StepKind::kStatement: {
      // In a later period where this one has no other: not each of them has a part that is due.
      const auto always = [](ir::StatementId) { return true; };
      for (uint32_t periods = 0; periods < schedule.most_periods; ++periods) {
        const uint64_t period = timeline_.period();
        if (!timeline_.Forward(unit, always)) return {};
        Observe(period);
        hands_.LetButtonsGo();
      }
      return "no statement was executed in " + std::to_string(schedule.most_periods) + " periods";
    }
  }
  return {};
}

Refusal Session::Back(uint64_t periods) {
  if (periods == 0 || periods > kMostBack) return "the way back is 1 to 10000 periods";
  if (timeline_.is_between() && timeline_.period() == timeline_.first()) return "nothing is known of before";
  Pause("");
  timeline_.Back(periods);
  WentElsewhere();
  return {};
}

Refusal Session::BackStatement() {
  if (timeline_.is_between() && timeline_.period() == timeline_.first()) return "nothing is known of before";
  Pause("");
  timeline_.BackStatement();
  WentElsewhere();
  return {};
}

Refusal Session::GoTo(uint64_t period) {
  if (period < timeline_.first() || period > timeline_.end()) {
    return "known are the periods " + std::to_string(timeline_.first()) + " to " + std::to_string(timeline_.end());
  }
  Pause("");
  timeline_.GoTo(period);
  WentElsewhere();
  return {};
}

void Session::DoRecorded(Action action) {
  timeline_.Do(std::move(action));
  FindForced();
}

void Session::RunRecorded(const Advance& advance) {
  const uint64_t period = timeline_.period();
  timeline_.Forward(advance, nullptr);
  Observe(period);
}

}  // namespace plcxx::live
