#include "transpiler/live/wishes.h"

#include <algorithm>
#include <utility>

#include "transpiler/live/locations.h"
#include "transpiler/sim/active_messages.h"

namespace plcxx::live {
namespace {

constexpr size_t kMostTyped = 256;  // bytes of what an operator types
constexpr const char* kNotRead = "what the operator types cannot be read";

}  // namespace

Refusal Set(Session& session, const std::string& name, const std::string& value) {
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (const std::string driver = session.DriverOf(location); !driver.empty()) {
    return "'" + name + "' is driven by the plant, " + driver + ": force it to hold it";
  }
  if (location.text_input) {
    if (value.size() > kMostTyped) return "the text is too long";
    return session.Do({.kind = ActionKind::kText, .name = name, .location = location, .text = value, .statement = {}});
  }
  const auto bits = FindValue(session.compilation(), name, location, value);
  if (const auto* refusal = std::get_if<std::string>(&bits)) return *refusal;
  return session.Do({.kind = ActionKind::kSet,
                     .name = name,
                     .location = location,
                     .value = std::get<uint64_t>(bits),
                     .text = {},
                     .statement = {}});
}

Refusal Toggle(Session& session, const std::string& name) {
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input || location.place.type != ir::Type::kBit) return "only a bit has two values";
  const bool is_on = session.timeline().machine().Read(location) != 0;
  const bool is_forced =
      std::ranges::any_of(session.forced(), [&](const Forced& forced) { return forced.name == name; });
  return is_forced ? Force(session, name, is_on ? "0" : "1") : Set(session, name, is_on ? "0" : "1");
}

Refusal Force(Session& session, const std::string& name, const std::string& value) {
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (std::string why = CannotBeForced(session.compilation(), location); !why.empty()) return why;
  const auto bits = FindValue(session.compilation(), name, location, value);
  if (const auto* refusal = std::get_if<std::string>(&bits)) return *refusal;
  return session.Do({.kind = ActionKind::kForce,
                     .name = name,
                     .location = location,
                     .value = std::get<uint64_t>(bits),
                     .text = {},
                     .statement = {}});
}

Refusal Release(Session& session, const std::string& name) {
  const auto forced = std::ranges::find(session.forced(), name, &Forced::name);
  if (forced == session.forced().end()) return "'" + name + "' is not forced";
  return session.Do(
      {.kind = ActionKind::kRelease, .name = name, .location = forced->location, .text = {}, .statement = {}});
}

Refusal ReleaseAll(Session& session) {
  for (const Forced& forced : std::vector<Forced>(session.forced())) Release(session, forced.name);
  return {};
}

Refusal SwitchStatement(Session& session, ir::StatementId statement, bool on) {
  if (statement.index >= session.program().statements.size()) return "there is no such statement";
  if (session.timeline().machine().IsOff(statement) != on) return {};
  return session.Do({.kind = on ? ActionKind::kSwitchOn : ActionKind::kSwitchOff,
                     .name = {},
                     .location = {},
                     .text = {},
                     .statement = statement});
}

Refusal SwitchAllOn(Session& session) {
  for (uint32_t i = 0; i < session.program().statements.size(); ++i) SwitchStatement(session, ir::StatementId(i), true);
  return {};
}

Refusal Expect(Session& session, const std::vector<std::string>& names) {
  if (names.empty()) return "nothing is named that could be expected";
  if (!session.timeline().is_between()) return "the period is half done, and a scenario expects between two";
  std::vector<Action> expected;
  for (const std::string& name : names) {
    const auto found = session.Find(name);
    if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input) return kNotRead;
    expected.push_back({.kind = ActionKind::kExpect,
                        .name = name,
                        .location = location,
                        .value = session.timeline().machine().Read(location),
                        .text = {},
                        .statement = {}});
  }
  for (Action& action : expected) session.Do(std::move(action));
  return {};
}

Refusal ExpectMessages(Session& session) {
  if (!session.timeline().is_between()) return "the period is half done, and a scenario expects between two";
  uint64_t since = 0;
  for (const Entry& entry : session.timeline().entries()) {
    if (entry.action.kind == ActionKind::kExpectMessages) since = entry.period;
  }
  Action action{.kind = ActionKind::kExpectMessages, .name = {}, .location = {}, .text = {}, .statement = {}};
  if (session.notes().all().size() == kMostNotes && session.notes().all().front().period >= since) {
    return "there were more messages than are kept: expect them sooner";
  }
  for (const Note& note : session.notes().all()) {
    if (note.kind != NoteKind::kMessage || note.period < since) continue;
    action.messages.push_back(note.text.substr(0, note.text.find(' ')));
  }
  return session.Do(std::move(action));
}

std::vector<std::string> ActiveMessages(Session& session) {
  std::vector<std::string> texts;
  for (const uint32_t number : sim::ActiveMessages(session.program(), session.timeline().machine().simulator())) {
    const auto declared = std::ranges::find(session.program().messages, number, &ir::MessageText::number);
    texts.push_back(std::to_string(number) +
                    (declared == session.program().messages.end() ? "" : "  " + declared->text));
  }
  return texts;
}

Refusal BreakAtChange(Session& session, const std::string& name) {
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input) return kNotRead;
  return session.breakpoints().AtChange(scenarios::WatchLocation(session.program(), name, location),
                                        session.timeline().machine().Read(location));
}

Refusal BreakAtCondition(Session& session, const std::string& text) {
  auto parsed = Condition::Parse(session.conditions(), text);
  if (const auto* refusal = std::get_if<std::string>(&parsed)) return *refusal;
  return session.breakpoints().AtCondition(std::move(std::get<Condition>(parsed)), session.timeline().machine());
}

Refusal Watch(Session& session, const std::string& name) {
  const auto found = session.Find(name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
  const auto& location = std::get<dialects::Location>(found);
  if (location.text_input) return kNotRead;
  for (const sim::Watched& watched : session.chart().watched()) {
    if (watched.name == name) return "'" + name + "' is watched already";
  }
  if (!session.chart().Watch(scenarios::WatchLocation(session.program(), name, location)))
    return "16 locations are watched already";
  return {};
}

Refusal Unwatch(Session& session, size_t number) {
  if (number >= session.chart().watched().size()) return "there is no such watched location";
  session.chart().Unwatch(number);
  return {};
}

Refusal Arm(Session& session, const TriggerWish& wish) {
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
    auto parsed = Condition::Parse(session.conditions(), wish.text);
    if (const auto* refusal = std::get_if<std::string>(&parsed)) return *refusal;
    request.condition = std::move(std::get<Condition>(parsed));
  } else if (wish.edge == "rising" || wish.edge == "falling") {
    const auto found = session.Find(wish.text);
    if (const auto* refusal = std::get_if<std::string>(&found)) return *refusal;
    const auto& location = std::get<dialects::Location>(found);
    if (location.text_input || location.place.type != ir::Type::kBit) return "only a bit has edges";
    request.bit = scenarios::WatchLocation(session.program(), wish.text, location);
  } else {
    return "a trigger is 'rising', 'falling' or 'condition'";
  }
  session.chart().Arm(std::move(request));
  Machine& machine = session.timeline().machine();
  session.chart().Prime(machine.control().Reader(), machine.simulator(), machine.last_part());
  return {};
}

}  // namespace plcxx::live
