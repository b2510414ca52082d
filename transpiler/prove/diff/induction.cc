// From any state in which the set is equal, one more period leaves it equal.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::diff {
namespace {

solver::SweepLimits LimitsOf(const Comparison& comparison) {
  return {.pair_ms = comparison.limits.question_ms,
          .total_ms = std::min(comparison.RestMs(), comparison.round_ms),
          .any_values_count = comparison.InvariantCount() == 0,
          .progress = {}};
}

/// Separates the pairs of which a question is not answered by "equal"; gives their number.
uint32_t SeparateFailing(Comparison& comparison, const std::vector<Question>& questions,
                         Known known = Known::kInvariantsAndRelations) {
  const std::vector<solver::Verdict> verdicts = Answers(comparison, questions, known);
  uint32_t separated = 0;
  for (size_t i = 0; i < questions.size(); ++i) {
    const PairResult& result = comparison.results[questions[i].result];
    if (verdicts[i] == solver::Verdict::kEqual || !comparison.pairing.IsEqual(result.old_cell)) continue;
    comparison.pairing.Separate(result.old_cell);
    ++separated;
  }
  return separated;
}

machine::PartEnvironment EnvironmentOf(Comparison& comparison, Which which) {
  return {.initial = [&comparison, which](execute::CellId cell) { return comparison.pairing.Initial(which, cell); },
          .now = comparison.now,
          .observed = which == Which::kOld ? comparison.old_observed : comparison.new_observed,
          .host_bit =
              [&comparison, which](execute::CellId cell) {
                // An input that the new version has at another place is the old one's.
                const execute::CellId old_cell = which == Which::kOld ? cell : comparison.match.old_of_new[cell.index];
                const machine::Version& version = old_cell.valid() ? comparison.old_version : comparison.new_version;
                const execute::Cell at =
                    execute::CellAt(*version.program, version.cells, old_cell.valid() ? old_cell : cell);
                return execute::Environment::HostBit{
                    (old_cell.valid() ? "" : "new ") + version.program->spaces[at.space].name, at.offset, at.bit};
              },
          // What a version writes into the inputs stays there where the host does not write it again.
          .may_be_left =
              [&comparison, which](execute::CellId cell) {
                const bool is_old = which == Which::kOld;
                const execute::CellId other =
                    is_old ? comparison.match.new_of_old[cell.index] : comparison.match.old_of_new[cell.index];
                const machine::Uses& uses = is_old ? comparison.old_uses : comparison.new_uses;
                const machine::Uses& other_uses = is_old ? comparison.new_uses : comparison.old_uses;
                if (uses.writes[cell.index] || (other.valid() && other_uses.writes[other.index])) return true;
                // So does what it has at power-on: a table that the loader exchanges when it likes.
                const execute::CellId old_cell = is_old ? cell : other, new_cell = is_old ? other : cell;
                return other.valid() && !comparison.BeginsAlike(old_cell, new_cell);
              },
          .never_holds =
              [&comparison, which](ir::InstId loop, terms::TermId condition) {
                const uint64_t series = uint64_t{which == Which::kNew} << 32 | loop.index;
                return comparison.refuted.Has(condition, series, comparison.RestMs());
              },
          .is_late = [&comparison] { return comparison.Late(); }};
}

bool TakeRefusal(Comparison& comparison, const machine::Transition& transition, const char* which) {
  if (transition.refusal.empty()) return false;
  // What was not executed to its end is not decided; that is no reason to compare nothing.
  if (comparison.Late()) return true;
  comparison.refusal = std::string(which) + " version: " + transition.refusal;
  return true;
}

/// The terms from which the next values of the undecided pairs are computed in the part that was executed.
std::vector<terms::TermId> NextOfUndecided(Comparison& comparison) {
  std::vector<terms::TermId> next;
  for (const PairResult& result : comparison.results) {
    if (result.verdict != PairVerdict::kUndecided) continue;
    next.push_back(comparison.NextOld(result.old_cell));
    next.push_back(comparison.NextNew(result.new_cell));
  }
  return next;
}

/// The cells of one version that are in the cone of what the undecided pairs become, by either version: what one of
/// them reads may stand in another place of the other one.
std::vector<execute::CellId> SupportOfUndecided(Comparison& comparison, Which which,
                                                const std::vector<terms::TermId>& cone) {
  std::set<execute::CellId> cells;
  for (const Which side : {Which::kOld, Which::kNew}) {
    const machine::Version& version = side == Which::kOld ? comparison.old_version : comparison.new_version;
    const machine::Uses& uses = side == Which::kOld ? comparison.old_uses : comparison.new_uses;
    const std::vector<execute::CellId>& partners =
        side == Which::kOld ? comparison.match.new_of_old : comparison.match.old_of_new;
    for (uint32_t i = 0; i < version.cells.calls; ++i) {
      if (!uses.reads[i] || !machine::IsState(version, execute::CellId(i))) continue;
      // A bit of a byte that is read as a whole counts with it.
      const terms::TermId initial = comparison.pairing.Initial(side, execute::CellId(i));
      const terms::Term& term = comparison.terms[initial];
      const terms::TermId whole = term.kind == terms::TermKind::kExtract ? terms::TermId(term.a) : initial;
      if (!std::ranges::binary_search(cone, initial) && !std::ranges::binary_search(cone, whole)) continue;
      const execute::CellId cell = side == which ? execute::CellId(i) : partners[i];
      if (cell.valid()) cells.insert(cell);
    }
  }
  return {cells.begin(), cells.end()};
}

}  // namespace

