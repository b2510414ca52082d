// Runs from power-on, period by period, until a pair differs.
#include <algorithm>
#include <map>
#include <unordered_map>

#include "transpiler/prove/compare/comparison.h"
#include "transpiler/prove/solver/model.h"
#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"
#include "transpiler/prove/terms/justify.h"
#include "transpiler/prove/terms/random.h"

namespace plcxx::prove::compare {
namespace {

/// The state of both versions after some periods, over the inputs so far.
struct Unrolled {
  std::vector<terms::TermId> old_state, new_state;        // by cell
  std::vector<std::map<uint32_t, terms::TermId>> inputs;  // by period: what each input (an old cell) is
  std::vector<std::map<uint32_t, terms::TermId>>
      done;  // by period: whether the control has done each request (an old cell)
};

void SetInput(Comparison& comparison, Unrolled& state, uint32_t old_cell) {
  std::map<uint32_t, terms::TermId>& inputs = state.inputs.back();
  if (inputs.contains(old_cell)) return;
  const execute::Cell cell =
      execute::CellAt(*comparison.old_version.program, comparison.old_version.cells, execute::CellId(old_cell));
  inputs[old_cell] = comparison.terms.Variable(
      "period " + std::to_string(state.inputs.size()) + " " + execute::CellName(*comparison.old_version.program, cell),
      1);
}

/// One part of one version at a time; what it changed, or nullopt when it cannot be executed.
std::optional<bool> AdvancePart(Comparison& comparison, Unrolled& state, Which which, Part part, uint64_t now_ms) {
  const bool is_old = which == Which::kOld;
  std::vector<terms::TermId>& values = is_old ? state.old_state : state.new_state;
  // Inputs have a new value in every period, the same for both; they keep it until the next one.
  const auto initial = [&](execute::CellId cell) {
    const execute::CellId old_cell = is_old ? cell : comparison.match.old_of_new[cell.index];
    if (!old_cell.valid() || !comparison.IsInput(old_cell)) return values[cell.index];
    SetInput(comparison, state, old_cell.index);
    return state.inputs.back()[old_cell.index];
  };
  const terms::TermId now = comparison.terms.Const(now_ms & 0xFFFFFFFF, 32);
  const Transition next = RunPart(comparison.terms, is_old ? comparison.old_version : comparison.new_version, part,
                                  {.initial = initial, .now = now, .answers = HostAnswers::kNothing, .outputs = {}});
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
void ClearDoneRequests(Comparison& comparison, Unrolled& state) {
  terms::Terms& terms = comparison.terms;
  for (const execute::CellId old_cell : comparison.requests) {
    terms::TermId& one = state.old_state[old_cell.index];
    terms::TermId& other = state.new_state[comparison.match.new_of_old[old_cell.index].index];
    if (terms.IsFalse(one) && terms.IsFalse(other)) continue;
    const execute::Cell cell = execute::CellAt(*comparison.old_version.program, comparison.old_version.cells, old_cell);
    const terms::TermId done = terms.Variable("before period " + std::to_string(state.done.size()) + " done " +
                                                  execute::CellName(*comparison.old_version.program, cell),
                                              1);
    state.done.back()[old_cell.index] = done;
    one = terms.And(one, terms.Not(done));
    other = terms.And(other, terms.Not(done));
  }
}

/// As `run: {ms: ...}` of one period does it: the fast parts that are due, then the period.
bool Advance(Comparison& comparison, Unrolled& state) {
  const ir::Schedule& schedule = comparison.old_version.program->schedule;
  const uint64_t before = state.inputs.size(), begin_ms = before * schedule.period_ms;
  state.inputs.emplace_back();
  state.done.emplace_back();
  ClearDoneRequests(comparison, state);
  for (const Which which : {Which::kOld, Which::kNew}) {
    const uint32_t fast_ms =
        (which == Which::kOld ? comparison.old_version : comparison.new_version).program->schedule.fast_ms;
    for (uint32_t ms = fast_ms; fast_ms != 0 && ms <= schedule.period_ms; ms += fast_ms) {
      const std::optional<bool> changed = AdvancePart(comparison, state, which, Part::kFast, begin_ms + ms);
      if (!changed || comparison.Late()) return false;
      if (!*changed) break;  // an empty part
    }
    const bool ends = schedule.period_ends_its_time || fast_ms != 0;
    const uint64_t now_ms = ends ? begin_ms + schedule.period_ms : begin_ms;
    if (!AdvancePart(comparison, state, which, Part::kPeriod, now_ms)) return false;
  }
  return true;
}

Unrolled PowerOn(Comparison& comparison) {
  const PartEnvironment environment{.initial = [&](execute::CellId) { return comparison.terms.Const(0, 64); },
                                    .now = comparison.terms.Const(0, 32),
                                    .answers = HostAnswers::kNothing,
                                    .outputs = {}};
  return {.old_state = RunInit(comparison.terms, comparison.old_version, environment).next,
          .new_state = RunInit(comparison.terms, comparison.new_version, environment).next,
          .inputs = {},
          .done = {}};
}

/// A pair that is looked at, and the term that is 1 where it differs.
struct OpenPair {
  PairResult* result;
  terms::TermId differ;
};

std::vector<terms::TermId> ConeOf(const Comparison& comparison, const std::vector<OpenPair>& pairs) {
  std::vector<terms::TermId> roots;
  for (const OpenPair& pair : pairs) roots.push_back(pair.differ);
  return terms::ConeOf(comparison.terms, roots);
}

/// By TermId: the values of a cone for those that `variable(term)` gives its variables.
template <class Variable>
void EvaluateCone(const terms::Terms& terms, std::span<const terms::TermId> cone, std::vector<uint64_t>& values,
                  Variable&& variable) {
  values.resize(terms.size());
  for (const terms::TermId id : cone) {
    values[id.index] = terms::EvaluateTerm(
        terms, terms[id], [&values](terms::TermId operand) { return values[operand.index]; },
        [&](uint32_t) { return variable(id); });
  }
}

/// Whether a value that was made up for an unknown function, such as a loop, is among them: then nothing is shown.
bool AreMadeUp(const terms::Terms& terms, const std::vector<terms::Reason>& reasons) {
  return std::ranges::any_of(
      reasons, [&terms](const terms::Reason& reason) { return terms[reason.term].kind == terms::TermKind::kApply; });
}

/// The inputs that make a difference, each where its level changes.
Run RunOf(const Comparison& comparison, const Unrolled& state, const std::vector<terms::Reason>& reasons,
          const std::vector<uint64_t>& values) {
  std::unordered_map<uint32_t, uint64_t> needed;  // looked up only
  for (const terms::Reason& reason : reasons) needed[reason.term.index] = values[reason.term.index];
  const ir::Program& program = *comparison.old_version.program;
  std::map<uint32_t, uint64_t> level;
  Run run;
  for (size_t period = 0; period < state.inputs.size(); ++period) {
    run.periods.emplace_back();
    for (const auto& [old_cell, variable] : state.done[period]) {
      const auto found = needed.find(variable.index);
      if (found == needed.end() || found->second == 0) continue;
      run.periods.back().push_back(
          {.old_cell = execute::CellId(old_cell), .new_cell = comparison.match.new_of_old[old_cell], .value = 0});
    }
    for (const auto& [old_cell, variable] : state.inputs[period]) {
      const auto found = needed.find(variable.index);
      if (found == needed.end()) continue;
      const execute::Cell cell = execute::CellAt(program, comparison.old_version.cells, execute::CellId(old_cell));
      const auto [at, first] =
          level.try_emplace(old_cell, PowerOnBit(program.spaces[cell.space], cell.offset, cell.bit));
      // A version that writes it has another value there, perhaps.
      const execute::CellId new_cell = comparison.match.new_of_old[old_cell];
      const bool is_kept = !comparison.old_uses.writes[old_cell] && !comparison.new_uses.writes[new_cell.index];
      if (is_kept && at->second == found->second) continue;
      at->second = found->second;
      run.periods.back().push_back({.old_cell = execute::CellId(old_cell),
                                    .new_cell = comparison.match.new_of_old[old_cell],
                                    .value = found->second});
    }
  }
  return run;
}

/// When a search that has one `part`-th of the time ends, as RestMs.
uint64_t EndMs(const Comparison& comparison, uint64_t part) {
  const uint64_t rest = comparison.RestMs();
  return rest - std::min(rest, comparison.limits.total_ms / part);
}

/// Most differences show with some of a few random inputs, where the solver would look for long in a large program.
void TryRandomInputs(Comparison& comparison, const Unrolled& state, const std::vector<OpenPair>& pairs,
                     uint64_t end_ms) {
  constexpr int kTries = 24;
  const std::vector<terms::TermId> cone = ConeOf(comparison, pairs);
  std::unordered_map<uint32_t, uint32_t> cell_of;  // by variable
  for (const std::map<uint32_t, terms::TermId>& inputs : state.inputs) {
    for (const auto& [old_cell, variable] : inputs) cell_of[variable.index] = old_cell;
  }
  for (const std::map<uint32_t, terms::TermId>& done : state.done) {
    for (const auto& [old_cell, variable] : done) cell_of[variable.index] = old_cell;
  }
  std::vector<uint64_t> values;
  terms::Random random(0xA0761D6478BD642F + state.inputs.size());
  for (int attempt = 0; attempt < kTries && comparison.RestMs() > end_ms; ++attempt) {
    // Levels of every density that change seldom in some tries and often in others.
    const uint64_t density = uint64_t{16} << attempt % 4, change = uint64_t{1} << attempt % 3;
    std::unordered_map<uint32_t, uint64_t> level;
    EvaluateCone(comparison.terms, cone, values, [&](terms::TermId variable) {
      const auto cell = cell_of.find(variable.index);
      if (cell == cell_of.end()) return uint64_t{0};
      const auto [at, first] = level.try_emplace(cell->second, 0);
      if (first || random.OneIn(change)) at->second = (random.Next() >> 9 & 255) < density ? 1 : 0;
      return at->second;
    });
    std::optional<terms::Justification> why;
    for (const OpenPair& pair : pairs) {
      if (pair.result->run || values[pair.differ.index] == 0) continue;
      if (!why) why.emplace(comparison.terms, cone, values);
      const std::vector<terms::Reason> reasons = why->ReasonsFor(pair.differ);
      if (AreMadeUp(comparison.terms, reasons)) continue;
      pair.result->verdict = PairVerdict::kDifferent;
      pair.result->run = RunOf(comparison, state, reasons, values);
    }
  }
}

}  // namespace

void SearchRuns(Comparison& comparison) {
  const auto is_shown = [](const PairResult& result) {
    return result.verdict == PairVerdict::kDifferent && !result.run.has_value();
  };
  const bool any_shown = std::ranges::any_of(comparison.results, is_shown);
  if ((comparison.UndecidedCount() == 0 && !any_shown) || comparison.Late()) return;
  // Behind a change that reaches everything the questions are large: a state answers them sooner than a run.
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = EndMs(comparison, many ? 60 : 8);
  // Nothing would be left for the questions.
  if (comparison.RestMs() <= end_ms + comparison.execution_ms) return;
  Unrolled state = PowerOn(comparison);
  for (uint32_t period = 1; period <= comparison.limits.most_periods && comparison.RestMs() > end_ms; ++period) {
    comparison.Report("runs of " + std::to_string(period) + (period == 1 ? " period" : " periods"));
    if (!Advance(comparison, state)) return;
    const uint32_t undecided = comparison.UndecidedCount();
    std::vector<OpenPair> pairs;
    for (PairResult& result : comparison.results) {
      // A longer run is known of what is different; a short one is easier to read.
      if (!comparison.IsLookedAt(result, undecided) && !is_shown(result)) continue;
      const terms::TermId differ =
          comparison.terms.Ne(state.old_state[result.old_cell.index], state.new_state[result.new_cell.index]);
      if (!comparison.terms.IsFalse(differ)) pairs.push_back({&result, differ});
    }
    if (pairs.empty()) continue;
    TryRandomInputs(comparison, state, pairs, end_ms);
    for (const OpenPair& pair : pairs) {
      if (pair.result->run || comparison.RestMs() <= end_ms) continue;
      const auto rest_ms = static_cast<uint32_t>(comparison.RestMs() - end_ms);
      const solver::Answer answer =
          comparison.solver->Check({&pair.differ, 1}, std::min(comparison.limits.question_ms, rest_ms));
      if (answer != solver::Answer::kPossible) continue;
      const std::vector<terms::TermId> cone = terms::ConeOf(comparison.terms, {&pair.differ, 1});
      const std::vector<uint64_t> values = solver::ModelValues(comparison.terms, *comparison.solver, cone);
      // It differs only with what the solver made up for functions whose values are known.
      if (values[pair.differ.index] == 0) continue;
      const std::vector<terms::Reason> reasons =
          terms::Justification(comparison.terms, cone, values).ReasonsFor(pair.differ);
      // Otherwise it is a run to be tried.
      if (!AreMadeUp(comparison.terms, reasons)) pair.result->verdict = PairVerdict::kDifferent;
      pair.result->run = RunOf(comparison, state, reasons, values);
    }
  }
}

namespace {

/// The parts of the state, as pairs, by the variable that they are of.
class StateVariables {
 public:
  explicit StateVariables(Comparison& comparison) : terms_(comparison.terms) {
    for (const PairResult& result : comparison.results) {
      const terms::TermId initial = comparison.pairing.Initial(Which::kOld, result.old_cell);
      const terms::Term& term = terms_[initial];
      const bool is_part = term.kind == terms::TermKind::kExtract;
      parts_[is_part ? term.a : initial.index].push_back(
          {&result, is_part ? term.b : 0, is_part ? term.width : uint8_t{64}});
    }
  }

