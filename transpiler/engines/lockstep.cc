#include "transpiler/engines/lockstep.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "transpiler/engines/compiled_engine.h"
#include "transpiler/engines/lockstep_snapshot.h"
#include "transpiler/ir/facts.h"
#include "transpiler/sim/same_arguments.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/check.h"

namespace plcxx::engines {
namespace {

std::string ByEngine(const sim::Engine& engine, const std::string& text) {
  return std::string(engine.name()) + ": " + text;
}

bool SameCall(const ir::Program& program, const sim::HostEvent& one, const sim::HostEvent& other) {
  return one.function == other.function &&
         sim::SameArguments(program.host_functions[one.function], one.arguments, other.arguments);
}

}  // namespace

Lockstep::Lockstep(const ir::Program& program, std::vector<std::unique_ptr<sim::Engine>> engines)
    : program_(program), engines_(std::move(engines)), false_fact_function_(ir::FalseFactOf(program)) {
  PLCXX_CHECK(!engines_.empty());
  for (size_t i = 1; i < engines_.size(); ++i) followers_.push_back({.engine = engines_[i].get(), .open = {}});
}

void Lockstep::FollowLater() {
  for (Follower& follower : followers_) follower.most_open = follower.engine->RunAhead();
}

void Lockstep::CatchUp() {
  for (Follower& follower : followers_) {
    while (!follower.open.empty()) EndOldest(follower);
  }
}

void Lockstep::Execute(uint32_t now_ms, const Change& piece) {
  piece_ = std::make_shared<Piece>(Piece{.now_ms = now_ms, .calls = {}, .events = {}, .state = {}});
  sim::Engine& first = *engines_.front();
  piece(first);
  TakeEventsOfFirst();
  if (!followers_.empty()) piece_->state = first.Snapshot();
  for (Follower& follower : followers_) Follow(follower, {.piece = piece_}, piece);
}

void Lockstep::Follow(Follower& follower, Followed followed, const Change& piece) {
  sim::Engine& engine = *follower.engine;
  const bool changes =
      std::ranges::any_of(followed.piece->calls, [](const auto& call) { return !call.changes.empty(); });
  if (changes) {
    while (!follower.open.empty()) EndOldest(follower);
  }
  followed.has_answers = answers_ && engine.ExpectCalls(followed.piece->calls);
  if (follower.most_open == 1) {
    followed_ = std::move(followed);
    piece(engine);
    Compare(engine);
    return;
  }
  piece(engine);
  follower.open.push_back(std::move(followed));
  // While the older half is looked at, the engine is busy with the rest.
  if (follower.open.size() < follower.most_open) return;
  while (follower.open.size() > follower.most_open / 2) EndOldest(follower);
}

void Lockstep::EndOldest(Follower& follower) {
  followed_ = std::move(follower.open.front());
  follower.open.pop_front();
  try {
    follower.engine->EndPiece();
  } catch (const EngineFault&) {
    // What it was told after another call than was expected, it could not understand.
    if (!difference_) throw;
    return;
  }
  Compare(*follower.engine);
}

void Lockstep::Each(Change change) {
  if (answering_) {
    change(*engines_.front());
    piece_->calls.back().changes.push_back(std::move(change));
    return;
  }
  CatchUp();
  for (const auto& engine : engines_) change(*engine);
}

void Lockstep::AnswerHostCalls(sim::HostAnswers answers) {
  answers_ = std::move(answers);
  for (const auto& engine : engines_) {
    if (!answers_) {
      engine->AnswerHostCalls({});
    } else if (engine == engines_.front()) {
      engine->AnswerHostCalls([this](auto function, auto arguments) { return AnswerFirst(function, arguments); });
    } else {
      engine->AnswerHostCalls([this, other = engine.get()](auto function, auto arguments) {
        return AnswerAgain(*other, function, arguments);
      });
    }
  }
}

sim::HostAnswer Lockstep::AnswerFirst(ir::HostFunctionId function, std::span<const uint64_t> arguments) {
  piece_->calls.push_back({{function, {arguments.begin(), arguments.end()}}, {}, {}});
  answering_ = true;
  const sim::HostAnswer answer = answers_(function, arguments);
  answering_ = false;
  piece_->calls.back().answer = answer;
  return answer;
}

sim::HostAnswer Lockstep::AnswerAgain(sim::Engine& engine, ir::HostFunctionId function,
                                      std::span<const uint64_t> arguments) {
  const sim::HostEvent call{function, {arguments.begin(), arguments.end()}};
  const std::vector<sim::AnsweredCall>& calls = followed_.piece->calls;
  if (followed_.repeated >= calls.size()) {
    CallsDiffer(engine, "none", ToText(program_, call));
    return {};
  }
  const sim::AnsweredCall& before = calls[followed_.repeated++];
  if (!SameCall(program_, before.call, call))
    CallsDiffer(engine, ToText(program_, before.call), ToText(program_, call));
  if (followed_.has_answers) return {};
  for (const Change& change : before.changes) change(engine);
  return before.answer;
}

void Lockstep::Differ(std::string what, std::optional<ir::Place> place, std::string first, std::string second) {
  if (difference_) return;
  difference_ = {std::move(what), std::move(place), std::move(first), std::move(second), followed_.piece->now_ms};
  went_on_ = followed_.piece != piece_;
}

void Lockstep::CallsDiffer(const sim::Engine& other, const std::string& first, const std::string& second) {
  Differ("the host calls", std::nullopt, ByEngine(*engines_.front(), first), ByEngine(other, second));
}

void Lockstep::PowerOn() {
  CatchUp();
  Execute(0, [](sim::Engine& engine) { engine.PowerOn(); });
}

void Lockstep::RunPeriod(uint32_t now_ms) {
  Execute(now_ms, [now_ms](sim::Engine& engine) { engine.RunPeriod(now_ms); });
}

void Lockstep::RunFastOnly(uint32_t now_ms) {
  Execute(now_ms, [now_ms](sim::Engine& engine) { engine.RunFastOnly(now_ms); });
}

void Lockstep::RunElapse(uint32_t now_ms) {
  Execute(now_ms, [now_ms](sim::Engine& engine) { engine.RunElapse(now_ms); });
}

void Lockstep::Write(const ir::Place& place, uint64_t value) {
  Each([place, value](sim::Engine& engine) { engine.Write(place, value); });
}

void Lockstep::Force(const ir::Place& place, uint64_t value) {
  Each([place, value](sim::Engine& engine) { engine.Force(place, value); });
}

void Lockstep::Release(const ir::Place& place) {
  Each([place](sim::Engine& engine) { engine.Release(place); });
}

void Lockstep::SendText(std::string_view text) {
  Each([text = std::string(text)](sim::Engine& engine) { engine.SendText(text); });
}

void Lockstep::EnableStatement(ir::StatementId statement, bool enabled) {
  Each([statement, enabled](sim::Engine& engine) { engine.EnableStatement(statement, enabled); });
}

void Lockstep::StoreRetentive() {
  Each([](sim::Engine& engine) { engine.StoreRetentive(); });
}

std::vector<sim::HostEvent> Lockstep::TakeEvents() { return std::exchange(events_, {}); }

void Lockstep::TakeEventsOfFirst() {
  piece_->events = engines_.front()->TakeEvents();
  const std::vector<sim::HostEvent>& events = piece_->events;
  events_.insert(events_.end(), events.begin(), events.end());
  const auto false_fact = std::ranges::find(events, false_fact_function_, &sim::HostEvent::function);
  if (false_fact_function_.valid() && !false_fact_ && false_fact != events.end()) false_fact_ = *false_fact;
}

void Lockstep::Compare(sim::Engine& other) {
  const std::vector<sim::AnsweredCall>& calls = followed_.piece->calls;
  if (followed_.repeated < calls.size()) CallsDiffer(other, ToText(program_, calls[followed_.repeated].call), "none");
  CompareStates(other);
  CompareEvents(other);
}

void Lockstep::CompareStates(sim::Engine& other) {
  const std::vector<uint8_t>& expected = followed_.piece->state;
  const std::vector<uint8_t> found = other.Snapshot();
  if (difference_ || found == expected) return;
  const sim::Engine& first = *engines_.front();
  if (found.size() != expected.size()) {
    Differ("the size of the state", std::nullopt, ByEngine(first, std::to_string(expected.size()) + " bytes"),
           ByEngine(other, std::to_string(found.size()) + " bytes"));
    return;
  }
  for (size_t from = 0;;) {
    const auto start = static_cast<std::ptrdiff_t>(from);
    const auto differs = std::mismatch(expected.begin() + start, expected.end(), found.begin() + start).first;
    if (differs == expected.end()) return;
    const auto at = static_cast<size_t>(differs - expected.begin());
    const SnapshotCell cell = CellAt(program_, at, static_cast<uint8_t>(expected[at] ^ found[at]));
    const uint64_t left = CellValue(cell, expected), right = CellValue(cell, found);
    from = at + 1;
    if (sim::SameValue(cell.type, left, right)) continue;
    Differ(cell.name, cell.place, ByEngine(first, ValueText(cell.type, left)),
           ByEngine(other, ValueText(cell.type, right)));
    return;
  }
}

void Lockstep::CompareEvents(sim::Engine& other) {
  const std::vector<sim::HostEvent>& expected = followed_.piece->events;
  const std::vector<sim::HostEvent> found = other.TakeEvents();
  const bool is_same = std::ranges::equal(
      found, expected, [this](const auto& one, const auto& another) { return SameCall(program_, one, another); });
  if (!is_same) CallsDiffer(other, ToText(program_, expected), ToText(program_, found));
}

std::string ArgumentText(ir::Type type, uint64_t value) {
  constexpr uint64_t kSmallNegative = 0xFFFF'0000;
  const bool negative = type == ir::Type::kI32 && value >= kSmallNegative;
  return sim::ValueDigits(type, value, negative ? sim::Sign::kTwosComplement : sim::Sign::kNone);
}

std::string ToText(const ir::Program& program, const sim::HostEvent& event) {
  const ir::HostFunction& function = program.host_functions[event.function];
  std::string text = function.name + "(";
  for (size_t i = 0; i < event.arguments.size(); ++i) {
    const uint64_t value = event.arguments[i];
    if (i > 0) text += ", ";
    if (i >= function.parameters.size()) {
      text += std::to_string(value);
      continue;
    }
    const ir::Parameter& parameter = function.parameters[i];
    text += parameter.name + ": ";
    text += value < parameter.enumerators.size() ? parameter.enumerators[value] : ArgumentText(parameter.type, value);
  }
  return text + ")";
}

std::string ToText(const ir::Program& program, const std::vector<sim::HostEvent>& events) {
  if (events.empty()) return "none";
  std::string text;
  for (const sim::HostEvent& event : events) text += (text.empty() ? "" : ", ") + ToText(program, event);
  return text;
}

std::string ValueText(ir::Type type, uint64_t value, sim::Sign sign) {
  if (type == ir::Type::kBit) return std::to_string(value);
  char hex[24];
  std::snprintf(hex, sizeof hex, " (0x%02llX)", static_cast<unsigned long long>(value));
  return sim::ValueDigits(type, value, sign) + hex;
}

}  // namespace plcxx::engines
