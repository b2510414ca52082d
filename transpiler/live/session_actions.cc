// What the operator does to the machine, and what he asks to be told of.

#include <algorithm>
#include <utility>

#include "transpiler/live/locations.h"
#include "transpiler/live/session.h"
#include "transpiler/sim/active_messages.h"

namespace plcxx::live {
namespace {

constexpr size_t kMostTyped = 256;  // bytes of what an operator types

}  // namespace

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

Refusal Session::Set(const std::string& name, const std::string& value) {
  const auto found = Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (const std::string driver = DriverOf(location); !driver.empty()) {
    return "'" + name + "' is driven by the plant, " + driver + ": force it to hold it";
  }
  if (location.text_input) {
    if (value.size() > kMostTyped) return "the text is too long";
    return Do({.kind = ActionKind::kText, .name = name, .location = location, .text = value, .statement = {}});
  }
  const auto bits = FindValue(compilation_, name, location, value);
  if (const auto* refusal = std::get_if<std::string>(&bits)) return *refusal;
  return Do({.kind = ActionKind::kSet,
             .name = name,
             .location = location,
             .value = std::get<uint64_t>(bits),
             .text = {},
             .statement = {}});
}

Refusal Session::Toggle(const std::string& name) {
  const auto found = Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input || location.place.type != ir::Type::kBit) return "only a bit has two values";
  const bool is_on = timeline_.machine().Read(location) != 0;
  const bool is_forced = std::ranges::any_of(forced_, [&](const Forced& forced) { return forced.name == name; });
  return is_forced ? Force(name, is_on ? "0" : "1") : Set(name, is_on ? "0" : "1");
}

Refusal Session::Force(const std::string& name, const std::string& value) {
  const auto found = Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (std::string why = CannotBeForced(compilation_, location); !why.empty()) return why;
  const auto bits = FindValue(compilation_, name, location, value);
  if (const auto* refusal = std::get_if<std::string>(&bits)) return *refusal;
  return Do({.kind = ActionKind::kForce,
             .name = name,
             .location = location,
             .value = std::get<uint64_t>(bits),
             .text = {},
             .statement = {}});
}

Refusal Session::Release(const std::string& name) {
  const auto forced = std::ranges::find(forced_, name, &Forced::name);
  if (forced == forced_.end()) return "'" + name + "' is not forced";
  return Do({.kind = ActionKind::kRelease, .name = name, .location = forced->location, .text = {}, .statement = {}});
}

Refusal Session::ReleaseAll() {
  for (const Forced& forced : std::vector<Forced>(forced_)) Release(forced.name);
  return {};
}

Refusal Session::SwitchStatement(ir::StatementId statement, bool on) {
  if (statement.index >= program().statements.size()) return "there is no such statement";
  if (timeline_.machine().IsOff(statement) != on) return {};
  return Do({.kind = on ? ActionKind::kSwitchOn : ActionKind::kSwitchOff,
             .name = {},
             .location = {},
             .text = {},
             .statement = statement});
}

Refusal Session::SwitchAllOn() {
  for (uint32_t i = 0; i < program().statements.size(); ++i) SwitchStatement(ir::StatementId(i), true);
  return {};
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
  const std::vector<ControlState> panel = PanelStates();
  std::ranges::fill(held_, Held());
  Do({.kind = ActionKind::kPowerCycle, .name = {}, .location = {}, .text = {}, .statement = {}});
  PutPanelBack(panel);
  return {};
}

Refusal Session::Expect(const std::vector<std::string>& names) {
  if (names.empty()) return "nothing is named that could be expected";
  if (!timeline_.is_between()) return "the period is half done, and a scenario expects between two";
  std::vector<Action> expected;
  for (const std::string& name : names) {
    const auto found = Find(name);
    if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input) return "what the operator types cannot be read";
    expected.push_back({.kind = ActionKind::kExpect,
                        .name = name,
                        .location = location,
                        .value = timeline_.machine().Read(location),
                        .text = {},
                        .statement = {}});
  }
  for (Action& action : expected) Do(std::move(action));
  return {};
}

Refusal Session::ExpectMessages() {
  if (!timeline_.is_between()) return "the period is half done, and a scenario expects between two";
  uint64_t since = 0;
  for (const Entry& entry : timeline_.entries()) {
    if (entry.action.kind == ActionKind::kExpectMessages) since = entry.period;
  }
  Action action{.kind = ActionKind::kExpectMessages, .name = {}, .location = {}, .text = {}, .statement = {}};
  if (notes_.size() == kMostNotes && notes_.front().period >= since) {
    return "there were more messages than are kept: expect them sooner";
  }
  for (const Note& note : notes_) {
    if (note.kind != NoteKind::kMessage || note.period < since) continue;
    action.messages.push_back(note.text.substr(0, note.text.find(' ')));
  }
  return Do(std::move(action));
}

