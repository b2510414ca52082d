#include "transpiler/prove/diff/comparison.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/sets.h"

namespace plcxx::prove::diff {

Comparison::Comparison(const machine::Version& old_side, const machine::Version& new_side, const Match& matching,
                       const SimulatedRuns& simulated_runs, const CompareLimits& compare_limits)
    : old_version(old_side),
      new_version(new_side),
      match(matching),
      runs(simulated_runs),
      limits(compare_limits),
      pairing(terms, old_side, new_side, matching),
      old_uses(machine::UsesOf(old_side)),
      new_uses(machine::UsesOf(new_side)),
      requests(MatchedRequests(old_side, new_side, matching)),
      round_ms(compare_limits.total_ms / 90),
      now(terms.Variable("now", 32)),
      deadline(std::chrono::steady_clock::now() + std::chrono::milliseconds(compare_limits.total_ms)) {
  solver::LoadedSolver loaded = solver::LoadSolver(terms);
  solver = std::move(loaded.solver);
  refusal = std::move(loaded.reason);
}

uint32_t Comparison::UndecidedCount() const {
  return static_cast<uint32_t>(std::ranges::count(results, PairVerdict::kUndecided, &PairResult::verdict));
}

uint64_t Comparison::RestMs() const {
  const auto rest = deadline - std::chrono::steady_clock::now();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(rest).count();
  return ms > 0 ? static_cast<uint64_t>(ms) : 0;
}

bool Comparison::IsLookedAt(const PairResult& result, uint32_t count) const {
  return result.verdict == PairVerdict::kUndecided && (count <= kMostLookedAt || result.changed_itself);
}

const PairResult* Comparison::ResultOf(execute::CellId old_cell) const {
  const uint32_t index = old_cell.valid() ? result_of_old[old_cell.index] : kNoResult;
  return index == kNoResult ? nullptr : &results[index];
}

bool Comparison::IsInput(execute::CellId old_cell) const {
  // The operator may send a text at any time.
  const execute::CellId new_cell = match.new_of_old[old_cell.index];
  if (machine::IsInbox(old_version, old_cell) || (new_cell.valid() && machine::IsInbox(new_version, new_cell)))
    return true;
  return IsInputPair(old_version, new_version, old_uses, new_uses, match, old_cell);
}

bool Comparison::IsInput(Which which, execute::CellId cell) const {
  const execute::CellId old_cell = which == Which::kOld ? cell : match.old_of_new[cell.index];
  if (old_cell.valid()) return IsInput(old_cell);
  return machine::IsInbox(new_version, cell) ||
         machine::WhatControlWrites(new_version, cell) == execute::ControlWrite::kValues ||
         (machine::MayBeSetByHost(new_version, cell) && !new_uses.sets[cell.index]);
}

terms::TermId Comparison::NextOld(execute::CellId cell) {
  const terms::TermId next = old_next.next[cell.index];
  return next.valid() ? next : pairing.Initial(Which::kOld, cell);
}

terms::TermId Comparison::NextNew(execute::CellId cell) {
  const terms::TermId next = new_next.next[cell.index];
  return next.valid() ? next : pairing.Initial(Which::kNew, cell);
}

}  // namespace plcxx::prove::diff