std::vector<terms::TermId> Comparison::KnownConditions(Known known) {
  std::vector<terms::TermId> conditions;
  if (known == Known::kNothing) return conditions;
  for (const Which which : {Which::kOld, Which::kNew}) {
    const std::unique_ptr<invariants::InvariantFinder>& finder = which == Which::kOld ? old_finder : new_finder;
    if (!finder) continue;
    for (const invariants::Invariant& invariant : finder->invariants()) {
      const auto value = [&](execute::CellId cell) { return pairing.Initial(which, cell); };
      conditions.push_back(invariants::ConditionOf(terms, invariant, value));
    }
  }
  if (known == Known::kInvariants) return conditions;
  for (const Relation& relation : relations) {
    conditions.push_back(
        ConditionOf(terms, relation, [&](Which which, execute::CellId cell) { return pairing.Initial(which, cell); }));
  }
  return conditions;
}

void Comparison::PushInvariants(Known known) {
  solver->Push();
  for (const terms::TermId condition : KnownConditions(known)) solver->Assume(condition);
}

std::vector<solver::Verdict> Answers(Comparison& comparison, std::span<const Question> questions, Known known) {
  if (!questions.empty() && comparison.before_questions) std::exchange(comparison.before_questions, nullptr)();
  std::vector<solver::TermPair> pairs;
  for (const Question& question : questions) pairs.push_back(question.pair);
  comparison.PushInvariants(known);
  std::vector<solver::Verdict> verdicts =
      solver::Compare(comparison.terms, *comparison.solver, pairs, LimitsOf(comparison));
  comparison.solver->Pop();
  return verdicts;
}

void AddObservations(Comparison& comparison, const std::function<bool(execute::CellId calls)>& calls_are_equal,
                     std::vector<Question>& questions) {
  for (const machine::Seen& one : comparison.old_next.seen) {
    const execute::CellId calls = comparison.old_version.cells.OfCalls(one.function);
    const execute::CellId new_calls = comparison.match.new_of_old[calls.index];
    if (!new_calls.valid() || !calls_are_equal(calls)) continue;
    const auto other = std::ranges::find(comparison.new_next.seen, new_calls, [&comparison](const machine::Seen& seen) {
      return comparison.new_version.cells.OfCalls(seen.function);
    });
    // A function that is given more in one version.
    const bool is_given = other != comparison.new_next.seen.end();
    for (uint32_t i = 0; i < one.cells.size(); ++i) {
      const uint32_t result = comparison.result_of_old[comparison.old_observed[i].index];
      if (!comparison.pairing.IsEqual(comparison.results[result].old_cell)) continue;
      const terms::TermId a = one.cells[i], b = is_given ? other->cells[i] : terms::TermId();
      if (a.valid() && b.valid() && a != b) questions.push_back({{a, b}, result});
    }
  }
}

