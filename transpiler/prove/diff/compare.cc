#include "transpiler/prove/diff/compare.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/diff/power_on_calls.h"
#include "transpiler/prove/diff/relations.h"
#include "transpiler/prove/diff/renamed.h"

namespace plcxx::prove::diff {
namespace {

constexpr size_t kMostReached = 2000;  // pairs
// Of the time, and no more than: for what proves all equal at once, when there is nothing else to be found out.
constexpr uint64_t kFirstRoundShare = 12, kFirstRoundMs = 2000;
constexpr uint64_t kRoundOfManyShare = 20, kInductionOfManyShare = 4;  // of the time
// For what is guessed and proved soon.
constexpr uint64_t kInvariantsShare = 40, kRelationsShare = 16, kLargestShare = 8, kEnoughMs = 1000;

/// By some host function.
bool MayBeSeen(const machine::Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kBit &&
         (execute::HostSees(ir::HostAccess::kReadsState, version.program->spaces[cell.space]) ||
          execute::HostSees(ir::HostAccess::kReadsRetentive, version.program->spaces[cell.space]));
}

std::optional<Which> OnlyCaller(const Comparison& comparison, execute::CellId old_cell, execute::CellId new_cell) {
  const bool old_calls = comparison.old_uses.writes[old_cell.index],
             new_calls = comparison.new_uses.writes[new_cell.index];
  if (!new_calls && IsCalledAtPowerOn(comparison.old_version, old_cell)) return Which::kOld;
  if (!old_calls && IsCalledAtPowerOn(comparison.new_version, new_cell)) return Which::kNew;
  return std::nullopt;
}

void AddMatched(Comparison& comparison) {
  comparison.result_of_old.assign(comparison.old_version.cells.count, Comparison::kNoResult);
  const OneSidedMemory one_sided(comparison.old_version, comparison.new_version, comparison.old_uses,
                                 comparison.new_uses, comparison.match);
  comparison.one_sided = one_sided.Find();
  for (uint32_t i = 0; i < comparison.old_version.cells.count; ++i) {
    const execute::CellId old_cell(i), new_cell = comparison.match.new_of_old[i];
    if (!new_cell.valid() || !machine::IsState(comparison.old_version, old_cell)) continue;
    const auto is_used = [](const machine::Uses& uses, execute::CellId cell) {
      return uses.reads[cell.index] || uses.writes[cell.index];
    };
    // A table that no version touches by itself is there for the host.
    if (!is_used(comparison.old_uses, old_cell) && !is_used(comparison.new_uses, new_cell) &&
        comparison.BeginsAlike(old_cell, new_cell))
      continue;
    // A flag that one version alone uses is how it does something, not what it does: it may be anything in the proof.
    // What holds of it in the version that does not use it says nothing about the other one: two variables.
    if (one_sided.Has(old_cell)) {
      comparison.pairing.Separate(old_cell);
      continue;
    }
    comparison.result_of_old[i] = static_cast<uint32_t>(comparison.results.size());
    PairResult& result =
        comparison.results.emplace_back(PairResult{.old_cell = old_cell, .new_cell = new_cell, .reason = {}});
    result.only_caller = OnlyCaller(comparison, old_cell, new_cell);
    if (result.only_caller) {
      result.verdict = PairVerdict::kDifferent;
      result.changed_itself = true;
      comparison.pairing.Separate(old_cell);
    }
    if (comparison.IsWritten(result) && MayBeSeen(comparison.old_version, old_cell) &&
        MayBeSeen(comparison.new_version, new_cell)) {
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
    const bool written = comparison.IsWritten(result);
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
    const bool written = comparison.IsWritten(result);
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
    const bool written = comparison.IsWritten(result);
    if (result.verdict == PairVerdict::kUndecided && !written && comparison.IsInput(result.old_cell) &&
        comparison.BeginsAlike(result.old_cell, result.new_cell))
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
                       .one_sided = std::move(comparison.one_sided),
                       .changed_for_host = std::move(comparison.changed_for_host)};
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

/// What is known after everything was taken for equal once.
struct FirstPass {
  bool at_power_on = false;  // all are equal then
  bool is_proved = false;    // and always
  uint32_t constants = 0;    // of which that makes use
};

bool IsAnySeparated(const Comparison& comparison) { return !SeparatedCells(comparison).empty(); }

/// With everything taken for equal: which functions differ by themselves. None: it was given up.
std::optional<FirstPass> TakeAllForEqual(Comparison& comparison) {
  FirstPass pass;
  const uint64_t first_round_ms = std::min(comparison.limits.total_ms / kFirstRoundShare, kFirstRoundMs);
  const uint64_t later_round_ms = std::exchange(comparison.round_ms, std::max(comparison.round_ms, first_round_ms));
  const auto find_inductive = [&] {
    if (!CheckPowerOn(comparison)) return false;
    pass.at_power_on = !IsAnySeparated(comparison);
    return FindInductiveSet(comparison, {.most_rounds = 1});
  };
  if (!find_inductive()) return std::nullopt;
  // Much of what a change reaches is masked by what never changes.
  if (IsAnySeparated(comparison)) {
    JoinAllButDifferent(comparison);
    if (!FindConstants(comparison)) return std::nullopt;
    pass.constants = ConstantCount(comparison);
    if (!find_inductive()) return std::nullopt;
  }
  comparison.round_ms = later_round_ms;
  // Equal at power-on, after a failure of power and after each part from every state in which all is equal.
  pass.is_proved = pass.at_power_on && comparison.is_inductive && !IsAnySeparated(comparison);
  return pass;
}

enum class EqualSet : uint8_t { kFound, kOpen, kGivenUp };

/// What is masked on the way of a change is found in some rounds, or not in time: then what is reached is what is open.
EqualSet FindEqualInReach(Comparison& comparison, const std::vector<execute::CellId>& reach) {
  const std::vector<execute::CellId> separated = SeparatedCells(comparison);
  const uint64_t total_ms = comparison.limits.total_ms;
  const uint64_t before_ms = std::exchange(comparison.round_ms, total_ms / kRoundOfManyShare);
  const uint64_t end_ms = comparison.RestMs() - std::min(comparison.RestMs(), total_ms / kInductionOfManyShare);
  if (!FindInductiveSet(comparison, {.end_ms = end_ms})) return EqualSet::kGivenUp;
  comparison.round_ms = before_ms;
  if (comparison.is_inductive) return EqualSet::kFound;
  JoinAllButDifferent(comparison);
  for (const std::vector<execute::CellId>* const cells : {&separated, &reach}) {
    for (const execute::CellId cell : *cells) comparison.pairing.Separate(cell);
  }
  uint32_t beyond_reach = 0;
  if (!SeparateAfterPowerFailure(comparison, beyond_reach)) return EqualSet::kGivenUp;
  return beyond_reach == 0 ? EqualSet::kFound : EqualSet::kOpen;
}

/// The pairs that are equal in every scan, whatever the others do. To be called when those that differ by themselves
/// are separated; `at_power_on`: none of them does then. False as FindInductiveSet.
bool FindEqualPairs(Comparison& comparison, bool at_power_on) {
  // Of a change that reaches very much only its reach is found out, not what is masked inside.
  std::vector<execute::CellId> reach;
  if (at_power_on) {
    std::optional<std::vector<execute::CellId>> found = ReachOfDifferences(comparison);
    if (!found) return false;
    reach = std::move(*found);
  }
  if (!SeparatePropagated(comparison)) return false;
  comparison.changes_are_found = true;
  // What a short run shows to differ needs no proof: a difference may take a scan for each step of its way.
  MarkDifferent(comparison, Effort::kQuick);
  const EqualSet set = reach.size() > kMostReached ? FindEqualInReach(comparison, reach) : EqualSet::kOpen;
  return set == EqualSet::kFound || (set == EqualSet::kOpen && FindInductiveSet(comparison));
}

/// What is tried for the pairs that are open still, in the order of what it costs.
class Attempts {
 public:
  /// `constants`: that the proofs make use of.
  Attempts(Comparison& comparison, uint32_t constants)
      : comparison_(comparison), total_ms_(comparison.limits.total_ms), constants_(constants), invariants_(constants) {}

  /// What is found soon; where many invariants are guessed, runs are the better use of the time, and come first.
  void BeginWithProofs() {
    if (IsWorthTrying()) {
      ProveWithRenamed(comparison_);
      SeparateUndecided(comparison_);
    }
    comparison_.round_ms = ShortMs(kRelationsShare);
    if (IsWorthTrying()) TryInvariants(ShortMs(kInvariantsShare));
    if (IsWorthTrying()) TryRelations();
  }

  void SearchThoroughly() {
    comparison_.round_ms = total_ms_ / 4;
    const uint32_t undecided = comparison_.UndecidedCount();
    MarkDifferent(comparison_, Effort::kThorough);
    // Of a machine at work more can be guessed.
    for (invariants::InvariantFinder* const finder : {comparison_.old_finder.get(), comparison_.new_finder.get()})
      if (finder != nullptr) finder->GuessAgain();
    if (IsWorthTrying()) TryRelations();
    if (IsWorthTrying() && LacksInvariants()) {
      TryInvariants(std::min(comparison_.RestMs() / 3, total_ms_ / 10));
    } else if (IsWorthTrying() && comparison_.UndecidedCount() < undecided) {
      TryReachable();
    }
  }

  /// What is left of the time is used while something is open.
  void UseRestOfTime() {
    constexpr uint64_t kStatesShare = 12, kRoundShare = 8;
    const auto share_ms = [&] {
      const uint64_t rest_ms = comparison_.RestMs() - std::min(comparison_.RestMs(), total_ms_ / kStatesShare);
      return std::min(rest_ms, std::max<uint64_t>(1, total_ms_ / kRoundShare));
    };
    while (IsAnySought(comparison_) && comparison_.RestMs() > total_ms_ / kStatesShare + total_ms_ / 100) {
      if (IsWorthTrying() && LacksInvariants()) TryInvariants(share_ms() / 2);
      if (MarkDifferent(comparison_, Effort::kLasting, share_ms()) != 0 && IsWorthTrying()) TryReachable();
    }
  }

  uint32_t invariants() const { return invariants_; }

 private:
  bool IsWorthTrying() const {
    const uint32_t undecided = comparison_.UndecidedCount();
    return undecided > 0 && undecided <= kMostLookedAt && !comparison_.Late();
  }

  /// A question takes as long as it takes: of a short time a larger share.
  uint64_t ShortMs(uint64_t share) const {
    return std::max(total_ms_ / share, std::min(total_ms_ / kLargestShare, kEnoughMs));
  }

  bool LacksInvariants() const {
    return !comparison_.old_finder || !comparison_.old_finder->is_done() || !comparison_.new_finder->is_done();
  }

  void CountInvariants() { invariants_ = constants_ + static_cast<uint32_t>(comparison_.InvariantCount()); }

  /// What was taken out for the sake of a pair that no run tells apart may be equal after all, in the states that can
  /// be reached: that is tried before long runs are.
  void TryReachable() {
    JoinAllButDifferent(comparison_);
    if (CheckPowerOn(comparison_) && FindInductiveSet(comparison_)) SetVerdicts(comparison_);
  }

  void TryInvariants(uint64_t most_ms) {
    JoinAllButDifferent(comparison_);
    const size_t before = comparison_.InvariantCount();
    const bool any = AddInvariants(comparison_, most_ms);
    CountInvariants();
    if (any && invariants_ != before) {
      TryReachable();
    } else {
      SeparateUndecided(comparison_);
    }
  }

  void TryRelations() {
    SeparateUndecided(comparison_);
    for (std::vector<Relation>& relations : GuessRelations(comparison_)) {
      comparison_.relations = std::move(relations);
      comparison_.Report("relations");
      TryReachable();
      CountInvariants();
      if (!IsWorthTrying()) return;
    }
  }

  Comparison& comparison_;
  uint64_t total_ms_;
  uint32_t constants_, invariants_;
};

}  // namespace

CompareResult CompareVersions(const machine::Version& old_version, const machine::Version& new_version,
                              const Match& match, const SimulatedRuns& runs, const CompareLimits& limits) {
  Comparison comparison(old_version, new_version, match, runs, limits);
  if (!comparison.refusal.empty()) return Finish(comparison, 0);
  AddMatched(comparison);
  comparison.changed_for_host = ChangedForHost(comparison);
  // What a scenario shows needs no proof, and scenarios are there however large the program is.
  if (runs.find_different)
    comparison.before_questions = [&] { runs.find_different(SoughtOf(comparison), Effort::kScenarios, 0); };
  // What is not executed to its end in time is not decided, but what runs have shown is known.
  const auto finish_early = [&] {
    for (const PairResult& result : comparison.results) comparison.pairing.Separate(result.old_cell);
    if (comparison.refusal.empty()) MarkDifferent(comparison, Effort::kScenarios);
    return Finish(comparison, 0);
  };
  const std::optional<FirstPass> first = TakeAllForEqual(comparison);
  if (!first) return finish_early();
  if (first->is_proved) {
    comparison.changes_are_found = true;  // there are none
    SetVerdicts(comparison);
    return Finish(comparison, first->constants);
  }
  if (!FindEqualPairs(comparison, first->at_power_on)) return finish_early();
  SetVerdicts(comparison);
  // The solver's runs are the shortest ones; longer ones are tried for what these leave.
  SearchRuns(comparison);
  Attempts attempts(comparison, first->constants);
  attempts.BeginWithProofs();
  attempts.SearchThoroughly();
  attempts.UseRestOfTime();
  SearchStates(comparison);
  return Finish(comparison, attempts.invariants());
}

}  // namespace plcxx::prove::diff