std::vector<std::string> Session::ActiveMessages() {
  std::vector<std::string> texts;
  for (const uint32_t number : sim::ActiveMessages(program(), timeline_.machine().simulator())) {
    const auto declared = std::ranges::find(program().messages, number, &ir::MessageText::number);
    texts.push_back(std::to_string(number) + (declared == program().messages.end() ? "" : "  " + declared->text));
  }
  return texts;
}

Refusal Session::BreakAtStatement(ir::StatementId statement, bool on) {
  if (statement.index >= program().statements.size()) return "there is no such statement";
  if (stops_at_[statement.index] == on) return {};
  if (!on) {
    std::erase_if(breakpoints_, [&](const Breakpoint& breakpoint) { return breakpoint.statement == statement; });
  } else {
    if (breakpoints_.size() == kMostBreakpoints) return "there are 64 breakpoints already";
    breakpoints_.push_back({.number = next_breakpoint_++,
                            .kind = BreakKind::kStatement,
                            .text = program().statements[statement].subject,
                            .statement = statement,
                            .location = {},
                            .last = {},
                            .condition = {}});
  }
  stops_at_[statement.index] = on;
  return {};
}

Refusal Session::BreakAtChange(const std::string& name) {
  if (breakpoints_.size() == kMostBreakpoints) return "there are 64 breakpoints already";
  const auto found = Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input) return "what the operator types cannot be read";
  breakpoints_.push_back({.number = next_breakpoint_++,
                          .kind = BreakKind::kChange,
                          .text = name,
                          .statement = {},
                          .location = scenarios::WatchLocation(program(), name, location),
                          .last = timeline_.machine().Read(location),
                          .condition = {}});
  return {};
}

Refusal Session::BreakAtCondition(const std::string& text) {
  if (breakpoints_.size() == kMostBreakpoints) return "there are 64 breakpoints already";
  auto parsed = Condition::Parse(conditions_, text);
  if (const auto* refusal = std::get_if<std::string>(&parsed)) return *refusal;
  Machine& machine = timeline_.machine();
  std::get<Condition>(parsed).Comes(machine.simulator(), machine.last_part());  // what is so already does not come
  breakpoints_.push_back({.number = next_breakpoint_++,
                          .kind = BreakKind::kCondition,
                          .text = text,
                          .statement = {},
                          .location = {},
                          .last = {},
                          .condition = std::move(std::get<Condition>(parsed))});
  return {};
}

Refusal Session::RemoveBreakpoint(uint32_t number) {
  const auto found = std::ranges::find(breakpoints_, number, &Breakpoint::number);
  if (found == breakpoints_.end()) return "there is no such breakpoint";
  if (found->statement.valid()) stops_at_[found->statement.index] = false;
  breakpoints_.erase(found);
  return {};
}

Refusal Session::Watch(const std::string& name) {
  const auto found = Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input) return "what the operator types cannot be read";
  for (const sim::Watched& watched : chart_.watched()) {
    if (watched.name == name) return "'" + name + "' is watched already";
  }
  if (!chart_.Watch(scenarios::WatchLocation(program(), name, location))) return "16 locations are watched already";
  return {};
}

Refusal Session::Unwatch(size_t number) {
  if (number >= chart_.watched().size()) return "there is no such watched location";
  chart_.Unwatch(number);
  return {};
}

Refusal Session::Arm(const TriggerWish& wish) {
  constexpr uint32_t kMostSamples = 10'000, kMostMs = 3'600'000;
  if (wish.base_ms == 0 || wish.base_ms > kMostMs || wish.delay_ms > kMostMs) {
    return "the base time is 1 to 3600000 ms, a delay not more";
  }
  if (wish.samples < 2 || wish.samples > kMostSamples) return "a trigger keeps 2 to 10000 samples";
  if (wish.before_percent > 100) return "the position is 0 to 100 percent";
  TriggerRequest request{.bit = {},
                         .edge = wish.edge == "falling" ? TriggerEdge::kFalling : TriggerEdge::kRising,
                         .condition = {},
                         .text = wish.edge + " " + wish.text,
                         .base_ms = wish.base_ms,
                         .delay_ms = wish.delay_ms,
                         .samples = wish.samples,
                         .before_percent = wish.before_percent};
  if (wish.edge == "condition") {
    auto parsed = Condition::Parse(conditions_, wish.text);
    if (const auto* refusal = std::get_if<std::string>(&parsed)) return *refusal;
    request.condition = std::move(std::get<Condition>(parsed));
  } else if (wish.edge == "rising" || wish.edge == "falling") {
    const auto found = Find(wish.text);
    if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input || location.place.type != ir::Type::kBit) return "only a bit has edges";
    request.bit = scenarios::WatchLocation(program(), wish.text, location);
  } else {
    return "a trigger is 'rising', 'falling' or 'condition'";
  }
  chart_.Arm(std::move(request));
  Machine& machine = timeline_.machine();
  chart_.Prime(machine.control().Reader(), machine.simulator(), machine.last_part());
  return {};
}

}  // namespace plcxx::live
