// Running: periods, steps, ways back, where it stops.

#include "transpiler/live/session.h"

#include <algorithm>
#include <utility>

#include "transpiler/engines/lockstep.h"
#include "transpiler/live/fault_statement.h"

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
      stops_at_(compilation.program.statements.size()) {}

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
  const uint64_t period = timeline_.period();
  std::ranges::fill(held_, Held());
  while (!notes_.empty() && notes_.back().period >= period) notes_.pop_back();
  ++notes_version_;
  chart_.GoBack(period);
  for (Breakpoint& breakpoint : breakpoints_) {
    breakpoint.last.reset();
    if (breakpoint.condition) breakpoint.condition->Forget();
  }
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

Machine::StopAt Session::StatementStops() {
  if (std::ranges::none_of(stops_at_, [](bool stops) { return stops; })) return nullptr;
  return [this](ir::StatementId statement) { return stops_at_[statement.index]; };
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
  if (!timeline_.Forward(advance, StatementStops())) {
    Pause(timeline_.is_between() ? "the program does not come to the end of this period"
                                 : "at a statement with a breakpoint");
    return false;
  }
  Observe(period);
  LetButtonsGo();
  std::string why = BreaksAfterPeriod();
  if (why.empty()) return true;
  Pause(std::move(why));
  return false;
}

void Session::AddNote(Note note) {
  notes_.push_back(std::move(note));
  if (notes_.size() > kMostNotes) notes_.pop_front();
  ++notes_version_;
}

void Session::Observe(uint64_t period) {
  Machine& machine = timeline_.machine();
  const uint64_t time_ms = machine.time_ms();
  for (const scenarios::ShownMessage& message : machine.control().TakeMessages()) {
    const std::string& shown = message.shown.empty() ? scenarios::TextOf(message) : message.shown;
    AddNote({period, time_ms, NoteKind::kMessage, std::to_string(message.number) + "  " + shown, {}});
  }
  for (const sim::HostEvent& event : machine.simulator().TakeEvents()) {
    if (event.exchange || program().host_functions[event.function].polled) continue;
    const std::optional<ir::StatementId> statement = FaultStatement(program(), event);
    AddNote({period, time_ms, statement ? NoteKind::kFault : NoteKind::kCall, engines::ToText(program(), event),
             statement.value_or(ir::StatementId())});
  }
  chart_.Record(period, time_ms, machine.control().Reader(), machine.simulator(), machine.last_part());
}

std::string Session::BreaksAfterPeriod() {
  Machine& machine = timeline_.machine();
  std::string why;
  for (Breakpoint& breakpoint : breakpoints_) {
    if (breakpoint.location) {
      const uint64_t now = machine.control().Reader()(*breakpoint.location);
      const std::optional<uint64_t> before = std::exchange(breakpoint.last, now);
      if (before && *before != now && why.empty()) why = breakpoint.text + " has changed";
    }
    if (breakpoint.condition && breakpoint.condition->Comes(machine.simulator(), machine.last_part()) && why.empty()) {
      why = "the condition has come: " + breakpoint.text;
    }
  }
  return why;
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
        LetButtonsGo();
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
