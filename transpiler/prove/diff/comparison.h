// The inner part of CompareVersions: which pairs are still taken for equal, and why others are not.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/prove/diff/pairing.h"
#include "transpiler/prove/diff/relation.h"
#include "transpiler/prove/invariants/invariants.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/solver/refuted.h"
#include "transpiler/symbolic/solver/sweep.h"

namespace plcxx::prove::diff {

/// What a part was executed to, over the variables of a pairing.
struct Execution {
  std::optional<machine::Part> part;               // none: power-on
  std::vector<bool> equal;                         // by old cell, as the pairing had it
  std::array<machine::Transition, 2> transitions;  // old, new
};

/// Of the state before a part. At power-on relations have to come true: who assumes them there can prove anything of
/// relations that no state fulfils.
/// Invariants are about memory after power-on: what is kept without power may have been anything before the first one.
enum class Known : uint8_t { kNothing, kInvariants, kInvariantsAndRelations };

struct Comparison {
  static constexpr uint32_t kNoResult = 0xFFFFFFFF;

  Comparison(const machine::Version& old_version, const machine::Version& new_version, const Match& match,
             const SimulatedRuns& runs, const CompareLimits& limits);

  const machine::Version& old_version;
  const machine::Version& new_version;
  const Match& match;
  const SimulatedRuns& runs;
  const CompareLimits& limits;
  terms::Terms terms;
  std::unique_ptr<solver::Solver> solver;
  solver::Refuted refuted{terms};
  std::string refusal;
  bool changes_are_found = false;  // SeparatePropagated was done
  bool is_inductive = false;       // see FindInductiveSet
  Pairing pairing;
  machine::Uses old_uses, new_uses;
  std::vector<execute::CellId> requests;  // old cells that the control clears when it likes
  /// What a host function may see in the middle of a part: matched bits that either version writes, in the same order.
  std::vector<execute::CellId> old_observed, new_observed;
  /// How long one round of questions may take: at first little, since most of what is not proved soon differs.
  uint64_t round_ms;
  terms::TermId now;
  OneSided one_sided;                         // see CompareResult
  std::vector<std::string> changed_for_host;  // likewise
  std::vector<PairResult> results;            // of matched state, ascending by old cell
  std::vector<uint32_t> result_of_old;        // by old cell; kNoResult: it is none
  machine::Transition old_next, new_next;     // of the last period, over the pairing's variables
  uint64_t execution_ms = 0;                  // that the last execution of a part took
  std::vector<Execution> executions;          // the last ones with these constants, newest first
  std::unique_ptr<invariants::InvariantFinder> old_finder, new_finder;
  std::vector<Relation> relations;          // part of the inductive set, as the pairs that are equal are
  std::unique_ptr<solver::BitSolver> bits;  // for questions about all of them; made with the first one
  std::chrono::steady_clock::time_point deadline;
  std::function<void()> before_questions;  // called once, before the solver is asked anything

  uint64_t RestMs() const;
  bool Late() const { return RestMs() == 0; }
  uint32_t UndecidedCount() const;
  /// Whether an undecided pair is worth a search of its own; `count` is UndecidedCount().
  bool IsLookedAt(const PairResult& result, uint32_t count) const;

  void Report(const std::string& what) const {
    if (limits.progress) limits.progress(what);
  }
  /// Of a pair that is compared; null: the cell is in none.
  const PairResult* ResultOf(execute::CellId old_cell) const;
  /// See IsInputPair; and what the operator sends.
  bool IsInput(execute::CellId old_cell) const;
  /// The same of a cell of either version; of one that the new version alone has, whether others may set it there.
  bool IsInput(Which which, execute::CellId cell) const;
  /// With the same value in both versions when power comes, if nobody wrote it before.
  bool BeginsAlike(execute::CellId old_cell, execute::CellId new_cell) const {
    return machine::PowerOnValue(old_version, old_cell) == machine::PowerOnValue(new_version, new_cell);
  }
  /// By either version.
  bool IsWritten(const PairResult& result) const {
    return old_uses.writes[result.old_cell.index] || new_uses.writes[result.new_cell.index];
  }

