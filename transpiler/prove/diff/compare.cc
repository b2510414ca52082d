#include "transpiler/prove/diff/compare.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/diff/relations.h"
#include "transpiler/prove/diff/renamed.h"
#include "transpiler/prove/machine/inputs.h"

namespace plcxx::prove::diff {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
constexpr size_t kMostReached = 2000;  // pairs
// Of the time, and no more than: for what proves all equal at once, when there is nothing else to be found out.
constexpr uint64_t kFirstRoundShare = 12, kFirstRoundMs = 2000;
constexpr uint64_t kRoundOfManyShare = 20, kInductionOfManyShare = 4;  // of the time
// For what is guessed and proved soon. A question takes as long as it takes: of a short time a larger share.
constexpr uint64_t kInvariantsShare = 40, kRelationsShare = 16, kLargestShare = 8, kEnoughMs = 1000;

/// By some host function.
bool MayBeSeen(const machine::Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kBit &&
         (execute::HostSees(ir::HostAccess::kReadsState, version.program->spaces[cell.space]) ||
          execute::HostSees(ir::HostAccess::kReadsRetentive, version.program->spaces[cell.space]));
}

void AddMatched(Comparison& comparison) {
  comparison.result_of_old.assign(comparison.old_version.cells.count, kNone);
  const OneSidedMemory one_sided(comparison.old_version, comparison.new_version, comparison.old_uses,
                                 comparison.new_uses, comparison.match);
  comparison.one_sided = one_sided.Written();
  for (uint32_t i = 0; i < comparison.old_version.cells.count; ++i) {
    const execute::CellId old_cell(i), new_cell = comparison.match.new_of_old[i];
    if (!new_cell.valid() || !machine::IsState(comparison.old_version, old_cell)) continue;
    const auto is_used = [](const machine::Uses& uses, execute::CellId cell) {
      return uses.reads[cell.index] || uses.writes[cell.index];
    };
    // A table that no version touches by itself is there for the host.
    const bool begins_alike =
        PowerOnValue(comparison.old_version, old_cell) == PowerOnValue(comparison.new_version, new_cell);
    if (!is_used(comparison.old_uses, old_cell) && !is_used(comparison.new_uses, new_cell) && begins_alike) continue;
    // A flag that one version alone uses is how it does something, not what it does: it may be anything in the proof.
    // What holds of it in the version that does not use it says nothing about the other one: two variables.
    if (one_sided.Has(old_cell)) {
      comparison.pairing.Separate(old_cell);
      continue;
    }
    comparison.result_of_old[i] = static_cast<uint32_t>(comparison.results.size());
    comparison.results.push_back({.old_cell = old_cell, .new_cell = new_cell, .reason = {}});
    const bool written = comparison.old_uses.writes[i] || comparison.new_uses.writes[new_cell.index];
    if (written && MayBeSeen(comparison.old_version, old_cell) && MayBeSeen(comparison.new_version, new_cell)) {
      comparison.old_observed.push_back(old_cell);
      comparison.new_observed.push_back(new_cell);
    }
  }
}

/// What only one version has: a difference where the host sees it.
void AddUnmatched(const Comparison& comparison, CompareResult& all) {
  const auto add = [&all](const machine::Version& version, const machine::Uses& uses, execute::CellId cell,
                          PairResult result) {
    if (!machine::IsState(version, cell) || !uses.writes[cell.index]) return;
    if (IsPrivate(version, cell)) return;  // one-sided
    const bool visible = machine::DirectionOf(version, cell) == ir::Direction::kOutput;
    result.verdict = visible ? PairVerdict::kDifferent : PairVerdict::kUndecided;
    result.changed_itself = true;
    result.reason = "only one version has it";
    all.pairs.push_back(std::move(result));
  };
  for (uint32_t i = 0; i < comparison.old_version.cells.count; ++i) {
    if (comparison.match.new_of_old[i].valid()) continue;
    add(comparison.old_version, comparison.old_uses, execute::CellId(i),
        {.old_cell = execute::CellId(i), .reason = {}});
  }
  for (uint32_t i = 0; i < comparison.new_version.cells.count; ++i) {
    if (comparison.match.old_of_new[i].valid()) continue;
    add(comparison.new_version, comparison.new_uses, execute::CellId(i),
        {.new_cell = execute::CellId(i), .reason = {}});
  }
}

void SetVerdicts(Comparison& comparison) {
  for (PairResult& result : comparison.results) {
    if (result.verdict != PairVerdict::kUndecided) continue;
    const bool written =
        comparison.old_uses.writes[result.old_cell.index] || comparison.new_uses.writes[result.new_cell.index];
    result.verdict = !comparison.pairing.IsEqual(result.old_cell) ? PairVerdict::kUndecided
                     : written                                    ? PairVerdict::kEqual
                                                                  : PairVerdict::kUntouched;
  }
}

Sought SoughtOf(const Comparison& comparison) {
  Sought sought;
  for (const PairResult& result : comparison.results) {
    sought.all.push_back(result.old_cell);
    if (result.run && !result.run->from_state) sought.runs.push_back(*result.run);
    if (!comparison.pairing.IsEqual(result.old_cell) && result.verdict == PairVerdict::kUndecided)
      sought.open.push_back(result.old_cell);
  }
  std::ranges::stable_sort(sought.open, {}, [&comparison](execute::CellId cell) {
    if (comparison.results[comparison.result_of_old[cell.index]].changed_itself) return 0;
    return machine::DirectionOf(comparison.old_version, cell) == ir::Direction::kOutput ? 1 : 2;
  });
  return sought;
}

/// Whether longer runs may tell something that is not known.
bool IsAnySought(const Comparison& comparison) {
  if (!comparison.runs.find_different) return false;
  return std::ranges::any_of(comparison.results, [&comparison](const PairResult& result) {
    return result.verdict == PairVerdict::kUndecided && comparison.runs.is_sought(result.old_cell);
  });
}

/// Gives how many open pairs differ.
uint32_t MarkDifferent(Comparison& comparison, Effort effort, uint64_t most_ms = 0) {
  if (!comparison.runs.find_different) return 0;
  const Sought sought = SoughtOf(comparison);
  if (sought.open.empty()) return 0;
  comparison.Report("running both");
  uint32_t added = 0;
  for (const execute::CellId cell : comparison.runs.find_different(sought, effort, most_ms)) {
    PairResult& result = comparison.results[comparison.result_of_old[cell.index]];
    added += result.verdict == PairVerdict::kUndecided ? 1 : 0;
    result.verdict = PairVerdict::kDifferent;
    comparison.pairing.Separate(cell);
  }
  return added;
}

/// What is different for certain is not taken for equal; the rest is tried again.
void JoinAllButDifferent(Comparison& comparison) {
  for (const PairResult& result : comparison.results) {
    if (result.verdict == PairVerdict::kDifferent) {
      comparison.pairing.Separate(result.old_cell);
    } else {
      comparison.pairing.Join(result.old_cell);
    }
  }
}

std::vector<execute::CellId> SeparatedCells(const Comparison& comparison) {
  std::vector<execute::CellId> separated;
  for (const PairResult& result : comparison.results) {
    if (!comparison.pairing.IsEqual(result.old_cell)) separated.push_back(result.old_cell);
  }
  return separated;
}

/// Of cells that the versions would write.
uint32_t ConstantCount(const Comparison& comparison) {
  uint32_t count = 0;
  for (const PairResult& result : comparison.results) {
    const bool written =
        comparison.old_uses.writes[result.old_cell.index] || comparison.new_uses.writes[result.new_cell.index];
    count += written && comparison.pairing.IsConstantPair(result.old_cell) ? 1 : 0;
  }
  return count;
}

/// Back to what is proved.
void SeparateUndecided(Comparison& comparison) {
  for (const PairResult& result : comparison.results) {
    if (result.verdict == PairVerdict::kUndecided) comparison.pairing.Separate(result.old_cell);
  }
}

/// What one version keeps in memory of its own the other one may keep in its own: with such cells as pairs the rest is
/// compared once more. What is proved then is proved, for the pairs are no inputs in either comparison.
void ProveWithRenamed(Comparison& comparison) {
  constexpr uint64_t kRenamedShare = 10, kShortMs = 3000;  // of the time; what a short one may cost
  JoinAllButDifferent(comparison);
  const std::vector<std::pair<execute::CellId, execute::CellId>> renamed = GuessRenamed(comparison);
  if (renamed.empty()) return;
  Match match = comparison.match;
  for (const auto& [old_cell, new_cell] : renamed) {
    const execute::CellId old_partner = match.new_of_old[old_cell.index],
                          new_partner = match.old_of_new[new_cell.index];
    if (old_partner.valid()) match.old_of_new[old_partner.index] = {};
    if (new_partner.valid()) match.new_of_old[new_partner.index] = {};
    match.new_of_old[old_cell.index] = new_cell;
    match.old_of_new[new_cell.index] = old_cell;
  }
  const SimulatedRuns no_runs;
  const CompareLimits limits{
      .question_ms = comparison.limits.question_ms,
      .total_ms = std::min(comparison.RestMs() / 4, std::max(comparison.limits.total_ms / kRenamedShare, kShortMs)),
      .progress = comparison.limits.progress};
  Comparison again(comparison.old_version, comparison.new_version, match, no_runs, limits);
  if (!again.refusal.empty()) return;
  AddMatched(again);
  for (PairResult& result : again.results) {
    const PairResult* const known = comparison.ResultOf(result.old_cell);
    if (known == nullptr || known->verdict != PairVerdict::kDifferent) continue;
    result.verdict = PairVerdict::kDifferent;
    again.pairing.Separate(result.old_cell);
  }
  again.round_ms = limits.total_ms / 3;
  if (!CheckPowerOn(again) || !FindInductiveSet(again) || !again.is_inductive) return;
  for (PairResult& result : comparison.results) {
    const PairResult* const there = again.ResultOf(result.old_cell);
    const bool is_proved = result.verdict == PairVerdict::kUndecided && there != nullptr &&
                           there->new_cell == result.new_cell && again.pairing.IsEqual(result.old_cell);
    if (is_proved) result.verdict = PairVerdict::kEqual;
  }
}

/// What anybody may set and neither version writes is no item of a comparison that was not finished.
void LeaveOutInputs(Comparison& comparison) {
  for (PairResult& result : comparison.results) {
    const bool written =
        comparison.old_uses.writes[result.old_cell.index] || comparison.new_uses.writes[result.new_cell.index];
    if (result.verdict == PairVerdict::kUndecided && !written && comparison.IsInput(result.old_cell))
      result.verdict = PairVerdict::kUntouched;
  }
}

CompareResult Finish(Comparison& comparison, uint32_t invariants) {
  if (comparison.Late()) LeaveOutInputs(comparison);
  const bool many = comparison.UndecidedCount() > kMostLookedAt;
  CompareResult result{.pairs = std::move(comparison.results),
                       .refusal = comparison.refusal,
                       .invariants = invariants,
                       .changes_are_found = comparison.changes_are_found,
                       .one_sided = std::move(comparison.one_sided)};
  for (PairResult& pair : result.pairs) {
    if (pair.verdict != PairVerdict::kUndecided || !pair.reason.empty()) continue;
    pair.reason = comparison.Late() ? "the time was not enough"
                  : many && pair.changed_itself
                      ? "no run or state that was tried shows a difference, and equality is not proved"
                  : many ? "the change reaches too much to look at each"
                         : "no run of " + std::to_string(comparison.limits.most_periods) +
                               " periods from power-on shows a difference, and equality is not proved";
  }
  if (result.refusal.empty()) AddUnmatched(comparison, result);
  return result;
}

}  // namespace

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
  const uint32_t index = old_cell.valid() ? result_of_old[old_cell.index] : kNone;
  return index == kNone ? nullptr : &results[index];
}

