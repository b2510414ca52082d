#include "transpiler/prove/properties/counting.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/numbers.h"
#include "transpiler/prove/properties/reach_check.h"
#include "transpiler/prove/properties/time_facts.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostNearest = 160;  // cells around which facts are looked for

/// The counts of a property as state words beside those of the program.
class Counters {
 public:
  Counters(terms::Terms& terms, size_t parts) : terms_(terms), parts_(parts) {}

  terms::TermId Add(uint32_t most, const std::function<terms::TermId(terms::TermId before)>& next) {
    uint8_t width = 1;
    while (most >> width != 0) ++width;
    const terms::TermId variable = terms_.Variable("count " + std::to_string(terms_.variable_count()), width);
    // The period is the last part; the others count nothing.
    StateWord word{
        .now = variable, .next = std::vector<terms::TermId>(parts_, variable), .start = terms_.Const(0, width)};
    word.next.back() = next(variable);
    const terms::TermId after = word.next.back();
    words_[variable] = std::move(word);
    variables_.push_back(variable);
    return after;
  }
  std::optional<StateWord> Find(terms::TermId variable) const {
    const auto found = words_.find(variable);
    return found == words_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::vector<terms::TermId>& variables() const { return variables_; }

 private:
  terms::Terms& terms_;
  size_t parts_;
  std::map<terms::TermId, StateWord> words_;
  std::vector<terms::TermId> variables_;
};

}  // namespace

bool TryCounting(CheckedProgram& checked, ProgramInvariants& invariants, const Property& property,
                 PropertyResult& result) {
  if (checked.Late()) return false;
  machine::Relation& relation = checked.Widest();
  std::vector<execute::CellId> behind = NearestCellsBehind(checked.terms, relation, OperandCellsOf(property));
  if (behind.size() > kMostNearest) behind.resize(kMostNearest);
  if (invariants.found().empty()) invariants.FindAround(behind);
  checked.Report("counting periods");
  Counters counters(checked.terms, relation.fast().empty() ? 1 : 2);  // the period, and the fast part
  const auto after = [&relation](execute::CellId cell) {
    const terms::TermId next = relation.period()[cell.index];
    return next.valid() ? next : relation.VariableOf(cell);
  };
  const terms::TermId bad = checked.terms.Not(
      HoldsByCounting(checked.terms, property, after,
                      [&counters](uint32_t most, const std::function<terms::TermId(terms::TermId)>& next) {
                        return counters.Add(most, next);
                      }));
  const MoreWords more = [&](terms::TermId variable) { return counters.Find(variable); };
  ReachQuestion question = QuestionOf(checked, invariants, bad, more);
  question.rest_ms = [&checked] { return checked.RestMs(); };
  const bool has_clock = relation.fast().empty();
  if (has_clock) {
    // The time goes on by one period from part to part; elsewhere it may be any, which is soon found out.
    const terms::TermId now = relation.now();
    const terms::TermId period =
        checked.terms.Const(checked.version.program->schedule.period_ms, checked.terms.Width(now));
    const StateWord clock{.now = now, .next = {checked.terms.Add(now, period)}, .start = checked.plain->FirstTime()};
    question.state_of = [state_of = question.state_of, clock](terms::TermId variable) {
      return variable == clock.now ? std::optional(clock) : state_of(variable);
    };
  }
  TimeQuestion times{.reach = question,
                     .solver = *checked.solver,
                     .counters = counters.variables(),
                     .registers = {},
                     .now = has_clock ? relation.now() : terms::TermId(),
                     .bits = {},
                     .period_ms = checked.version.program->schedule.period_ms};
  std::set<terms::TermId> of_numbers;
  for (const std::vector<execute::CellId>& number : NumbersAmong(checked, behind)) {
    std::vector<terms::TermId>& variables = times.registers.emplace_back();
    for (const execute::CellId cell : number) variables.push_back(relation.VariableOf(cell));
    of_numbers.insert(variables.begin(), variables.end());
  }
  for (const execute::CellId cell : behind) {
    const terms::TermId variable = relation.VariableOf(cell);
    const bool is_bit = checked.terms.Width(variable) == 1 && !checked.new_each_time[cell.index];
    const bool is_named = std::ranges::any_of(property.operands, [cell](const PropertyOperand& operand) {
      return operand.cells.size() == 1 && operand.cells.front() == cell;
    });
    if (is_bit && (is_named || !of_numbers.contains(variable))) times.bits.push_back(variable);
  }
  const std::vector<terms::TermId> facts = FindTimeFacts(times);
  question.known.insert(question.known.end(), facts.begin(), facts.end());
  if (!IsNeverReached(checked, question, result)) return false;
  result.verdict = PropertyVerdict::kProved;
  result.periods = 1;
  result.reason.clear();
  return true;
}

}  // namespace plcxx::prove::properties
