#include "transpiler/prove/machine/unroll.h"

#include <algorithm>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::machine {
namespace {

constexpr uint32_t kCountsPerLook = 4096;  // terms between two looks at the clock

/// The operand whose value may make another one of no account; none: all are needed.
terms::TermId DecidingOperand(const terms::Term& term) {
  const bool decides = term.kind == terms::TermKind::kIte ||
                       (term.width == 1 && (term.kind == terms::TermKind::kAnd || term.kind == terms::TermKind::kOr));
  return decides ? terms::TermId(term.a) : terms::TermId();
}

/// The operand that the term is when its deciding one has this value; none: it is not decided.
terms::TermId Chosen(const terms::Terms& terms, const terms::Term& term, terms::TermId deciding) {
  if (!terms.IsConst(deciding)) return {};
  if (term.kind == terms::TermKind::kIte) return terms::TermId(terms.IsTrue(deciding) ? term.b : term.c);
  const bool is_first = terms.IsTrue(deciding) == (term.kind == terms::TermKind::kOr);
  return terms::TermId(is_first ? term.a : term.b);
}

/// Before power-on nobody has been called, and a copy of the retentive memory would be as the program says.
terms::TermId NothingStored(terms::Terms& terms, const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return terms.Const(PowerOnValue(version, id) ? 1 : 0, execute::CellWidth(*version.program, cell));
}

/// Before power-on nobody has been called, and the host may have any copy of the retentive memory.
terms::TermId StoredBefore(terms::Terms& terms, const Version& version, execute::CellId id) {
  const ir::Program& program = *version.program;
  const execute::Cell cell = execute::CellAt(program, version.cells, id);
  const ir::HostFunctionId load = program.schedule.retentive_load;
  if (cell.kind != execute::CellKind::kBit || !load.valid()) return terms.Const(0, execute::CellWidth(program, cell));
  const std::string& name = program.host_functions[load].name;
  const terms::TermId calls = execute::CallsAfter(terms, name, terms.Const(0, 64), {});
  return terms.Extract(execute::ByteFromHost(terms, name, calls, program.spaces[cell.space].name, cell.offset),
                       cell.bit, 1);
}

}  // namespace

Unrolled::Unrolled(terms::Terms& terms, const Relation& relation, const std::vector<bool>& inputs, Start start,
                   std::string name)
    : terms_(terms),
      relation_(relation),
      version_(relation.version()),
      inputs_(inputs),
      start_(start),
      name_(std::move(name)),
      inputs_of_(1),
      takes_back_(1),
      known_(1),
      refusal_(relation.refusal()) {
  fast_parts_ = ir::FastPartsOfPeriod(version_.program->schedule);
  if (start == Start::kAnywhere) {
    time_ = terms.Variable(name_ + " now", 32);
    return;
  }
  Transition init = RunInit(terms, version_,
                            {.initial =
                                 [&](execute::CellId cell) {
                                   return start == Start::kAnyRetentive ? StoredBefore(terms, version_, cell)
                                                                        : NothingStored(terms, version_, cell);
                                 },
                             .now = terms.Const(0, 32),
                             .answers = start == Start::kPowerOn ? HostAnswers::kNothing : HostAnswers::kAny,
                             .observed = {},
                             .host_bit = {}});
  if (refusal_.empty()) refusal_ = std::move(init.refusal);
  initial_ = std::move(init.next);
}

terms::TermId Unrolled::Input(execute::CellId cell, uint32_t period, uint32_t part) {
  if (choose_input) return choose_input(cell, period, part);
  terms::TermId& variable = inputs_of_[period][part][cell];
  if (!variable.valid()) {
    const std::string when = std::to_string(period) + (part == 0 ? "" : "." + std::to_string(part));
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    variable = terms_.Variable(name_ + " " + when + " " + execute::CellName(*version_.program, what),
                               execute::CellWidth(*version_.program, what));
  }
  return variable;
}

terms::TermId Unrolled::AtStart(execute::CellId cell) {
  if (start_ != Start::kAnywhere) return initial_[cell.index];
  terms::TermId& variable = start_variables_[cell];
  if (!variable.valid()) {
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    variable = choose_start_ ? choose_start_(cell)
                             : terms_.Variable(name_ + " " + execute::CellName(*version_.program, what),
                                               execute::CellWidth(*version_.program, what));
  }
  return variable;
}

terms::TermId Unrolled::Now(uint32_t period, uint32_t part) {
  const ir::Schedule& schedule = version_.program->schedule;
  uint64_t passed = uint64_t{period} * schedule.period_ms;
  if (fast_parts_ != 0) {
    passed = passed - schedule.period_ms + uint64_t{part + 1} * schedule.fast_ms;
  } else if (!schedule.period_ends_its_time) {
    passed -= schedule.period_ms;
  }
  const terms::TermId offset = terms_.Const(passed & 0xFFFFFFFF, 32);
  return time_.valid() ? terms_.Add(time_, offset) : offset;
}

terms::TermId Unrolled::TimeAfter(uint32_t period) {
  const terms::TermId passed = terms_.Const(uint64_t{period} * version_.program->schedule.period_ms & 0xFFFFFFFF, 32);
  return time_.valid() ? terms_.Add(time_, passed) : passed;
}

void Unrolled::Advance() {
  inputs_of_.emplace_back(part_count());
  takes_back_.emplace_back(part_count());
  known_.resize(known_.size() + StepsOfPeriod());
}