namespace {

/// Begins the search for invariants; false: comparison.refusal says why not.
bool MakeFinders(Comparison& comparison) {
  std::vector<terms::TermId> next;
  for (const machine::Part part : PartsOf(comparison)) {
    if (!ExecutePart(comparison, part)) return false;
    const std::vector<terms::TermId> more = NextOfUndecided(comparison);
    next.insert(next.end(), more.begin(), more.end());
  }
  const std::vector<terms::TermId> cone = terms::ConeOf(comparison.terms, next);
  for (const Which which : {Which::kOld, Which::kNew}) {
    const bool is_old = which == Which::kOld;
    invariants::InvariantSearch search{
        .version = is_old ? comparison.old_version : comparison.new_version,
        .cells = SupportOfUndecided(comparison, which, cone),
        .is_input = [&comparison, which](execute::CellId cell) { return comparison.IsInput(which, cell); },
        .seen_states = {}};
    if (comparison.runs.for_each_seen_state)
      search.seen_states = [&comparison, which](const auto& visit) {
        comparison.runs.for_each_seen_state(which, visit);
      };
    (is_old ? comparison.old_finder : comparison.new_finder) =
        std::make_unique<invariants::InvariantFinder>(comparison.terms, *comparison.solver, std::move(search));
  }
  return true;
}

}  // namespace

bool AddInvariants(Comparison& comparison, uint64_t most_ms) {
  if (!comparison.old_finder && !MakeFinders(comparison)) return false;
  comparison.Report("invariants");
  for (invariants::InvariantFinder* const finder : {comparison.old_finder.get(), comparison.new_finder.get()})
    finder->Find(std::min(comparison.RestMs(), most_ms));
  return true;
}

std::vector<machine::Part> PartsOf(const Comparison& comparison) {
  const bool fast = machine::HasFastPart(comparison.old_version) || machine::HasFastPart(comparison.new_version);
  return fast ? std::vector{machine::Part::kFast, machine::Part::kPeriod} : std::vector{machine::Part::kPeriod};
}

namespace {

/// Questions are asked of one set of pairs again and again: with constants, with invariants, to find what they reach.
constexpr size_t kMostExecutions = 8;

/// What the variables of an execution depend on, beside constants.
std::vector<bool> EqualCells(const Comparison& comparison) {
  std::vector<bool> equal(comparison.old_version.cells.count);
  for (uint32_t i = 0; i < equal.size(); ++i) equal[i] = comparison.pairing.IsEqual(execute::CellId(i));
  return equal;
}

/// The last execution of this part over these variables; null: there was none.
const Execution* KnownExecution(Comparison& comparison, std::optional<machine::Part> part,
                                const std::vector<bool>& equal) {
  std::vector<Execution>& all = comparison.executions;
  const auto known = std::ranges::find_if(
      all, [&](const Execution& execution) { return execution.part == part && execution.equal == equal; });
  if (known == all.end()) return nullptr;
  std::rotate(all.begin(), known, known + 1);
  return &all.front();
}

void Remember(Comparison& comparison, Execution execution) {
  std::vector<Execution>& all = comparison.executions;
  if (all.size() == kMostExecutions) all.pop_back();
  all.insert(all.begin(), std::move(execution));
}

}  // namespace

