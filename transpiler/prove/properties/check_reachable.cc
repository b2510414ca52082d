// Properties by facts about the reachable states: what a property says of several periods becomes state of its own.
#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/prove/properties/check.h"
#include "transpiler/prove/properties/reachable.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr uint32_t kShare = 3;  // of the time that is left
constexpr size_t kMostHistory = 200;
constexpr size_t kMostBadTerms = 250'000;

/// The values that the cells of a property had after the last periods, and how many periods there have been.
class History {
 public:
  History(terms::Terms& terms, size_t parts) : terms_(terms), parts_(parts) {}

  /// `after`: the value after this period; `back`: 1 for the period before it.
  terms::TermId Before(execute::CellId cell, terms::TermId after, uint32_t back) {
    return Row(rows_[cell], after, back, "before");
  }
  /// Whether there have been so many periods.
  terms::TermId HaveBeen(uint32_t periods) {
    return periods == 0 ? terms_.Bit(true) : Row(counted_, terms_.Bit(true), periods, "period before");
  }
  std::optional<StateWord> Find(terms::TermId variable) const {
    const auto found = words_.find(variable);
    return found == words_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  terms::TermId Row(std::vector<terms::TermId>& row, terms::TermId after, uint32_t back, const char* name) {
    const uint8_t width = terms_.Width(after);
    while (row.size() < back) {
      const terms::TermId variable = terms_.Variable(name + (" " + std::to_string(terms_.variable_count())), width);
      // The period is the last part; the others change no history.
      StateWord word{
          .now = variable, .next = std::vector<terms::TermId>(parts_, variable), .start = terms_.Const(0, width)};
      word.next.back() = row.empty() ? after : row.back();
      words_[variable] = std::move(word);
      row.push_back(variable);
    }
    return row[back - 1];
  }

  terms::Terms& terms_;
  size_t parts_;
  std::map<execute::CellId, std::vector<terms::TermId>> rows_;
  std::vector<terms::TermId> counted_;
  std::map<terms::TermId, StateWord> words_;
};

/// What runs in any order, the period itself last.
std::vector<const std::vector<terms::TermId>*> PartsOf(const machine::Relation& relation) {
  if (relation.fast().empty()) return {&relation.period()};
  return {&relation.fast(), &relation.period()};
}

}  // namespace

/// After any reachable state, a period that does not violate it: shorter runs than its window have been searched.
bool PropertyChecker::TryReachable(const Property& property, PropertyResult& result) {
  const uint32_t window = WindowOf(property);
  size_t cells = 0;
  for (const PropertyOperand& operand : property.operands) cells += operand.cells.size();
  if (Late()) return false;
  if (window * cells > kMostHistory) return TryCounting(property, result);
  machine::Relation& relation = Widest();
  const size_t parts = PartsOf(relation).size();
  const auto before = [&relation](execute::CellId cell) { return relation.VariableOf(cell); };
  const auto after = [&](execute::CellId cell) {
    const terms::TermId next = relation.period()[cell.index];
    return next.valid() ? next : before(cell);
  };
  History history(terms_, parts);
  const terms::TermId violated =
      terms_.Not(HoldsAfter(terms_, property, window, [&](execute::CellId cell, uint32_t period) {
        return period == window ? after(cell) : history.Before(cell, after(cell), window - period);
      }));
  const terms::TermId bad = terms_.And(violated, history.HaveBeen(window - 1));
  bool never = IsNeverReached(bad, [&](terms::TermId variable) { return history.Find(variable); }, result);
  if (!never && parts > 1 && window == 1 && !Late()) {
    // Fast parts of the same period see the same inputs: looked at with it they say more, and take more time.
    machine::Unrolled whole(terms_, relation, inputs_, machine::Start::kAnywhere,
                            "whole " + std::to_string(terms_.variable_count()));
    whole.late = [this] { return Late(); };
    whole.StartFrom(before, relation.now());
    if (Extend(whole, 1, result)) return true;
    never = IsNeverReached(terms_.Not(HoldsAfter(terms_, property, 1, ValuesOf(whole))), {}, result);
  }
  if (!never) return window > 1 && TryCounting(property, result);
  result.verdict = PropertyVerdict::kProved;
  result.periods = 1;
  result.reason.clear();
  return true;
}

bool PropertyChecker::TryReachableFor(uint32_t milliseconds, const Property& property, PropertyResult& result) {
  const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  const auto deadline = std::exchange(deadline_, std::min(deadline_, soon));
  PropertyResult tried = result;
  const bool is_proved = TryReachable(property, tried) && tried.verdict == PropertyVerdict::kProved;
  deadline_ = deadline;
  if (is_proved) result = std::move(tried);
  return is_proved;
}

bool PropertyChecker::IsNeverReached(terms::TermId bad,
                                     const std::function<std::optional<StateWord>(terms::TermId)>& more,
                                     PropertyResult& result) {
  return IsNeverReached(QuestionOf(bad, more), result);
}

bool PropertyChecker::IsNeverReached(const ReachQuestion& question, PropertyResult& result) {
  if (Late() || terms::ConeAboveFunctions(terms_, {&question.bad, 1}).size() > kMostBadTerms) return false;
  Report("reachable states");
  const std::optional<FoundFacts> facts = ShowUnreachable(question);
  if (facts) result.invariants = static_cast<uint32_t>(question.known.size() + facts->forbidden.size());
  return facts.has_value();
}

/// `more` outlives it.
ReachQuestion PropertyChecker::QuestionOf(terms::TermId bad,
                                          const std::function<std::optional<StateWord>(terms::TermId)>& more) {
  machine::Relation& relation = Widest();
  const std::vector<const std::vector<terms::TermId>*> parts = PartsOf(relation);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(RestMs() / kShare);
  ReachQuestion question{.terms = terms_,
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
                         .progress = options_.progress};
  question.state_of = [this, &relation, &more, parts](terms::TermId variable) -> std::optional<StateWord> {
    const execute::CellId cell = relation.CellOf(variable);
    if (!cell.valid()) return more ? more(variable) : std::nullopt;
    if (new_each_time_[cell.index] || !machine::IsState(version_, cell) || cell.index >= version_.cells.calls)
      return {};
    StateWord word{.now = variable, .next = {}, .start = Base().Value(cell, 0)};
    for (const std::vector<terms::TermId>* part : parts)
      word.next.push_back((*part)[cell.index].valid() ? (*part)[cell.index] : variable);
    if (any_ && requests_[cell.index]) {
      // The control may take it back before the next part.
      const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
      const terms::TermId stays = terms_.Variable("stays " + execute::CellName(*version_.program, what), 1);
      for (terms::TermId& next : word.next) next = terms_.And(next, stays);
    }
    return word;
  };
  // They hold after periods, not between their parts.
  if (parts.size() == 1) {
    const auto before = [&relation](execute::CellId cell) { return relation.VariableOf(cell); };
    for (const invariants::Invariant& invariant : invariants_)
      question.known.push_back(invariants::ConditionOf(terms_, invariant, before));
  }
  return question;
}

}  // namespace plcxx::prove::properties