Unrolled::Step Unrolled::StepAt(uint32_t step) const {
  const uint32_t period = (step - 1) / StepsOfPeriod() + 1, at = (step - 1) % StepsOfPeriod();
  // The slow part comes at the time of the last fast one, with the same inputs.
  const bool is_slow = fast_parts_ != 0 && at == fast_parts_;
  return {.period = period,
          .part = is_slow ? at - 1 : at,
          .has_new_inputs = !is_slow,
          .is_fast = fast_parts_ != 0 && !is_slow};
}

bool Unrolled::IsFresh(execute::CellId cell, const Step& step) const {
  if (!step.has_new_inputs) return false;
  if (inputs_[cell.index]) return true;
  // A text that arrives is an answer of the host, too.
  return step.part == 0 && relation_.answers() == HostAnswers::kAny && IsInbox(version_, cell);
}

void Unrolled::AddTakingBack(execute::CellId cell, const Step& step, terms::TermId& stays) {
  if (taken_back.empty() || !taken_back[cell.index] || !step.has_new_inputs) return;
  terms::TermId& done = takes_back_[step.period][step.part][cell];
  if (!done.valid()) {
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    const std::string when = std::to_string(step.period) + (step.part == 0 ? "" : "." + std::to_string(step.part));
    done = terms_.Variable(name_ + " takes back " + when + " " + execute::CellName(*version_.program, what), 1);
  }
  stays = stays.valid() ? terms_.And(stays, terms_.Not(done)) : terms_.Not(done);
}

Unrolled::Found Unrolled::Follow(execute::CellId cell, uint32_t step) {
  terms::TermId stays;
  for (; step > 0; --step) {
    const Step at = StepAt(step);
    const terms::TermId next = (at.is_fast ? relation_.fast() : relation_.period())[cell.index];
    if (next.valid()) return {.instance = {.term = next, .step = step}, .value = {}, .stays = stays};
    if (IsFresh(cell, at)) return {.instance = {}, .value = Input(cell, at.period, at.part), .stays = stays};
    AddTakingBack(cell, at, stays);
  }
  return {.instance = {}, .value = AtStart(cell), .stays = stays};
}

Unrolled::Found Unrolled::FindVariable(const Instance& variable) {
  const Step at = StepAt(variable.step);
  if (variable.term == relation_.now()) return {.instance = {}, .value = Now(at.period, at.part)};
  const execute::CellId cell = relation_.CellOf(variable.term);
  PLCXX_CHECK(cell.valid());
  if (IsFresh(cell, at)) return {.instance = {}, .value = Input(cell, at.period, at.part)};
  terms::TermId stays;
  AddTakingBack(cell, at, stays);
  Found found = Follow(cell, variable.step - 1);
  if (stays.valid()) found.stays = found.stays.valid() ? terms_.And(stays, found.stays) : stays;
  return found;
}

/// Operands first, without recursion: it goes through all periods, and each may be as deep as the program is long.
terms::TermId Unrolled::Instantiate(const Instance& root) {
  const auto value_of = [this](const Instance& instance) {
    if (terms_.IsConst(instance.term)) return instance.term;
    const auto found = known_[instance.step].find(instance.term.index);
    return found == known_[instance.step].end() ? terms::TermId() : found->second;
  };
  std::vector<Instance> open{root};
  std::vector<terms::TermId> operands;
  const auto rebuild = [&](const terms::Term& term, uint32_t step) {
    operands.clear();
    const size_t before = open.size();
    terms_.ForEachOperand(term, [&](terms::TermId operand) {
      operands.push_back(value_of({.term = operand, .step = step}));
      if (!operands.back().valid()) open.push_back({.term = operand, .step = step});
    });
    return open.size() == before ? terms_.Rebuild(term, operands) : terms::TermId();
  };
  for (uint32_t count = 1; !open.empty(); ++count) {
    if (count % kCountsPerLook == 0 && late && late()) return terms_.Const(0, terms_.Width(root.term));
    const Instance now = open.back();
    if (value_of(now).valid()) {
      open.pop_back();
      continue;
    }
    const terms::Term term = terms_[now.term];
    terms::TermId value;
    if (term.kind == terms::TermKind::kVariable) {
      const Found found = FindVariable(now);
      value = found.value.valid() ? found.value : value_of(found.instance);
      if (!value.valid()) open.push_back(found.instance);
      if (value.valid() && found.stays.valid()) value = terms_.And(value, found.stays);
    } else if (const terms::TermId deciding = DecidingOperand(term); deciding.valid()) {
      // What this decides need not be made: after power-on many branches are known.
      const terms::TermId first = value_of({.term = deciding, .step = now.step});
      const terms::TermId chosen = first.valid() ? Chosen(terms_, term, first) : deciding;
      if (chosen.valid()) {
        value = first.valid() ? value_of({.term = chosen, .step = now.step}) : terms::TermId();
        if (!value.valid()) open.push_back({.term = chosen, .step = now.step});
      } else {
        value = rebuild(term, now.step);
      }
    } else {
      value = rebuild(term, now.step);
    }
    if (!value.valid()) continue;
    known_[now.step][now.term.index] = value;
    open.pop_back();
  }
  return value_of(root);
}

terms::TermId Unrolled::Value(execute::CellId cell, uint32_t period) {
  const Found found = Follow(cell, period * StepsOfPeriod());
  const terms::TermId value = found.value.valid() ? found.value : Instantiate(found.instance);
  return found.stays.valid() ? terms_.And(value, found.stays) : value;
}

}  // namespace plcxx::prove::machine
