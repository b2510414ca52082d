// Runs from power-on, period by period, until a pair differs.
#include <algorithm>
#include <map>
#include <unordered_map>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/diff/unrolled.h"
#include "transpiler/symbolic/solver/model.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/justify.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::diff {
namespace {

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
  std::vector<uint64_t> values;
  terms::Random random(0xA0761D6478BD642F + state.periods());
  for (int attempt = 0; attempt < kTries && comparison.RestMs() > end_ms; ++attempt) {
    // Levels of every density that change seldom in some tries and often in others.
    const uint64_t density = uint64_t{16} << attempt % 4, change = uint64_t{1} << attempt % 3;
    std::unordered_map<uint32_t, uint64_t> level;
    EvaluateCone(comparison.terms, cone, values, [&](terms::TermId variable) {
      const std::optional<uint32_t> cell = state.CellOf(variable);
      if (!cell) return uint64_t{0};
      const auto [at, first] = level.try_emplace(*cell, 0);
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
      pair.result->run = state.RunOf(reasons, values);
    }
  }
}

/// Whether a version reads memory that may be anything when power comes for the first time.
bool ReadsKept(const Comparison& comparison) {
  return std::ranges::any_of(comparison.results, [&comparison](const PairResult& result) {
    return MayBeKept(comparison.old_version, comparison.new_version, comparison.match, result.old_cell) &&
           (comparison.old_uses.reads[result.old_cell.index] || comparison.new_uses.reads[result.new_cell.index]);
  });
}

void SearchRunsWith(Comparison& comparison, Kept kept) {
  const auto is_shown = [kept](const PairResult& result) {
    return kept == Kept::kNothing && result.verdict == PairVerdict::kDifferent && !result.run.has_value();
  };
  const bool any_shown = std::ranges::any_of(comparison.results, is_shown);
  if ((comparison.UndecidedCount() == 0 && !any_shown) || comparison.Late()) return;
  // After a change that reaches everything the questions are large: a state answers them sooner than a run.
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = EndMs(comparison, many ? 60 : 8);
  // Nothing would be left for the questions.
  if (comparison.RestMs() <= end_ms + comparison.execution_ms) return;
  Unrolled state(comparison.terms,
                 {.old_version = comparison.old_version,
                  .new_version = comparison.new_version,
                  .match = comparison.match,
                  .old_uses = comparison.old_uses,
                  .new_uses = comparison.new_uses,
                  .requests = comparison.requests},
                 InputsChange::kEachPeriod);
  state.PowerOn(kept);
  for (uint32_t period = 1; period <= comparison.limits.most_periods && comparison.RestMs() > end_ms; ++period) {
    comparison.Report("runs of " + std::to_string(period) + (period == 1 ? " period" : " periods"));
    if (!state.Advance([&comparison] { return comparison.Late(); })) return;
    const uint32_t undecided = comparison.UndecidedCount();
    std::vector<OpenPair> pairs;
    for (PairResult& result : comparison.results) {
      // A longer run is known of what is different; a short one is easier to read.
      if (!comparison.IsLookedAt(result, undecided) && !is_shown(result)) continue;
      const terms::TermId differ = comparison.terms.Ne(state.Old(result.old_cell), state.New(result.new_cell));
      if (!comparison.terms.IsFalse(differ)) pairs.push_back({&result, differ});
    }
    if (pairs.empty()) continue;
    TryRandomInputs(comparison, state, pairs, end_ms);
    for (const OpenPair& pair : pairs) {
      if (pair.result->run || comparison.RestMs() <= end_ms) continue;
      const uint64_t rest_ms = comparison.RestMs() - end_ms;
      const solver::Answer answer = comparison.solver->Check(
          {&pair.differ, 1}, solver::Limit::Effort(comparison.limits.question_ms).Within(rest_ms));
      if (answer != solver::Answer::kPossible) continue;
      const std::vector<terms::TermId> cone = terms::ConeOf(comparison.terms, {&pair.differ, 1});
      const std::vector<uint64_t> values = solver::ModelValues(comparison.terms, *comparison.solver, cone);
      // It differs only with what the solver made up for functions whose values are known.
      if (values[pair.differ.index] == 0) continue;
      const std::vector<terms::Reason> reasons =
          terms::Justification(comparison.terms, cone, values).ReasonsFor(pair.differ);
      // Otherwise it is a run to be tried.
      if (!AreMadeUp(comparison.terms, reasons)) pair.result->verdict = PairVerdict::kDifferent;
      pair.result->run = state.RunOf(reasons, values);
    }
  }
}

}  // namespace

void SearchRuns(Comparison& comparison) {
  SearchRunsWith(comparison, Kept::kNothing);
  if (ReadsKept(comparison)) SearchRunsWith(comparison, Kept::kAnything);
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
  if (!ExecutePart(comparison, machine::Part::kPeriod, machine::HostAnswers::kNothing)) return;
  std::vector<OpenPair> pairs;
  for (PairResult& result : comparison.results) {
    if (result.verdict != PairVerdict::kUndecided || !result.changed_itself) continue;
    const terms::TermId differ =
        comparison.terms.Ne(comparison.NextOld(result.old_cell), comparison.NextNew(result.new_cell));
    if (!comparison.terms.IsFalse(differ)) pairs.push_back({&result, differ});
  }
  if (pairs.empty()) return;
  std::ranges::stable_partition(pairs, [&comparison](const OpenPair& pair) {
    return machine::DirectionOf(comparison.old_version, pair.result->old_cell) == ir::Direction::kOutput;
  });
  const StateVariables variables(comparison);
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  const uint64_t end_ms = many ? EndMs(comparison, 90) : 0;
  const bool any_state = comparison.InvariantCount() == 0;
  if (any_state && many) TryRandomStates(comparison, pairs, variables, end_ms);
  comparison.PushInvariants();
  for (const OpenPair& pair : pairs) {
    if (pair.result->run || comparison.RestMs() <= end_ms) continue;
    const uint64_t rest_ms = comparison.RestMs() - end_ms;
    const solver::Answer answer = comparison.solver->Check(
        {&pair.differ, 1}, solver::Limit::Effort(comparison.limits.question_ms).Within(rest_ms));
    if (answer != solver::Answer::kPossible) continue;
    const std::vector<terms::TermId> cone = terms::ConeOf(comparison.terms, {&pair.differ, 1});
    const std::vector<uint64_t> values = solver::ModelValues(comparison.terms, *comparison.solver, cone);
    if (values[pair.differ.index] == 0) continue;
    pair.result->run =
        variables.StateOf(terms::Justification(comparison.terms, cone, values).ReasonsFor(pair.differ), values);
  }
  comparison.solver->Pop();
}

}  // namespace plcxx::prove::diff
