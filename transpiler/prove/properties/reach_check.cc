#include "transpiler/prove/properties/reach_check.h"

#include <algorithm>
#include <chrono>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr uint32_t kShare = 3;  // of the time that is left
constexpr size_t kMostBadTerms = 250'000;

}  // namespace

std::vector<const std::vector<terms::TermId>*> PartsOf(const machine::Relation& relation) {
  if (relation.fast().empty()) return {&relation.period()};
  return {&relation.fast(), &relation.period()};
}

bool IsNeverReached(const CheckedProgram& checked, const ReachQuestion& question, PropertyResult& result) {
  if (checked.Late() || terms::ConeAboveFunctions(checked.terms, {&question.bad, 1}).size() > kMostBadTerms)
    return false;
  checked.Report("reachable states");
  const std::optional<FoundFacts> facts = ShowUnreachable(question);
  if (facts) result.invariants = static_cast<uint32_t>(question.known.size() + facts->forbidden.size());
  return facts.has_value();
}

ReachQuestion QuestionOf(CheckedProgram& checked, const ProgramInvariants& invariants, terms::TermId bad,
                         const MoreWords& more) {
  machine::Relation& relation = checked.Widest();
  const std::vector<const std::vector<terms::TermId>*> parts = PartsOf(relation);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(checked.RestMs() / kShare);
  ReachQuestion question{.terms = checked.terms,
                         .state_of = {},
                         .parts = parts.size(),
                         .bad = bad,
                         .known = {},
                         .rest_ms =
                             [end] {
                               const auto rest = end - std::chrono::steady_clock::now();
                               const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(rest).count();
                               return static_cast<uint32_t>(std::max<int64_t>(0, ms));
                             },
                         .progress = checked.options.progress};
  question.state_of = [&checked, &relation, &more, parts](terms::TermId variable) -> std::optional<StateWord> {
    const execute::CellId cell = relation.CellOf(variable);
    if (!cell.valid()) return more ? more(variable) : std::nullopt;
    if (checked.new_each_time[cell.index] || !machine::IsState(checked.version, cell) ||
        cell.index >= checked.version.cells.calls)
      return {};
    StateWord word{.now = variable, .next = {}, .start = checked.Base().Value(cell, 0)};
    for (const std::vector<terms::TermId>* part : parts)
      word.next.push_back((*part)[cell.index].valid() ? (*part)[cell.index] : variable);
    if (checked.any && checked.requests[cell.index]) {
      // The control may take it back before the next part.
      const execute::Cell what = execute::CellAt(*checked.version.program, checked.version.cells, cell);
      const terms::TermId stays =
          checked.terms.Variable("stays " + execute::CellName(*checked.version.program, what), 1);
      for (terms::TermId& next : word.next) next = checked.terms.And(next, stays);
    }
    return word;
  };
  // They hold after periods, not between their parts.
  if (parts.size() == 1)
    question.known = invariants.ConditionsOf([&relation](execute::CellId cell) { return relation.VariableOf(cell); });
  return question;
}

}  // namespace plcxx::prove::properties
