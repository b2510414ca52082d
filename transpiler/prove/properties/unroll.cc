#include "transpiler/prove/properties/unroll.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/execute/execute.h"

namespace plcxx::prove {
namespace {

/// A period that takes more is not worth waiting for: many of them are needed.
constexpr uint32_t kMostRounds = 256, kMostTerms = 4'000'000;

bool IsInbox(const Version& version, const Cell& cell) {
  return cell.kind == CellKind::kField && version.program->text_inbox.valid() &&
         cell.state == version.program->text_inbox;
}

}  // namespace

std::vector<bool> InputsOf(const Version& version) {
  const Uses uses = UsesOf(version);
  std::vector<bool> inputs(version.cells.count);
  for (uint32_t i = 0; i < version.cells.calls; ++i) {
    const Cell cell = CellAt(*version.program, version.cells, CellId(i));
    if (cell.kind != CellKind::kBit || !IsState(version, CellId(i))) continue;
    inputs[i] = DirectionOf(version, CellId(i)) == ir::Direction::kInput ||
                (version.program->spaces[cell.space].host_visible && !uses.writes[i]);
  }
  return inputs;
}

bool AnswersMatter(const ir::Program& program) {
  if (program.text_inbox.valid()) return true;
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    const ir::HostFunctionId id(i);
    const ir::HostFunction& function = program.host_functions[id];
    if (id == program.schedule.now || id == program.schedule.retentive_load) continue;
    if (function.result != ir::Type::kNone || !function.out.name.empty()) return true;
    const bool writes =
        function.access == ir::HostAccess::kWritesState || function.access == ir::HostAccess::kWritesRetentive;
    if (writes && !function.routine_exchange) return true;
  }
  return false;
}

Unrolled::Unrolled(Terms& terms, const Version& version, const std::vector<bool>& inputs, Start start,
                   HostAnswers answers, std::string name)
    : terms_(terms),
      version_(version),
      inputs_(inputs),
      start_(start),
      answers_(answers),
      name_(std::move(name)),
      uses_(UsesOf(version)),
      states_(1),
      inputs_of_(1) {
  const ir::Schedule& schedule = version.program->schedule;
  if (schedule.fast_ms != 0) fast_parts_ = std::max(1U, schedule.period_ms / schedule.fast_ms);
  states_[0].resize(version.cells.count);
  if (start == Start::kAnywhere) {
    time_ = terms.Variable(name_ + " now", 32);
    return;
  }
  Transition init = RunInit(terms, version,
                            {.initial = [&](CellId) { return terms.Const(0, 64); },
                             .now = terms.Const(0, 32),
                             .answers = start == Start::kAnyRetentive ? HostAnswers::kAny : HostAnswers::kNothing,
                             .outputs = {}});
  refusal_ = std::move(init.refusal);
  states_[0] = std::move(init.next);
}

TermId Unrolled::Input(CellId cell, uint32_t period, uint32_t part) {
  if (choose_input) return choose_input(cell, period, part);
  TermId& variable = inputs_of_[period][part][cell];
  if (!variable.valid()) {
    const std::string when = std::to_string(period) + (part == 0 ? "" : "." + std::to_string(part));
    const Cell what = CellAt(*version_.program, version_.cells, cell);
    variable = terms_.Variable(name_ + " " + when + " " + CellName(*version_.program, what),
                               CellWidth(*version_.program, what));
  }
  return variable;
}

TermId Unrolled::AtStart(CellId cell) {
  TermId& variable = start_variables_[cell];
  if (!variable.valid()) {
    const Cell what = CellAt(*version_.program, version_.cells, cell);
    variable = choose_start_ ? choose_start_(cell)
                             : terms_.Variable(name_ + " " + CellName(*version_.program, what),
                                               CellWidth(*version_.program, what));
  }
  return variable;
}

TermId Unrolled::Value(CellId cell, uint32_t period) {
  for (uint32_t at = period;; --at) {
    const TermId value = states_[at][cell.index];
    if (value.valid()) return value;
    if (at == 0) return AtStart(cell);
    if (inputs_[cell.index]) return Input(cell, at, part_count() - 1);
  }
}

TermId Unrolled::Now(uint32_t period, uint32_t part) {
  const ir::Schedule& schedule = version_.program->schedule;
  uint64_t passed = uint64_t{period} * schedule.period_ms;
  if (fast_parts_ != 0) {
    passed = passed - schedule.period_ms + uint64_t{part + 1} * schedule.fast_ms;
  } else if (!schedule.period_ends_its_time) {
    passed -= schedule.period_ms;
  }
  const TermId offset = terms_.Const(passed & 0xFFFFFFFF, 32);
  return time_.valid() ? terms_.Add(time_, offset) : offset;
}

TermId Unrolled::TimeAfter(uint32_t period) {
  const TermId passed = terms_.Const(uint64_t{period} * version_.program->schedule.period_ms & 0xFFFFFFFF, 32);
  return time_.valid() ? terms_.Add(time_, passed) : passed;
}

bool Unrolled::Advance() {
  if (!refusal_.empty()) return false;
  const uint32_t period = periods() + 1;
  states_.emplace_back(version_.cells.count);
  inputs_of_.emplace_back(part_count());
  const auto initial = [this, period](CellId cell) {
    if (inputs_[cell.index]) return Input(cell, period, 0);
    // A text that arrives is an answer of the host, too.
    const Cell what = CellAt(*version_.program, version_.cells, cell);
    if (answers_ == HostAnswers::kAny && IsInbox(version_, what)) return Input(cell, period, 0);
    return Value(cell, period - 1);
  };
  const ir::Schedule& schedule = version_.program->schedule;
  Memory memory(terms_, *version_.program, version_.cells,
                {.initial = initial,
                 .observe = {},
                 .now = Now(period, 0),
                 .host_answers = answers_ == HostAnswers::kAny,
                 .most_rounds = kMostRounds,
                 .most_terms = kMostTerms});
  for (uint32_t part = 0; part < part_count() && refusal_.empty(); ++part) {
    memory.environment().now = Now(period, part);
    for (uint32_t i = 0; part > 0 && i < version_.cells.calls; ++i) {
      if (inputs_[i] && uses_.reads[i]) memory.Write(CellId(i), Input(CellId(i), period, part));
    }
    if (fast_parts_ != 0) refusal_ = Execute(memory, schedule.fast_only);
  }
  // The slow part comes at the time of the last fast one.
  if (refusal_.empty()) refusal_ = Execute(memory, schedule.period);
  std::vector<TermId>& after = states_.back();
  for (uint32_t i = 0; i < version_.cells.count; ++i) {
    if (memory.IsWritten(CellId(i))) after[i] = memory.Read(CellId(i));
  }
  return refusal_.empty();
}

}  // namespace plcxx::prove
