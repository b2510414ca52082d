#include "transpiler/live/breakpoints.h"

#include <algorithm>
#include <utility>

namespace plcxx::live {

Refusal Breakpoints::Add(Breakpoint breakpoint) {
  if (breakpoints_.size() == kMostBreakpoints) return "there are 64 breakpoints already";
  breakpoint.number = next_++;
  breakpoints_.push_back(std::move(breakpoint));
  return {};
}

Refusal Breakpoints::AtStatement(ir::StatementId statement, bool on) {
  if (statement.index >= program_.statements.size()) return "there is no such statement";
  if (stops_at_[statement.index] == on) return {};
  if (on) {
    Refusal refusal = Add({.kind = BreakKind::kStatement,
                           .text = program_.statements[statement].subject,
                           .statement = statement,
                           .location = {},
                           .last = {},
                           .condition = {}});
    if (!refusal.empty()) return refusal;
  } else {
    std::erase_if(breakpoints_, [&](const Breakpoint& breakpoint) { return breakpoint.statement == statement; });
  }
  stops_at_[statement.index] = on;
  return {};
}

Refusal Breakpoints::AtChange(sim::Watched location, uint64_t now) {
  std::string text = location.name;
  return Add({.kind = BreakKind::kChange,
              .text = std::move(text),
              .statement = {},
              .location = std::move(location),
              .last = now,
              .condition = {}});
}

Refusal Breakpoints::AtCondition(Condition condition, Machine& machine) {
  condition.Comes(machine.simulator(), machine.last_part());
  std::string text = condition.text();
  return Add({.kind = BreakKind::kCondition,
              .text = std::move(text),
              .statement = {},
              .location = {},
              .last = {},
              .condition = std::move(condition)});
}

Refusal Breakpoints::Remove(uint32_t number) {
  const auto found = std::ranges::find(breakpoints_, number, &Breakpoint::number);
  if (found == breakpoints_.end()) return "there is no such breakpoint";
  if (found->statement.valid()) stops_at_[found->statement.index] = false;
  breakpoints_.erase(found);
  return {};
}

Machine::StopAt Breakpoints::StatementStops() const {
  if (std::ranges::none_of(stops_at_, [](bool stops) { return stops; })) return nullptr;
  return [this](ir::StatementId statement) { return stops_at_[statement.index]; };
}

std::string Breakpoints::AfterPeriod(Machine& machine) {
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

void Breakpoints::Forget() {
  for (Breakpoint& breakpoint : breakpoints_) {
    breakpoint.last.reset();
    if (breakpoint.condition) breakpoint.condition->Forget();
  }
}

}  // namespace plcxx::live