bool ExecutePart(Comparison& comparison, machine::Part part, machine::HostAnswers answers, const Cut* cut) {
  const bool is_plain = cut == nullptr && answers == machine::HostAnswers::kAny;
  std::vector<bool> equal;
  if (is_plain) {
    equal = EqualCells(comparison);
    if (const Execution* const known = KnownExecution(comparison, part, equal)) {
      comparison.old_next = known->transitions[0];
      comparison.new_next = known->transitions[1];
      return true;
    }
  }
  const auto run = [&](Which which) {
    machine::PartEnvironment environment = EnvironmentOf(comparison, which);
    environment.answers = answers;
    if (cut != nullptr) {
      environment.cut = [cut, which](execute::CellId cell, terms::TermId value) {
        return cut->value(which, cell, value);
      };
      environment.is_cut = [cut, which](execute::CellId cell) { return cut->is_cut(which, cell); };
    }
    return machine::RunPart(comparison.terms, comparison.pairing.version(which), part, environment);
  };
  const uint64_t before_ms = comparison.RestMs();
  comparison.old_next = run(Which::kOld);
  if (TakeRefusal(comparison, comparison.old_next, "old")) return false;
  comparison.new_next = run(Which::kNew);
  comparison.execution_ms = before_ms - comparison.RestMs();
  if (TakeRefusal(comparison, comparison.new_next, "new")) return false;
  if (is_plain) {
    Remember(comparison,
             {.part = part, .equal = std::move(equal), .transitions = {comparison.old_next, comparison.new_next}});
  }
  return true;
}

std::vector<std::string> ChangedForHost(Comparison& comparison) {
  std::array<std::map<std::string, ir::RoutineId>, 2> called;
  std::set<std::string> names;
  for (const Which which : {Which::kOld, Which::kNew}) {
    const ir::Program& program = *comparison.pairing.version(which).program;
    for (uint32_t i = 0; i < program.routines.size(); ++i) {
      const ir::Routine& routine = program.routines[ir::RoutineId(i)];
      if (routine.kind != ir::RoutineKind::kInterrupt) continue;
      called[which == Which::kOld ? 0 : 1].emplace(routine.name, ir::RoutineId(i));
      names.insert(routine.name);
    }
  }
  const auto does_the_same = [&](const std::string& name) {
    if (!called[0].contains(name) || !called[1].contains(name)) return false;
    const auto run = [&](Which which) {
      return machine::RunCalledByHost(comparison.terms, comparison.pairing.version(which),
                                      called[which == Which::kOld ? 0 : 1].at(name), EnvironmentOf(comparison, which));
    };
    const machine::Transition one = run(Which::kOld), other = run(Which::kNew);
    if (!one.refusal.empty() || !other.refusal.empty()) return false;
    return std::ranges::all_of(comparison.results, [&](const PairResult& result) {
      const terms::TermId a = one.next[result.old_cell.index], b = other.next[result.new_cell.index];
      return (a.valid() ? a : comparison.pairing.Initial(Which::kOld, result.old_cell)) ==
             (b.valid() ? b : comparison.pairing.Initial(Which::kNew, result.new_cell));
    });
  };
  std::vector<std::string> changed;
  std::ranges::copy_if(names, std::back_inserter(changed),
                       [&](const std::string& name) { return !does_the_same(name); });
  return changed;
}

std::optional<std::array<machine::Transition, 2>> ExecutePowerOn(Comparison& comparison) {
  std::vector<bool> equal = EqualCells(comparison);
  if (const Execution* const known = KnownExecution(comparison, std::nullopt, equal)) return known->transitions;
  std::array init{machine::RunInit(comparison.terms, comparison.old_version, EnvironmentOf(comparison, Which::kOld)),
                  machine::RunInit(comparison.terms, comparison.new_version, EnvironmentOf(comparison, Which::kNew))};
  if (TakeRefusal(comparison, init[0], "old") || TakeRefusal(comparison, init[1], "new")) return std::nullopt;
  Remember(comparison, {.part = std::nullopt, .equal = std::move(equal), .transitions = init});
  return init;
}

