#include "transpiler/prove/diff/runs_from.h"

#include <algorithm>

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

}  // namespace

void RunsFrom(const UnrolledVersions& versions, const SeenState& state, const std::vector<execute::CellId>& sought,
              const AimLimits& limits, const std::function<bool(execute::CellId)>& is_open,
              const std::function<void(const Run&)>& found) {
  terms::Terms terms;
  const solver::LoadedSolver loaded = solver::LoadSolver(terms);
  if (!loaded.solver) return;
  const auto rest_ms = [&limits] {
    using std::chrono::milliseconds;
    return std::chrono::duration_cast<milliseconds>(limits.end - std::chrono::steady_clock::now()).count();
  };
  const auto is_late = [&rest_ms] { return rest_ms() <= 0; };
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
      const auto limit =
          solver::Limit::Effort(limits.question_ms).Within(static_cast<uint64_t>(std::max<int64_t>(1, rest_ms())));
      if (loaded.solver->Check({&differ, 1}, limit) != solver::Answer::kPossible) continue;
      const std::vector<terms::TermId> cone = terms::ConeOf(terms, {&differ, 1});
      const std::vector<uint64_t> values = solver::ModelValues(terms, *loaded.solver, cone);
      found(unrolled.RunOf(terms::Justification(terms, cone, values).ReasonsFor(differ), values));
      std::erase(open, question.cell);
    }
    std::erase_if(open, [&](execute::CellId cell) { return !is_open(cell); });
  }
}

}  // namespace plcxx::prove::diff