bool Comparison::IsInput(execute::CellId old_cell) const {
  // The operator may send a text at any time.
  const execute::CellId new_cell = match.new_of_old[old_cell.index];
  if (machine::IsInbox(old_version, old_cell) || (new_cell.valid() && machine::IsInbox(new_version, new_cell)))
    return true;
  return IsInputPair(old_version, new_version, old_uses, new_uses, match, old_cell);
}

terms::TermId Comparison::NextOld(execute::CellId cell) {
  const terms::TermId next = old_next.next[cell.index];
  return next.valid() ? next : pairing.Initial(Which::kOld, cell);
}

terms::TermId Comparison::NextNew(execute::CellId cell) {
  const terms::TermId next = new_next.next[cell.index];
  return next.valid() ? next : pairing.Initial(Which::kNew, cell);
}

CompareResult CompareVersions(const machine::Version& old_version, const machine::Version& new_version,
                              const Match& match, const SimulatedRuns& runs, const CompareLimits& limits) {
  Comparison comparison(old_version, new_version, match, runs, limits);
  if (!comparison.refusal.empty()) return Finish(comparison, 0);
  AddMatched(comparison);
  // What a scenario shows needs no proof, and scenarios are there however large the program is.
  if (runs.find_different)
    comparison.before_questions = [&] { runs.find_different(SoughtOf(comparison), Effort::kScenarios, 0); };
  // What is not executed to its end in time is not decided, but what runs have shown is known.
  const auto finish_early = [&] {
    for (const PairResult& result : comparison.results) comparison.pairing.Separate(result.old_cell);
    if (comparison.refusal.empty()) MarkDifferent(comparison, Effort::kScenarios);
    return Finish(comparison, 0);
  };
  const uint64_t later_round_ms = comparison.round_ms;
  comparison.round_ms = std::max(comparison.round_ms, std::min(limits.total_ms / kFirstRoundShare, kFirstRoundMs));
  // With everything taken for equal: which functions differ by themselves.
  if (!CheckPowerOn(comparison)) return finish_early();
  const auto any_separated = [&] { return !SeparatedCells(comparison).empty(); };
  bool at_power_on = !any_separated();
  if (!FindInductiveSet(comparison, {.most_rounds = 1})) return finish_early();
  // Much of what a change reaches is masked by what never changes.
  uint32_t constants = 0;
  if (any_separated()) {
    JoinAllButDifferent(comparison);
    if (!FindConstants(comparison)) return finish_early();
    constants = ConstantCount(comparison);
    if (!CheckPowerOn(comparison)) return finish_early();
    at_power_on = !any_separated();
    if (!FindInductiveSet(comparison, {.most_rounds = 1})) return finish_early();
  }
  // Equal at power-on, after a failure of power and after each part from every state in which all is equal.
  if (at_power_on && comparison.is_inductive && !any_separated()) {
    comparison.changes_are_found = true;  // there are none
    SetVerdicts(comparison);
    return Finish(comparison, constants);
  }
  comparison.round_ms = later_round_ms;
  // Of a change that reaches very much only its reach is found out, not what is masked inside.
  std::vector<execute::CellId> reach;
  if (at_power_on) {
    std::optional<std::vector<execute::CellId>> found = ReachOfDifferences(comparison);
    if (!found) return finish_early();
    reach = std::move(*found);
  }
  const bool reaches_much = reach.size() > kMostReached;
  if (!SeparatePropagated(comparison)) return finish_early();
  comparison.changes_are_found = true;
  // What a short run shows to differ needs no proof: a difference may take a scan for each step of its way.
  MarkDifferent(comparison, Effort::kQuick);
  uint32_t beyond_reach = 0;
  bool is_found = false;
  if (reaches_much) {
    // What is masked on the way is found in some rounds, or not in time: then what is reached is what is open.
    const std::vector<execute::CellId> separated = SeparatedCells(comparison);
    const uint64_t before_ms = std::exchange(comparison.round_ms, limits.total_ms / kRoundOfManyShare);
    const uint64_t end_ms =
        comparison.RestMs() - std::min(comparison.RestMs(), limits.total_ms / kInductionOfManyShare);
    if (!FindInductiveSet(comparison, {.end_ms = end_ms})) return finish_early();
    comparison.round_ms = before_ms;
    is_found = comparison.is_inductive;
    if (!is_found) {
      JoinAllButDifferent(comparison);
      for (const std::vector<execute::CellId>* const cells : {&separated, &std::as_const(reach)}) {
        for (const execute::CellId cell : *cells) comparison.pairing.Separate(cell);
      }
      if (!SeparateAfterPowerFailure(comparison, beyond_reach)) return finish_early();
    }
  }
  if (!is_found && (!reaches_much || beyond_reach != 0) && !FindInductiveSet(comparison)) return finish_early();
  SetVerdicts(comparison);
  uint32_t invariants = constants;
  // The solver's runs are the shortest ones; longer ones are tried for what these leave.
  SearchRuns(comparison);
  // What was taken out for the sake of a pair that no run tells apart may be equal after all, in the states that can be
  // reached: that is tried before long runs are.
  const auto try_reachable = [&] {
    JoinAllButDifferent(comparison);
    if (CheckPowerOn(comparison) && FindInductiveSet(comparison)) SetVerdicts(comparison);
  };
  const auto is_tried = [&] {
    const uint32_t undecided = comparison.UndecidedCount();
    return undecided > 0 && undecided <= kMostLookedAt && !comparison.Late();
  };
  const auto try_invariants = [&](uint64_t most_ms) {
    JoinAllButDifferent(comparison);
    const size_t before = comparison.InvariantCount();
    const bool any = AddInvariants(comparison, most_ms);
    invariants = constants + static_cast<uint32_t>(comparison.InvariantCount());
    if (any && invariants != before) {
      try_reachable();
    } else {
      SeparateUndecided(comparison);
    }
  };
  const auto try_relations = [&] {
    SeparateUndecided(comparison);
    for (std::vector<Relation>& relations : GuessRelations(comparison)) {
      comparison.relations = std::move(relations);
      comparison.Report("relations");
      try_reachable();
      invariants = constants + static_cast<uint32_t>(comparison.InvariantCount());
      if (!is_tried()) return;
    }
  };
  if (is_tried()) {
    ProveWithRenamed(comparison);
    SeparateUndecided(comparison);
  }
  // Those that are found soon; where many are guessed, runs are the better use of the time, and come first.
  const auto soon_ms = [&limits](uint64_t share) {
    return std::max(limits.total_ms / share, std::min(limits.total_ms / kLargestShare, kEnoughMs));
  };
  comparison.round_ms = soon_ms(kRelationsShare);
  if (is_tried()) try_invariants(soon_ms(kInvariantsShare));
  if (is_tried()) try_relations();
  comparison.round_ms = limits.total_ms / 4;
  const uint32_t undecided = comparison.UndecidedCount();
  MarkDifferent(comparison, Effort::kThorough);
  // Of a machine at work more can be guessed.
  for (invariants::InvariantFinder* const finder : {comparison.old_finder.get(), comparison.new_finder.get()})
    if (finder != nullptr) finder->GuessAgain();
  if (is_tried()) try_relations();
  const auto lacks_invariants = [&] {
    return !comparison.old_finder || !comparison.old_finder->is_done() || !comparison.new_finder->is_done();
  };
  if (is_tried() && lacks_invariants()) {
    try_invariants(std::min(comparison.RestMs() / 3, limits.total_ms / 10));
  } else if (is_tried() && comparison.UndecidedCount() < undecided) {
    try_reachable();
  }
  // What is left of the time is used while something is open.
  constexpr uint64_t kStatesShare = 12, kRoundShare = 8;
  while (IsAnySought(comparison) && comparison.RestMs() > limits.total_ms / kStatesShare + limits.total_ms / 100) {
    const auto share_ms = [&] {
      const uint64_t rest_ms = comparison.RestMs() - std::min(comparison.RestMs(), limits.total_ms / kStatesShare);
      return std::min(rest_ms, std::max<uint64_t>(1, limits.total_ms / kRoundShare));
    };
    if (is_tried() && lacks_invariants()) try_invariants(share_ms() / 2);
    if (MarkDifferent(comparison, Effort::kLasting, share_ms()) != 0 && is_tried()) try_reachable();
  }
  SearchStates(comparison);
  return Finish(comparison, invariants);
}

}  // namespace plcxx::prove::diff