namespace {

/// What anybody may set, and no version writes, is set alike before the first part, whatever the host wrote at a call
/// that one version alone makes. Not what was stored, or declared otherwise: that stays if nobody sets it.
bool IsSetAlike(const Comparison& comparison, const PairResult& result) {
  return comparison.IsInput(result.old_cell) && !comparison.IsWritten(result) &&
         comparison.BeginsAlike(result.old_cell, result.new_cell) &&
         !machine::IsRetentive(comparison.old_version, result.old_cell) &&
         !machine::IsRetentive(comparison.new_version, result.new_cell);
}

/// Separates the pairs that differ when power comes; gives the questions about them. None: comparison.refusal says why.
/// `known`: of the state when power failed.
std::optional<std::vector<Question>> SeparateAtPowerOn(Comparison& comparison, Known known) {
  comparison.Report("power-on");
  const std::optional<std::array<machine::Transition, 2>> init = ExecutePowerOn(comparison);
  if (!init) return std::nullopt;
  const auto& [old_init, new_init] = *init;
  std::vector<Question> questions;
  for (uint32_t i = 0; i < comparison.results.size(); ++i) {
    const PairResult& result = comparison.results[i];
    if (IsSetAlike(comparison, result)) continue;
    const solver::TermPair pair{old_init.next[result.old_cell.index], new_init.next[result.new_cell.index]};
    if (comparison.pairing.IsEqual(result.old_cell) && pair.a != pair.b) questions.push_back({pair, i});
  }
  SeparateFailing(comparison, questions, known);
  std::erase_if(questions, [&comparison](const Question& question) {
    return comparison.pairing.IsEqual(comparison.results[question.result].old_cell);
  });
  return questions;
}

}  // namespace

bool CheckPowerOn(Comparison& comparison) {
  const std::optional<std::vector<Question>> differing = SeparateAtPowerOn(comparison, Known::kNothing);
  if (!differing) return false;
  // What differs from power-on on is induced by nothing.
  for (const Question& question : *differing) comparison.results[question.result].changed_itself = true;
  return true;
}

namespace {

/// Whether the host gets the retentive memory at the same moments: at calls that are given it, and when power fails,
/// where the program may say whether it is kept then.
bool IsStoredAlike(const Comparison& comparison) {
  const ir::Program &old_program = *comparison.old_version.program, &new_program = *comparison.new_version.program;
  for (uint32_t i = 0; i < old_program.host_functions.size(); ++i) {
    const ir::HostFunctionId host(i);
    const execute::CellId calls = comparison.old_version.cells.OfCalls(host);
    const bool is_given = old_program.host_functions[host].access == ir::HostAccess::kReadsRetentive;
    if (is_given && comparison.match.new_of_old[calls.index].valid() && !comparison.pairing.IsEqual(calls))
      return false;
  }
  const ir::PlaceId old_bit = old_program.schedule.retain_at_power_off,
                    new_bit = new_program.schedule.retain_at_power_off;
  if (old_bit.valid() != new_bit.valid()) return false;
  if (!old_bit.valid()) return true;
  const execute::CellId old_cell =
      execute::CellsOf(old_program, comparison.old_version.cells, old_program.places[old_bit]).front();
  const execute::CellId new_cell =
      execute::CellsOf(new_program, comparison.new_version.cells, new_program.places[new_bit]).front();
  return comparison.match.new_of_old[old_cell.index] == new_cell && comparison.pairing.IsEqual(old_cell);
}

/// What the program tells the host to store is in the copy of that moment. Where the versions do not say so at the same
/// time, the copies differ in all that either version writes.
uint32_t SeparateStoredOtherwise(Comparison& comparison) {
  if (IsStoredAlike(comparison)) return 0;
  uint32_t separated = 0;
  for (const PairResult& result : comparison.results) {
    const bool is_retentive = machine::IsRetentive(comparison.old_version, result.old_cell) ||
                              machine::IsRetentive(comparison.new_version, result.new_cell);
    const bool changes = comparison.IsWritten(result) || comparison.IsInput(result.old_cell);
    if (!is_retentive || !changes || !comparison.pairing.IsEqual(result.old_cell)) continue;
    comparison.pairing.Separate(result.old_cell);
    ++separated;
  }
  return separated;
}

}  // namespace

bool SeparateAfterPowerFailure(Comparison& comparison, uint32_t& separated) {
  if (!machine::HasRetentiveMemory(comparison.old_version) && !machine::HasRetentiveMemory(comparison.new_version))
    return true;
  separated += SeparateStoredOtherwise(comparison);
  const std::optional<std::vector<Question>> differing = SeparateAtPowerOn(comparison, Known::kInvariants);
  if (!differing) return false;
  separated += static_cast<uint32_t>(differing->size());
  return true;
}

