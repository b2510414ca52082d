#include "transpiler/prove/properties/window_check.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>
#include <vector>

#include "transpiler/prove/properties/counting.h"
#include "transpiler/prove/properties/reach_check.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostHistory = 200;

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

}  // namespace

bool TryReachable(CheckedProgram& checked, ProgramInvariants& invariants, const Property& property,
                  PropertyResult& result) {
  const uint32_t window = WindowOf(property);
  size_t cells = 0;
  for (const PropertyOperand& operand : property.operands) cells += operand.cells.size();
  if (checked.Late()) return false;
  if (window * cells > kMostHistory) return TryCounting(checked, invariants, property, result);
  machine::Relation& relation = checked.Widest();
  const size_t parts = PartsOf(relation).size();
  const auto before = [&relation](execute::CellId cell) { return relation.VariableOf(cell); };
  const auto after = [&](execute::CellId cell) {
    const terms::TermId next = relation.period()[cell.index];
    return next.valid() ? next : before(cell);
  };
  History history(checked.terms, parts);
  const terms::TermId violated =
      checked.terms.Not(HoldsAfter(checked.terms, property, window, [&](execute::CellId cell, uint32_t period) {
        return period == window ? after(cell) : history.Before(cell, after(cell), window - period);
      }));
  const terms::TermId bad = checked.terms.And(violated, history.HaveBeen(window - 1));
  const auto is_never = [&](terms::TermId state, const MoreWords& more) {
    return IsNeverReached(checked, QuestionOf(checked, invariants, state, more), result);
  };
  bool never = is_never(bad, [&](terms::TermId variable) { return history.Find(variable); });
  if (!never && parts > 1 && window == 1 && !checked.Late()) {
    // Fast parts of the same period see the same inputs: looked at with it they say more, and take more time.
    machine::Unrolled whole(checked.terms, relation, checked.inputs, machine::Start::kAnywhere,
                            "whole " + std::to_string(checked.terms.variable_count()));
    whole.late = [&checked] { return checked.Late(); };
    whole.StartFrom(before, relation.now());
    if (Extend(checked, whole, 1, result)) return true;
    never = is_never(checked.terms.Not(HoldsAfter(checked.terms, property, 1, ValuesOf(whole))), {});
  }
  if (!never) return window > 1 && TryCounting(checked, invariants, property, result);
  result.verdict = PropertyVerdict::kProved;
  result.periods = 1;
  result.reason.clear();
  return true;
}

bool TryReachableFor(uint32_t milliseconds, CheckedProgram& checked, ProgramInvariants& invariants,
                     const Property& property, PropertyResult& result) {
  PropertyResult tried = result;
  const bool is_proved = Within(milliseconds, checked, [&] {
    return TryReachable(checked, invariants, property, tried) && tried.verdict == PropertyVerdict::kProved;
  });
  if (is_proved) result = std::move(tried);
  return is_proved;
}

}  // namespace plcxx::prove::properties
