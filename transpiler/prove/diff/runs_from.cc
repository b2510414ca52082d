#include "transpiler/prove/diff/runs_from.h"

#include <algorithm>

#include "transpiler/symbolic/solver/model.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::diff {
namespace {

constexpr size_t kMostQuestions = 12;  // of one state: what is not found here may be found from the next one
constexpr int64_t kQuestionMs = 200;

}  // namespace

std::vector<Run> RunsFrom(const UnrolledVersions& versions, const SeenState& state,
                          const std::vector<execute::CellId>& sought, uint32_t most_periods,
                          std::chrono::steady_clock::time_point end) {
  terms::Terms terms;
  const solver::LoadedSolver loaded = solver::LoadSolver(terms);
  if (!loaded.solver) return {};
  const auto is_late = [end] { return std::chrono::steady_clock::now() >= end; };
  Unrolled unrolled(terms, versions, InputsChange::kOnce);
  unrolled.BeginAt(state.value, state.now_ms);
  std::vector<Run> runs;
  std::vector<execute::CellId> open = sought;
  size_t questions = 0;
  for (uint32_t period = 0; period < most_periods && !open.empty(); ++period) {
    if (!unrolled.Advance(is_late)) break;
    const auto is_found = [&](execute::CellId cell) {
      const terms::TermId differ = terms.Ne(unrolled.Old(cell), unrolled.New(versions.match.new_of_old[cell.index]));
      if (terms.IsFalse(differ) || questions >= kMostQuestions || is_late()) return false;
      ++questions;
      const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      const auto most_ms = static_cast<uint32_t>(std::clamp<int64_t>(rest.count(), 1, kQuestionMs));
      if (loaded.solver->Check({&differ, 1}, most_ms) != solver::Answer::kPossible) return false;
      const std::vector<terms::TermId> cone = terms::ConeOf(terms, {&differ, 1});
      const std::vector<uint64_t> values = solver::ModelValues(terms, *loaded.solver, cone);
      runs.push_back(unrolled.RunOf(terms::Justification(terms, cone, values).ReasonsFor(differ), values));
      return true;
    };
    std::erase_if(open, is_found);
    if (questions >= kMostQuestions || is_late()) break;
  }
  return runs;
}

}  // namespace plcxx::prove::diff
