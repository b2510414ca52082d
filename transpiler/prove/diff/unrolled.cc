#include "transpiler/prove/diff/unrolled.h"

#include <string>
#include <utility>

namespace plcxx::prove::diff {

Unrolled::Unrolled(terms::Terms& terms, UnrolledVersions versions, InputsChange inputs_change)
    : terms_(terms), versions_(std::move(versions)), inputs_change_(inputs_change) {}

bool Unrolled::IsInput(execute::CellId old_cell) const {
  return !versions_.match.starts_otherwise[old_cell.index] &&
         IsInputPair(versions_.old_version, versions_.new_version, versions_.old_uses, versions_.new_uses,
                     versions_.match, old_cell);
}

terms::TermId Unrolled::KeptIn(Which which, execute::CellId cell) {
  const bool is_old = which == Which::kOld;
  const machine::Version& version = is_old ? versions_.old_version : versions_.new_version;
  const execute::CellId old_cell = is_old ? cell : versions_.match.old_of_new[cell.index];
  if (!MayBeKept(versions_.old_version, versions_.new_version, versions_.match, old_cell)) {
    return terms_.Bit(machine::PowerOnValue(version, cell));
  }
  const auto [at, added] = kept_.try_emplace(old_cell.index);
  if (!added) return at->second;
  const execute::Cell of_old = execute::CellAt(*versions_.old_version.program, versions_.old_version.cells, old_cell);
  at->second = terms_.Variable("kept " + execute::CellName(*versions_.old_version.program, of_old), 1);
  return at->second;
}

void Unrolled::PowerOn(Kept kept) {
  for (const Which which : {Which::kOld, Which::kNew}) {
    const machine::Version& version = which == Which::kOld ? versions_.old_version : versions_.new_version;
    const machine::PartEnvironment environment{.initial =
                                                   [&](execute::CellId cell) {
                                                     const bool is_kept =
                                                         kept == Kept::kAnything && machine::IsRetentive(version, cell);
                                                     return is_kept ? KeptIn(which, cell) : terms_.Const(0, 64);
                                                   },
                                               .now = terms_.Const(0, 32),
                                               .answers = machine::HostAnswers::kNothing,
                                               .has_copy = kept == Kept::kAnything,
                                               .observed = {}};
    (which == Which::kOld ? old_state_ : new_state_) = machine::RunInit(terms_, version, environment).next;
  }
  level_at_begin_ = [this](uint32_t old_cell) {
    return uint64_t{machine::PowerOnValue(versions_.old_version, execute::CellId(old_cell))};
  };
}

void Unrolled::BeginAt(const std::function<uint64_t(Which, execute::CellId)>& value, uint64_t now_ms) {
  begin_ms_ = now_ms;
  for (const Which which : {Which::kOld, Which::kNew}) {
    const machine::Version& version = which == Which::kOld ? versions_.old_version : versions_.new_version;
    std::vector<terms::TermId>& state = which == Which::kOld ? old_state_ : new_state_;
    for (uint32_t i = 0; i < version.cells.count; ++i) {
      const execute::CellId id(i);
      const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
      // What was called so far tells nothing.
      const bool is_calls = cell.kind == execute::CellKind::kCalls;
      const auto width = static_cast<uint8_t>(is_calls ? 64 : execute::CellWidth(*version.program, cell));
      state.push_back(terms_.Const(is_calls ? 0 : value(which, id), width));
    }
  }
  // The one who asks may have gone on from there since.
  level_at_begin_ = [this, levels = old_state_](uint32_t old_cell) { return terms_.Value(levels[old_cell]); };
}

/// By either version; a cell that only the old one has, by that one.
bool Unrolled::IsWritten(execute::CellId old_cell) const {
  const execute::CellId new_cell = versions_.match.new_of_old[old_cell.index];
  return versions_.old_uses.writes[old_cell.index] || (new_cell.valid() && versions_.new_uses.writes[new_cell.index]);
}

/// What is set once is a version's own when it has written it.
bool Unrolled::MayBeSet(execute::CellId old_cell) const {
  if (inputs_change_ == InputsChange::kEachPeriod || periods_ == 1) return true;
  return !IsWritten(old_cell);
}

terms::TermId Unrolled::InputOf(uint32_t old_cell) {
  const size_t period = inputs_change_ == InputsChange::kOnce ? 0 : inputs_.size() - 1;
  const auto [at, added] = inputs_[period].levels.try_emplace(old_cell);
  if (!added) return at->second;
  const machine::Version& version = versions_.old_version;
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, execute::CellId(old_cell));
  at->second =
      terms_.Variable("period " + std::to_string(inputs_.size()) + " " + execute::CellName(*version.program, cell), 1);
  cell_of_[at->second.index] = old_cell;
  return at->second;
}

