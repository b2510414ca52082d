#include "transpiler/prove/diff/runs_from.h"

#include <algorithm>

#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/solver/model.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::diff {
namespace {

/// A pair that may differ after the periods so far.
struct AimQuestion {
  execute::CellId cell;
  terms::TermId old_value, new_value;
};

/// Of the open pairs, what was computed first in front: it needs the least.
std::vector<AimQuestion> AimQuestionsOf(const Unrolled& unrolled, const Match& match,
                                        const std::vector<execute::CellId>& open) {
  std::vector<AimQuestion> questions;
  for (const execute::CellId cell : open) {
    const AimQuestion question{cell, unrolled.Old(cell), unrolled.New(match.new_of_old[cell.index])};
    if (question.old_value != question.new_value) questions.push_back(question);
  }
  std::ranges::stable_sort(questions, {}, [](const AimQuestion& question) {
    return std::max(question.old_value.index, question.new_value.index);
  });
  return questions;
}

solver::Deadline DeadlineAt(std::chrono::steady_clock::time_point end) {
  using std::chrono::milliseconds;
  const auto rest = std::chrono::duration_cast<milliseconds>(end - std::chrono::steady_clock::now());
  return {solver::Clock::kWall, static_cast<uint64_t>(std::max<int64_t>(0, rest.count()))};
}

/// How `wanted` becomes true; none: it was not found out, or cannot be.
std::optional<Run> RunIn(const terms::Terms& terms, solver::Solver& solver, const Unrolled& unrolled,
                         terms::TermId wanted, uint32_t question_ms, const solver::Deadline& deadline) {
  if (solver.Check({&wanted, 1}, deadline.LimitFor(question_ms)) != solver::Answer::kPossible) return std::nullopt;
  const std::vector<terms::TermId> cone = terms::ConeOf(terms, {&wanted, 1});
  const std::vector<uint64_t> values = solver::ModelValues(terms, solver, cone);
  return unrolled.RunOf(terms::Justification(terms, cone, values).ReasonsFor(wanted), values);
}

}  // namespace

void RunsFrom(const UnrolledVersions& versions, const SeenState& state, const std::vector<execute::CellId>& sought,
              const AimLimits& limits, const std::function<bool(execute::CellId)>& is_open,
              const std::function<void(const Run&)>& found) {
  terms::Terms terms;
  const solver::LoadedSolver loaded = solver::LoadSolver(terms);
  if (!loaded.solver) return;
  const solver::Deadline deadline = DeadlineAt(limits.end);
  const auto is_late = [&deadline] { return deadline.IsOver(); };
  Unrolled unrolled(terms, versions, InputsChange::kOnce);
  unrolled.BeginAt(state.value, state.now_ms);
  std::vector<execute::CellId> open = sought;
  size_t asked = 0;
  for (uint32_t period = 0; period < limits.most_periods && !open.empty(); ++period) {
    if (!unrolled.Advance(is_late)) return;
    for (const AimQuestion& question : AimQuestionsOf(unrolled, versions.match, open)) {
      if (asked >= limits.most_questions || is_late()) return;
      // A run for another one has shown it, perhaps.
      const terms::TermId differ = terms.Ne(question.old_value, question.new_value);
      if (terms.IsFalse(differ) || !is_open(question.cell)) continue;
      ++asked;
      const std::optional<Run> run = RunIn(terms, *loaded.solver, unrolled, differ, limits.question_ms, deadline);
      if (!run) continue;
      found(*run);
      std::erase(open, question.cell);
    }
    std::erase_if(open, [&](execute::CellId cell) { return !is_open(cell); });
  }
}

std::optional<Run> RunTo(const UnrolledVersions& versions, const SeenState& state, const WantedNumber& wanted,
                         const AimLimits& limits) {
  terms::Terms terms;
  const solver::LoadedSolver loaded = solver::LoadSolver(terms);
  if (!loaded.solver) return std::nullopt;
  const solver::Deadline deadline = DeadlineAt(limits.end);
  Unrolled unrolled(terms, versions, InputsChange::kOnce);
  unrolled.BeginAt(state.value, state.now_ms);
  size_t asked = 0;
  for (uint32_t period = 0; period < limits.most_periods && asked < limits.most_questions; ++period) {
    if (!unrolled.Advance([&deadline] { return deadline.IsOver(); }) || deadline.IsOver()) return std::nullopt;
    terms::TermId number;
    for (const execute::CellId cell : wanted.cells) {
      const terms::TermId part = unrolled.Old(cell);
      number = number.valid() ? terms.Concat(part, number) : part;
    }
    terms::TermId is_wanted = terms.Const(0, 1);
    for (const uint64_t value : wanted.values)
      is_wanted = terms.Or(is_wanted, terms.Eq(number, terms.Const(value, static_cast<uint8_t>(terms.Width(number)))));
    if (wanted.is_none) is_wanted = terms.Not(is_wanted);
    if (terms.IsFalse(is_wanted)) continue;
    ++asked;
    if (std::optional<Run> run = RunIn(terms, *loaded.solver, unrolled, is_wanted, limits.question_ms, deadline))
      return run;
  }
  return std::nullopt;
}

}  // namespace plcxx::prove::diff
