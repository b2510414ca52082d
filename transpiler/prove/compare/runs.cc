// Runs from power-on, period by period, until a pair differs.
#include <algorithm>
#include <map>

#include "transpiler/prove/compare/comparison.h"
#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"
#include "transpiler/prove/terms/random.h"

namespace plcxx::prove {
namespace {

/// The state of both versions after some periods, over the inputs so far.
struct Unrolled {
  std::vector<TermId> old_state, new_state;        // by cell
  std::vector<std::map<uint32_t, TermId>> inputs;  // by period: what each input (an old cell) is
};

void SetInput(Comparison& comparison, Unrolled& state, uint32_t old_cell) {
  std::map<uint32_t, TermId>& inputs = state.inputs.back();
  if (inputs.contains(old_cell)) return;
  const Cell cell = CellAt(*comparison.old_version.program, comparison.old_version.cells, CellId(old_cell));
  inputs[old_cell] = comparison.terms.Variable(
      "period " + std::to_string(state.inputs.size()) + " " + CellName(*comparison.old_version.program, cell), 1);
}

bool Advance(Comparison& comparison, Unrolled& state) {
  const uint32_t period_ms = comparison.old_version.program->schedule.period_ms;
  const bool ends = comparison.old_version.program->schedule.period_ends_its_time;
  state.inputs.emplace_back();
  const auto now = comparison.terms.Const((state.inputs.size() - (ends ? 0 : 1)) * period_ms, 32);
  const auto run = [&](Which which) {
    const bool is_old = which == Which::kOld;
    std::vector<TermId>& values = is_old ? state.old_state : state.new_state;
    const Version& version = is_old ? comparison.old_version : comparison.new_version;
    // Inputs have a new value in every period, the same for both; they keep it until the next one.
    const auto initial = [&](CellId cell) {
      const CellId old_cell = is_old ? cell : comparison.match.old_of_new[cell.index];
      if (!old_cell.valid() || !comparison.IsInput(old_cell)) return values[cell.index];
      SetInput(comparison, state, old_cell.index);
      return state.inputs.back()[old_cell.index];
    };
    for (const Part part : {Part::kFast, Part::kPeriod}) {
      if (part == Part::kFast && !HasFastPart(version)) continue;
      const Transition next =
          RunPart(comparison.terms, version, part,
                  {.initial = initial, .now = now, .answers = HostAnswers::kNothing, .outputs = {}});
      if (!next.refusal.empty()) return false;
      for (uint32_t i = 0; i < values.size(); ++i) {
        if (next.next[i].valid()) values[i] = next.next[i];
      }
    }
    return true;
  };
  return run(Which::kOld) && run(Which::kNew);
}

Unrolled PowerOn(Comparison& comparison) {
  const Surroundings surroundings{.initial = [&](CellId) { return comparison.terms.Const(0, 64); },
                                  .now = comparison.terms.Const(0, 32),
                                  .answers = HostAnswers::kNothing,
                                  .outputs = {}};
  return {.old_state = RunInit(comparison.terms, comparison.old_version, surroundings).next,
          .new_state = RunInit(comparison.terms, comparison.new_version, surroundings).next,
          .inputs = {}};
}

Run RunOf(Comparison& comparison, const Unrolled& state) {
  Run run;
  for (const std::map<uint32_t, TermId>& inputs : state.inputs) {
    run.periods.emplace_back();
    for (const auto& [old_cell, variable] : inputs) {
      run.periods.back().push_back({.old_cell = CellId(old_cell),
                                    .new_cell = comparison.match.new_of_old[old_cell],
                                    .value = comparison.solver->ValueOf(variable)});
    }
  }
  return run;
}

/// By TermId: what a term depends on; a byte's bits count with the byte.
std::vector<bool> BitsBehind(const Terms& terms, TermId root) {
  std::vector<bool> behind(terms.size());
  for (const TermId id : ConeOf(terms, {&root, 1})) behind[id.index] = true;
  for (uint32_t i = 0; i < terms.size(); ++i) {
    const Term& term = terms[TermId(i)];
    if (term.kind != TermKind::kExtract || !behind[term.a]) continue;
    if (terms[TermId(term.a)].kind == TermKind::kVariable) behind[i] = true;
  }
  return behind;
}

/// When a search that has one `part`-th of the time ends, as RestMs.
uint64_t EndMs(const Comparison& comparison, uint64_t part) {
  const uint64_t rest = comparison.RestMs();
  return rest - std::min(rest, comparison.limits.total_ms / part);
}

}  // namespace

void SearchRuns(Comparison& comparison) {
  if (comparison.UndecidedCount() == 0 || comparison.Late()) return;
  // Behind a change that reaches everything the questions are large: a state answers them sooner than a run.
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = EndMs(comparison, many ? 60 : 8);
  Unrolled state = PowerOn(comparison);
  for (uint32_t period = 1; period <= comparison.limits.most_periods && comparison.RestMs() > end_ms; ++period) {
    comparison.Report("runs of " + std::to_string(period) + (period == 1 ? " period" : " periods"));
    if (!Advance(comparison, state)) return;
    const uint32_t undecided = comparison.UndecidedCount();
    for (PairResult& result : comparison.results) {
      if (!comparison.IsLookedAt(result, undecided) || comparison.RestMs() <= end_ms) continue;
      const TermId differ =
          comparison.terms.Ne(state.old_state[result.old_cell.index], state.new_state[result.new_cell.index]);
      if (comparison.terms.IsFalse(differ)) continue;
      const auto rest_ms = static_cast<uint32_t>(comparison.RestMs() - end_ms);
      const Answer answer = comparison.solver->Check({&differ, 1}, std::min(comparison.limits.question_ms, rest_ms));
      if (answer != Answer::kPossible) continue;
      result.verdict = PairVerdict::kDifferent;
      result.run = RunOf(comparison, state);
    }
  }
}

namespace {

/// A pair that is looked at, and the term that is 1 where one period makes them differ.
struct OpenPair {
  PairResult* result;
  TermId differ;
};

/// The state in which the cells behind the pair have the given values.
Run FromState(Comparison& comparison, const OpenPair& pair, const std::function<uint64_t(TermId initial)>& value_of) {
  Run run{.periods = {{}}, .from_state = true};
  const std::vector<bool> behind = BitsBehind(comparison.terms, pair.differ);
  for (const PairResult& other : comparison.results) {
    const TermId initial = comparison.pairing.Initial(Which::kOld, other.old_cell);
    if (initial.index >= behind.size() || !behind[initial.index]) continue;
    run.periods[0].push_back({.old_cell = other.old_cell, .new_cell = other.new_cell, .value = value_of(initial)});
  }
  return run;
}

/// Most pairs differ in some of a few random states, where the solver would look for long in a large program.
void TryRandomStates(Comparison& comparison, const std::vector<OpenPair>& pairs) {
  constexpr int kStates = 64;
  std::vector<TermId> roots;
  for (const OpenPair& pair : pairs) roots.push_back(pair.differ);
  const std::vector<TermId> cone = ConeOf(comparison.terms, roots);
  std::vector<uint64_t> values(comparison.terms.size());
  Random random(0x2545F4914F6CDD1D);
  for (int state = 0; state < kStates && !comparison.Late(); ++state) {
    // Bits of every density: much of a machine is 0.
    const uint64_t density = uint64_t{8} << state % 5;
    for (const TermId id : cone) {
      const Term& term = comparison.terms[id];
      values[id.index] = EvaluateTerm(
          comparison.terms, term, [&](TermId operand) { return values[operand.index]; },
          [&](uint32_t) {
            return term.width == 1 ? uint64_t{(random.Next() & 255) < density} : random.Next() & random.Next();
          });
    }
    const auto value_of = [&](TermId initial) {
      const Term& term = comparison.terms[initial];
      return term.kind == TermKind::kExtract ? values[term.a] >> term.b & 1 : values[initial.index];
    };
    for (const OpenPair& pair : pairs) {
      if (!pair.result->run && values[pair.differ.index] != 0) pair.result->run = FromState(comparison, pair, value_of);
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
    const TermId differ = comparison.terms.Ne(comparison.NextOld(result.old_cell), comparison.NextNew(result.new_cell));
    if (!comparison.terms.IsFalse(differ)) pairs.push_back({&result, differ});
  }
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = many ? EndMs(comparison, 30) : 0;
  const bool any_state = comparison.old_invariants.empty() && comparison.new_invariants.empty();
  if (any_state && many) TryRandomStates(comparison, pairs);
  comparison.PushInvariants();
  for (const OpenPair& pair : pairs) {
    if (pair.result->run || comparison.RestMs() <= end_ms) continue;
    if (comparison.solver->Check({&pair.differ, 1}, comparison.limits.question_ms) != Answer::kPossible) continue;
    pair.result->run = FromState(comparison, pair, [&](TermId initial) { return comparison.solver->ValueOf(initial); });
  }
  comparison.solver->Pop();
}

}  // namespace plcxx::prove