std::optional<bool> Unrolled::AdvancePart(Which which, machine::Part part, uint64_t now_ms,
                                          const std::function<bool()>& is_late) {
  const bool is_old = which == Which::kOld;
  std::vector<terms::TermId>& values = is_old ? old_state_ : new_state_;
  // Inputs have a new value when they may change, the same for both; they keep it until then.
  const auto initial = [&](execute::CellId cell) {
    const execute::CellId old_cell = is_old ? cell : versions_.match.old_of_new[cell.index];
    if (!old_cell.valid() || !IsInput(old_cell) || !MayBeSet(old_cell)) return values[cell.index];
    return InputOf(old_cell.index);
  };
  const terms::TermId now = terms_.Const(now_ms & 0xFFFFFFFF, 32);
  const machine::Transition next = machine::RunPart(
      terms_, is_old ? versions_.old_version : versions_.new_version, part,
      {.initial = initial, .now = now, .answers = machine::HostAnswers::kNothing, .observed = {}, .is_late = is_late});
  if (!next.refusal.empty()) return std::nullopt;
  bool changed = false;
  for (uint32_t i = 0; i < values.size(); ++i) {
    if (!next.next[i].valid()) continue;
    values[i] = next.next[i];
    changed = true;
  }
  return changed;
}

/// Before a period the control clears the requests that it has done, in both versions the same ones.
void Unrolled::ClearDoneRequests() {
  const machine::Version& version = versions_.old_version;
  for (const execute::CellId old_cell : versions_.requests) {
    terms::TermId& one = old_state_[old_cell.index];
    terms::TermId& other = new_state_[versions_.match.new_of_old[old_cell.index].index];
    if (terms_.IsFalse(one) && terms_.IsFalse(other)) continue;
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, old_cell);
    const terms::TermId done = terms_.Variable(
        "before period " + std::to_string(inputs_.size()) + " done " + execute::CellName(*version.program, cell), 1);
    inputs_.back().done[old_cell.index] = done;
    cell_of_[done.index] = old_cell.index;
    one = terms_.And(one, terms_.Not(done));
    other = terms_.And(other, terms_.Not(done));
  }
}

bool Unrolled::Advance(const std::function<bool()>& is_late) {
  const ir::Schedule& schedule = versions_.old_version.program->schedule;
  const uint64_t begin_ms = begin_ms_ + periods_ * schedule.period_ms;
  inputs_.emplace_back();
  ++periods_;
  ClearDoneRequests();
  for (const Which which : {Which::kOld, Which::kNew}) {
    const machine::Version& version = which == Which::kOld ? versions_.old_version : versions_.new_version;
    const uint32_t fast_ms = version.program->schedule.fast_ms;
    for (uint32_t ms = fast_ms; fast_ms != 0 && ms <= schedule.period_ms; ms += fast_ms) {
      const std::optional<bool> changed = AdvancePart(which, machine::Part::kFast, begin_ms + ms, is_late);
      if (!changed || is_late()) return false;
      if (!*changed) break;  // an empty part
    }
    const bool ends = schedule.period_ends_its_time || fast_ms != 0;
    const uint64_t now_ms = ends ? begin_ms + schedule.period_ms : begin_ms;
    if (!AdvancePart(which, machine::Part::kPeriod, now_ms, is_late)) return false;
  }
  return true;
}

std::optional<uint32_t> Unrolled::CellOf(terms::TermId variable) const {
  const auto at = cell_of_.find(variable.index);
  return at == cell_of_.end() ? std::nullopt : std::optional(at->second);
}

Run Unrolled::RunOf(const std::vector<terms::Reason>& reasons, const std::vector<uint64_t>& values) const {
  std::unordered_map<uint32_t, uint64_t> needed;  // looked up only
  for (const terms::Reason& reason : reasons) needed[reason.term.index] = values[reason.term.index];
  std::map<uint32_t, uint64_t> level;
  Run run;
  for (const auto& [old_cell, variable] : kept_) {
    const auto found = needed.find(variable.index);
    if (found == needed.end() || found->second == 0) continue;
    run.kept.push_back({.old_cell = execute::CellId(old_cell),
                        .new_cell = versions_.match.new_of_old[old_cell],
                        .value = found->second});
  }
  for (const Inputs& inputs : inputs_) {
    run.periods.emplace_back();
    const auto set = [&](uint32_t old_cell, uint64_t value) {
      run.periods.back().push_back(
          {.old_cell = execute::CellId(old_cell), .new_cell = versions_.match.new_of_old[old_cell], .value = value});
    };
    for (const auto& [old_cell, variable] : inputs.done) {
      const auto found = needed.find(variable.index);
      if (found != needed.end() && found->second != 0) set(old_cell, 0);
    }
    for (const auto& [old_cell, variable] : inputs.levels) {
      const auto found = needed.find(variable.index);
      if (found == needed.end()) continue;
      const auto [at, first] = level.try_emplace(old_cell);
      if (first) at->second = level_at_begin_(old_cell);
      // A version that writes it has another value there, perhaps.
      if (!IsWritten(execute::CellId(old_cell)) && at->second == found->second) continue;
      at->second = found->second;
      set(old_cell, found->second);
    }
  }
  return run;
}

}  // namespace plcxx::prove::diff