  size_t InvariantCount() const {
    return relations.size() + (old_finder ? old_finder->invariants().size() + new_finder->invariants().size() : 0);
  }
  /// What is known, over the pairing's variables.
  std::vector<terms::TermId> KnownConditions(Known known);
  /// The solver assumes it until its Pop.
  void PushInvariants(Known known = Known::kInvariantsAndRelations);

  terms::TermId NextOld(execute::CellId cell);
  terms::TermId NextNew(execute::CellId cell);
};

/// Whether two terms are one, for the sake of a pair.
struct Question {
  solver::TermPair pair;
  uint32_t result;  // index of Comparison::results
};
/// Under what is known.
std::vector<solver::Verdict> Answers(Comparison& comparison, std::span<const Question> questions,
                                     Known known = Known::kInvariantsAndRelations);
/// Drops the relations of which it is not proved that they hold after power-on, or a part; gives their number. `next`:
/// what a cell becomes.
uint32_t DropFailingRelations(Comparison& comparison, Known known,
                              const std::function<terms::TermId(Which which, execute::CellId cell)>& next);
/// What host functions see in the middle of a part, of old_next and new_next. A function that is called otherwise is a
/// difference of its calls, and nothing else is said of what it sees: `calls_are_equal` is asked about its old cell.
void AddObservations(Comparison& comparison, const std::function<bool(execute::CellId calls)>& calls_are_equal,
                     std::vector<Question>& questions);

/// What a version gets instead of a value that it writes, and to which cells that happens; see Environment::cut.
struct Cut {
  std::function<terms::TermId(Which which, execute::CellId cell, terms::TermId value)> value;
  std::function<bool(Which which, execute::CellId cell)> is_cut;
};
/// With the pairs as they are: names of the routines that only the host calls and that do not do the same, term by
/// term, or that one version alone has.
std::vector<std::string> ChangedForHost(Comparison& comparison);
/// The parts that are executed by themselves: the period last.
std::vector<machine::Part> PartsOf(const Comparison& comparison);
/// Executes a part of both over the pairing; false: comparison.refusal says why not.
bool ExecutePart(Comparison& comparison, machine::Part part, machine::HostAnswers answers = machine::HostAnswers::kAny,
                 const Cut* cut = nullptr);
/// Power-on of both, old and new; none: comparison.refusal says why not.
std::optional<std::array<machine::Transition, 2>> ExecutePowerOn(Comparison& comparison);
/// Finds cells of either version that never change, and tells the pairing. To be called when every pair is equal. False
/// as above.
bool FindConstants(Comparison& comparison);
/// Takes pairs that differ after power-on out of what is equal. False as above.
bool CheckPowerOn(Comparison& comparison);
/// Takes out what starts with other values because retentive memory differs when power fails; adds the number. False as
/// above.
bool SeparateAfterPowerFailure(Comparison& comparison, uint32_t& separated);
/// Takes out what fails until nothing does, or for so many rounds: the set is inductive (Comparison::is_inductive) only
/// when nothing failed in the last one. False as above.
struct InductionLimits {
  uint32_t most_rounds = 0xFFFFFFFF;
  uint64_t end_ms = 0;  // as RestMs: then it is given up
};
bool FindInductiveSet(Comparison& comparison, const InductionLimits& induction_limits = {});
/// Of the pairs that are not equal in one period from the same state: which have a change in their own statements, and
/// which differ because of those. To be called when exactly these pairs are separated. False as above.
bool SeparatePropagated(Comparison& comparison);
/// The separated pairs, and those that may differ a period later, or later still, because of them: all others are equal
/// in every scan. To be called when the separated pairs are those that differ after one part with every pair equal.
/// None: comparison.refusal says why.
std::optional<std::vector<execute::CellId>> ReachOfDifferences(Comparison& comparison);
/// So many undecided pairs are looked at one by one; of more only those with a change of their own.
inline constexpr uint32_t kMostLookedAt = 400;

/// For the pairs that are undecided: runs from power-on that end with a difference.
void SearchRuns(Comparison& comparison);
/// For the pairs that are undecided still: a state, the same for both, from which one period makes a difference.
void SearchStates(Comparison& comparison);
/// Finds and proves invariants of both versions around the pairs that are undecided, in up to `most_ms` for each
/// version; questions assume them from then on. Where that was not enough it goes on when it is called again. False as
/// above.
bool AddInvariants(Comparison& comparison, uint64_t most_ms);

}  // namespace plcxx::prove::diff