  /// The state in which a pair differs, as far as it matters.
  Run StateOf(const std::vector<terms::Reason>& reasons, const std::vector<uint64_t>& values) const {
    Run run{.periods = {{}}, .from_state = true};
    for (const terms::Reason& reason : reasons) {
      const auto parts = parts_.find(reason.term.index);
      if (parts == parts_.end()) continue;
      for (const auto& [result, low, width] : parts->second) {
        if (terms::Masked(reason.bits >> low, width) == 0) continue;
        run.periods[0].push_back({.old_cell = result->old_cell,
                                  .new_cell = result->new_cell,
                                  .value = terms::Masked(values[reason.term.index] >> low, width)});
      }
    }
    std::ranges::sort(run.periods[0], {}, &SetCell::old_cell);
    return run;
  }

 private:
  struct StatePart {
    const PairResult* result;
    uint32_t low;
    uint8_t width;
  };
  const terms::Terms& terms_;
  std::unordered_map<uint32_t, std::vector<StatePart>> parts_;  // looked up only
};

/// Most pairs differ in some of a few random states, where the solver would look for long in a large program.
void TryRandomStates(Comparison& comparison, const std::vector<OpenPair>& pairs, const StateVariables& variables,
                     uint64_t end_ms) {
  constexpr int kStates = 64;
  constexpr size_t kMostFound = 300;  // more of them nobody reads
  size_t found = 0;
  const std::vector<terms::TermId> cone = ConeOf(comparison, pairs);
  std::vector<uint64_t> values;
  terms::Random random(0x2545F4914F6CDD1D);
  for (int state = 0; state < kStates && found < kMostFound && comparison.RestMs() > end_ms; ++state) {
    // Bits of every density: much of a machine is 0.
    const uint64_t density = uint64_t{8} << state % 5;
    EvaluateCone(comparison.terms, cone, values, [&](terms::TermId variable) {
      return comparison.terms.Width(variable) == 1 ? uint64_t{(random.Next() & 255) < density}
                                                   : random.Next() & random.Next();
    });
    std::optional<terms::Justification> why;
    for (const OpenPair& pair : pairs) {
      if (pair.result->run || values[pair.differ.index] == 0 || found == kMostFound) continue;
      if (!why) why.emplace(comparison.terms, cone, values);
      ++found;
      pair.result->run = variables.StateOf(why->ReasonsFor(pair.differ), values);
    }
  }
}

}  // namespace

void SearchStates(Comparison& comparison) {
  if (comparison.UndecidedCount() == 0 || comparison.Late()) return;
  comparison.Report("states");
  for (const PairResult& result : comparison.results) comparison.pairing.Join(result.old_cell);
  // Inputs are a part of the state here: a scenario sets them, and the host leaves them alone.
  if (!ExecutePart(comparison, Part::kPeriod, HostAnswers::kNothing)) return;
  std::vector<OpenPair> pairs;
  for (PairResult& result : comparison.results) {
    if (result.verdict != PairVerdict::kUndecided || !result.changed_itself) continue;
    const terms::TermId differ =
        comparison.terms.Ne(comparison.NextOld(result.old_cell), comparison.NextNew(result.new_cell));
    if (!comparison.terms.IsFalse(differ)) pairs.push_back({&result, differ});
  }
  if (pairs.empty()) return;
  std::ranges::stable_partition(pairs, [&comparison](const OpenPair& pair) {
    return DirectionOf(comparison.old_version, pair.result->old_cell) == ir::Direction::kOutput;
  });
  const StateVariables variables(comparison);
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = many ? EndMs(comparison, 90) : 0;
  const bool any_state = comparison.old_invariants.empty() && comparison.new_invariants.empty();
  if (any_state && many) TryRandomStates(comparison, pairs, variables, end_ms);
  comparison.PushInvariants();
  for (const OpenPair& pair : pairs) {
    if (pair.result->run || comparison.RestMs() <= end_ms) continue;
    const auto rest_ms = static_cast<uint32_t>(comparison.RestMs() - end_ms);
    const solver::Answer answer =
        comparison.solver->Check({&pair.differ, 1}, std::min(comparison.limits.question_ms, rest_ms));
    if (answer != solver::Answer::kPossible) continue;
    const std::vector<terms::TermId> cone = terms::ConeOf(comparison.terms, {&pair.differ, 1});
    const std::vector<uint64_t> values = solver::ModelValues(comparison.terms, *comparison.solver, cone);
    if (values[pair.differ.index] == 0) continue;
    pair.result->run =
        variables.StateOf(terms::Justification(comparison.terms, cone, values).ReasonsFor(pair.differ), values);
  }
  comparison.solver->Pop();
}

}  // namespace plcxx::prove::compare