namespace {

/// Relations are about memory that power-off clears, so power-on makes them hold, whatever was before.
bool DropRelationsAtPowerOn(Comparison& comparison, uint32_t& dropped) {
  if (comparison.relations.empty()) return true;
  const std::optional<std::array<machine::Transition, 2>> init = ExecutePowerOn(comparison);
  if (!init) return false;
  dropped += DropFailingRelations(comparison, Known::kNothing, [&](Which which, execute::CellId cell) {
    return (*init)[which == Which::kOld ? 0 : 1].next[cell.index];
  });
  return true;
}

/// The control may take requests back between two parts, in both versions alike.
uint32_t DropRelationsWhenTakenBack(Comparison& comparison, const std::array<std::vector<bool>, 2>& requests) {
  if (comparison.relations.empty()) return 0;
  return DropFailingRelations(comparison, Known::kInvariantsAndRelations, [&](Which which, execute::CellId cell) {
    const terms::TermId before = comparison.pairing.Initial(which, cell);
    if (!requests[which == Which::kOld ? 0 : 1][cell.index]) return before;
    const execute::CellId old_cell = which == Which::kOld ? cell : comparison.match.old_of_new[cell.index];
    const std::string name =
        (old_cell.valid() ? "stays " + std::to_string(old_cell.index) : "new stays " + std::to_string(cell.index));
    return comparison.terms.And(before, comparison.terms.Variable(name, 1));
  });
}

}  // namespace

bool FindInductiveSet(Comparison& comparison, const InductionLimits& induction_limits) {
  const uint32_t most_rounds = induction_limits.most_rounds;
  const std::array requests{machine::RequestCells(comparison.old_version),
                            machine::RequestCells(comparison.new_version)};
  comparison.is_inductive = false;
  for (uint32_t round = 1; round <= most_rounds; ++round) {
    uint32_t separated = 0;
    if (most_rounds == 1) {
      // With everything equal power-on is checked already, but not what is kept until then.
      separated += SeparateStoredOtherwise(comparison);
    } else if (!SeparateAfterPowerFailure(comparison, separated)) {
      return false;
    }
    if (!DropRelationsAtPowerOn(comparison, separated)) return false;
    for (const machine::Part part : PartsOf(comparison)) {
      comparison.Report("round " + std::to_string(round));
      if (!ExecutePart(comparison, part)) return false;
      // Before pairs are separated: then what was executed is no longer over the pairing's variables.
      separated +=
          DropFailingRelations(comparison, Known::kInvariantsAndRelations, [&](Which which, execute::CellId cell) {
            return which == Which::kOld ? comparison.NextOld(cell) : comparison.NextNew(cell);
          });
      std::vector<Question> questions;
      for (uint32_t i = 0; i < comparison.results.size(); ++i) {
        PairResult& result = comparison.results[i];
        if (!comparison.pairing.IsEqual(result.old_cell) || comparison.pairing.IsConstantPair(result.old_cell))
          continue;
        const solver::TermPair pair{comparison.NextOld(result.old_cell), comparison.NextNew(result.new_cell)};
        if (pair.a != pair.b) questions.push_back({pair, i});
      }
      separated += SeparateFailing(comparison, questions);
      questions.clear();
      AddObservations(comparison, [&](execute::CellId calls) { return comparison.pairing.IsEqual(calls); }, questions);
      separated += SeparateFailing(comparison, questions);
    }
    separated += DropRelationsWhenTakenBack(comparison, requests);
    comparison.is_inductive = separated == 0;
    if (comparison.is_inductive) return true;
    if (comparison.RestMs() <= induction_limits.end_ms) {
      // The set is not inductive: nothing is proved.
      for (const PairResult& result : comparison.results) comparison.pairing.Separate(result.old_cell);
      comparison.relations.clear();
      return true;
    }
  }
  return true;
}

}  // namespace plcxx::prove::diff
