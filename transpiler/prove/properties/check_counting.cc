// Properties that speak about long times: what has been held, and what is waited for, is counted.
#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "transpiler/prove/properties/check.h"
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

std::vector<std::vector<execute::CellId>> PropertyChecker::NumbersAmong(
    const std::vector<execute::CellId>& cells) const {
  const ir::Program& program = *version_.program;
  std::map<execute::CellId, std::vector<execute::CellId>> word_of;  // by its first cell
  for (const ir::Place& place : program.places) {
    const bool is_number = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                           execute::IsInside(program, place) &&
                           program.spaces[place.space].lifetime != ir::Lifetime::kRoutine;
    if (!is_number) continue;
    std::vector<execute::CellId> word = execute::CellsOf(program, version_.cells, place);
    for (const execute::CellId cell : word) {
      std::vector<execute::CellId>& known = word_of[cell];
      if (known.size() < word.size()) known = word;
    }
  }
  std::vector<std::vector<execute::CellId>> numbers;
  std::vector<bool> taken(version_.cells.count);
  for (const execute::CellId cell : cells) {
    if (taken[cell.index] || new_each_time_[cell.index]) continue;
    std::vector<execute::CellId> word{cell};
    const execute::Cell what = execute::CellAt(program, version_.cells, cell);
    if (what.kind == execute::CellKind::kCalls) continue;
    if (what.kind == execute::CellKind::kBit) {
      const auto known = word_of.find(cell);
      if (known == word_of.end()) continue;
      word = known->second;
    } else if (execute::CellWidth(program, what) == 1) {
      continue;
    }
    for (const execute::CellId one : word) taken[one.index] = true;
    numbers.push_back(std::move(word));
  }
  return numbers;
}

bool PropertyChecker::TryCountingIn(uint32_t milliseconds, const Property& property, PropertyResult& result) {
  const auto end = deadline_;
  deadline_ = std::min(end, std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds));
  const bool proved = TryCounting(property, result);
  deadline_ = end;
  return proved;
}

bool PropertyChecker::TryCounting(const Property& property, PropertyResult& result) {
  if (Late()) return false;
  machine::Relation& relation = Widest();
  std::vector<execute::CellId> operands;
  for (const PropertyOperand& operand : property.operands)
    operands.insert(operands.end(), operand.cells.begin(), operand.cells.end());
  std::vector<execute::CellId> behind = NearestCellsBehind(terms_, relation, operands);
  if (behind.size() > kMostNearest) behind.resize(kMostNearest);
  if (invariants_.empty()) FindInvariantsAround(behind);
  Report("counting periods");
  Counters counters(terms_, relation.fast().empty() ? 1 : 2);  // the period, and the fast part
  const auto after = [&relation](execute::CellId cell) {
    const terms::TermId next = relation.period()[cell.index];
    return next.valid() ? next : relation.VariableOf(cell);
  };
  const terms::TermId bad = terms_.Not(HoldsByCounting(
      terms_, property, after, [&counters](uint32_t most, const std::function<terms::TermId(terms::TermId)>& next) {
        return counters.Add(most, next);
      }));
  const std::function<std::optional<StateWord>(terms::TermId)> more = [&](terms::TermId variable) {
    return counters.Find(variable);
  };
  ReachQuestion question = QuestionOf(bad, more);
  question.rest_ms = [this] { return RestMs(); };
  const bool has_clock = relation.fast().empty();
  if (has_clock) {
    // The time goes on by one period from part to part; elsewhere it may be any, which is soon found out.
    const terms::TermId now = relation.now();
    const terms::TermId period = terms_.Const(version_.program->schedule.period_ms, terms_.Width(now));
    const StateWord clock{.now = now, .next = {terms_.Add(now, period)}, .start = plain_->FirstTime()};
    question.state_of = [state_of = question.state_of, clock](terms::TermId variable) {
      return variable == clock.now ? std::optional(clock) : state_of(variable);
    };
  }
  TimeQuestion times{.reach = question,
                     .solver = *solver_,
                     .counters = counters.variables(),
                     .registers = {},
                     .now = has_clock ? relation.now() : terms::TermId(),
                     .bits = {},
                     .period_ms = version_.program->schedule.period_ms};
  std::set<terms::TermId> of_numbers;
  for (const std::vector<execute::CellId>& number : NumbersAmong(behind)) {
    std::vector<terms::TermId>& variables = times.registers.emplace_back();
    for (const execute::CellId cell : number) variables.push_back(relation.VariableOf(cell));
    of_numbers.insert(variables.begin(), variables.end());
  }
  for (const execute::CellId cell : behind) {
    const terms::TermId variable = relation.VariableOf(cell);
    const bool is_bit = terms_.Width(variable) == 1 && !new_each_time_[cell.index];
    const bool is_named = std::ranges::any_of(property.operands, [cell](const PropertyOperand& operand) {
      return operand.cells.size() == 1 && operand.cells.front() == cell;
    });
    if (is_bit && (is_named || !of_numbers.contains(variable))) times.bits.push_back(variable);
  }
  const std::vector<terms::TermId> facts = FindTimeFacts(times);
  question.known.insert(question.known.end(), facts.begin(), facts.end());
  if (!IsNeverReached(question, result)) return false;
  result.verdict = PropertyVerdict::kProved;
  result.periods = 1;
  result.reason.clear();
  return true;
}

}  // namespace plcxx::prove::properties
