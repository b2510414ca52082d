#include "transpiler/prove/properties/stuck.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/reach_check.h"
#include "transpiler/prove/properties/run_of.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostStrategies = 64;
constexpr uint32_t kMostStuckDepth = 12;  // of runs from power-on that are searched for a stuck state

terms::TermId Wanted(terms::Terms& terms, const Property& property, bool wanted, uint32_t period,
                     machine::Unrolled& unrolled) {
  const auto value = [&unrolled](execute::CellId cell, uint32_t at) { return unrolled.Value(cell, at); };
  const terms::TermId output = ValueOf(terms, property.operands.front(), period, value);
  return wanted ? output : terms.Not(output);
}

/// Values of inputs, by period, part and cell; what is not in them is 0.
using Strategy = std::vector<std::vector<std::map<execute::CellId, uint64_t>>>;
/// By cell; what is not in it is 0.
using State = std::map<execute::CellId, uint64_t>;

enum class Reach : uint8_t { kAlways, kStuck, kUnknown };

/// Inputs that make the output `wanted`, whatever the state.
class StuckSearch {
 public:
  StuckSearch(CheckedProgram& checked, const ProgramInvariants& invariants, const Property& property, bool wanted)
      : checked_(checked), invariants_(invariants), property_(property), wanted_(wanted) {}

  Reach FromAnywhere(PropertyResult& result);
  /// The same from the states that runs of so many periods reach; kStuck comes with the run.
  Reach After(uint32_t period, PropertyResult& result);
  /// Whether no state can be reached from which none of the sequences of inputs works.
  bool IsNeverStuck(PropertyResult& result);
  /// Behind kStuck: a state from which no inputs reach it.
  const State& stuck() const { return stuck_; }

 private:
  /// Adds a strategy that works from this state; kStuck: there is none.
  Reach FindStrategy(const State& state, uint64_t time, PropertyResult& result);
  /// Whether the strategy makes the output what is wanted, from the state of `from` after `period`; none: the time is
  /// over.
  std::optional<terms::TermId> Reached(const Strategy& strategy, machine::Unrolled& from, uint32_t period,
                                       PropertyResult& result);

  CheckedProgram& checked_;
  const ProgramInvariants& invariants_;
  const Property& property_;
  bool wanted_;
  std::vector<Strategy> strategies_;
  State stuck_;
};

std::optional<terms::TermId> StuckSearch::Reached(const Strategy& strategy, machine::Unrolled& from, uint32_t period,
                                                  PropertyResult& result) {
  machine::Unrolled trial(checked_.terms, *checked_.silent, checked_.inputs, machine::Start::kAnywhere, "trial");
  trial.late = [this] { return checked_.Late(); };
  trial.StartFrom([&from, period](execute::CellId cell) { return from.Value(cell, period); }, from.TimeAfter(period));
  trial.choose_input = [this, &strategy](execute::CellId cell, uint32_t at, uint32_t part) {
    const uint8_t width = execute::CellWidth(*checked_.version.program,
                                             execute::CellAt(*checked_.version.program, checked_.version.cells, cell));
    const State& values = strategy[at - 1][part];
    const auto value = values.find(cell);
    return checked_.terms.Const(value == values.end() ? 0 : value->second, width);
  };
  terms::TermId reached = checked_.terms.Bit(false);
  for (uint32_t at = 1; at <= property_.periods; ++at) {
    if (Extend(checked_, trial, at, result)) return std::nullopt;
    reached = checked_.terms.Or(reached, Wanted(checked_.terms, property_, wanted_, at, trial));
  }
  return reached;
}

Reach StuckSearch::FindStrategy(const State& state, uint64_t time, PropertyResult& result) {
  machine::Unrolled trial(checked_.terms, *checked_.silent, checked_.inputs, machine::Start::kAnywhere,
                          "try " + std::to_string(checked_.terms.variable_count()));
  trial.late = [this] { return checked_.Late(); };
  trial.StartFrom(
      [this, &state](execute::CellId cell) {
        const auto value = state.find(cell);
        const uint8_t width = execute::CellWidth(
            *checked_.version.program, execute::CellAt(*checked_.version.program, checked_.version.cells, cell));
        return checked_.terms.Const(value == state.end() ? 0 : value->second, width);
      },
      checked_.terms.Const(time, 32));
  terms::TermId reached = checked_.terms.Bit(false);
  for (uint32_t period = 1; period <= property_.periods; ++period) {
    if (Extend(checked_, trial, period, result)) return Reach::kUnknown;
    reached = checked_.terms.Or(reached, Wanted(checked_.terms, property_, wanted_, period, trial));
  }
  switch (Ask(checked_, {&reached, 1}, checked_.RestMs())) {
    case solver::Answer::kNever:
      stuck_ = state;
      return Reach::kStuck;
    case solver::Answer::kUnknown:
      result.reason = WhyUnknown(checked_);
      return Reach::kUnknown;
    case solver::Answer::kPossible:
      break;
  }
  Strategy strategy;
  for (uint32_t period = 1; period <= property_.periods; ++period) {
    strategy.emplace_back();
    for (const machine::Unrolled::Part& part : trial.parts(period)) {
      strategy.back().emplace_back();
      for (const auto& [cell, variable] : part) strategy.back().back()[cell] = checked_.solver->ValueOf(variable);
    }
  }
  if (strategies_.size() >= kMostStrategies) {
    result.reason = "no " + std::to_string(kMostStrategies) + " sequences of inputs are enough for all states";
    return Reach::kUnknown;
  }
  strategies_.push_back(std::move(strategy));
  return Reach::kAlways;
}

Reach StuckSearch::FromAnywhere(PropertyResult& result) {
  // Of a state only what the output depends on counts: facts are looked for around it. Properties that were checked
  // before have asked for other cells.
  std::vector<bool> matters(checked_.version.cells.count);
  for (const execute::CellId cell : CellsBehind(checked_.terms, *checked_.silent, property_.operands.front().cells))
    matters[cell.index] = true;
  std::vector<terms::TermId> conditions =
      invariants_.ConditionsOf([this](execute::CellId cell) { return checked_.anywhere->Value(cell, 0); });
  for (size_t tried = 0;;) {
    for (; tried < strategies_.size(); ++tried) {
      const std::optional<terms::TermId> reached = Reached(strategies_[tried], *checked_.anywhere, 0, result);
      if (!reached) return Reach::kUnknown;
      conditions.push_back(checked_.terms.Not(*reached));
    }
    checked_.Report("inputs that make it " + std::to_string(wanted_ ? 1 : 0) + ": " + std::to_string(tried));
    const solver::Answer answer = Ask(checked_, conditions, checked_.RestMs());
    if (answer == solver::Answer::kNever) return Reach::kAlways;
    if (answer == solver::Answer::kUnknown) {
      result.reason = WhyUnknown(checked_);
      return Reach::kUnknown;
    }
    State state;
    for (const auto& [cell, variable] : checked_.anywhere->start_variables()) {
      if (matters[cell.index]) state[cell] = checked_.solver->ValueOf(variable);
    }
    const uint64_t time = checked_.solver->ValueOf(checked_.anywhere->TimeAfter(0));
    const Reach found = FindStrategy(state, time, result);
    if (found != Reach::kAlways) return found;
  }
}

Reach StuckSearch::After(uint32_t period, PropertyResult& result) {
  if (Extend(checked_, *checked_.plain, period, result)) return Reach::kUnknown;
  const machine::Uses uses = machine::UsesOf(checked_.version);
  const std::vector<execute::CellId>& outputs = property_.operands.front().cells;
  // The whole state: what else is read decides, too. The output itself may be read by nobody, and counts.
  const auto decides = [&](execute::CellId cell) {
    return !checked_.inputs[cell.index] &&
           (uses.reads[cell.index] || std::ranges::find(outputs, cell) != outputs.end());
  };
  std::vector<terms::TermId> conditions;
  for (size_t tried = 0;;) {
    for (; tried < strategies_.size(); ++tried) {
      const std::optional<terms::TermId> reached = Reached(strategies_[tried], *checked_.plain, period, result);
      if (!reached) return Reach::kUnknown;
      conditions.push_back(checked_.terms.Not(*reached));
    }
    checked_.Report("states after " + std::to_string(period) + " periods: " + std::to_string(tried));
    const solver::Answer answer = Ask(checked_, conditions, checked_.RestMs());
    if (answer == solver::Answer::kNever) return Reach::kAlways;
    if (answer == solver::Answer::kUnknown) {
      result.reason = WhyUnknown(checked_);
      return Reach::kUnknown;
    }
    State state;
    terms::TermId same = checked_.terms.Bit(true);
    for (uint32_t i = 0; i < checked_.version.cells.count; ++i) {
      const execute::CellId cell(i);
      if (!decides(cell)) continue;
      const terms::TermId value = checked_.plain->Value(cell, period);
      state[cell] = checked_.solver->ValueOf(value);
      same = checked_.terms.And(
          same, checked_.terms.Eq(value, checked_.terms.Const(state[cell], checked_.terms.Width(value))));
    }
    const Reach found = FindStrategy(state, checked_.terms.Value(checked_.plain->TimeAfter(period)), result);
    if (found == Reach::kAlways) continue;
    if (found == Reach::kUnknown) return found;
    if (Ask(checked_, {&same, 1}, checked_.RestMs()) != solver::Answer::kPossible) return Reach::kUnknown;
    result.run = RunOf(checked_, *checked_.plain, same, period);
    return Reach::kStuck;
  }
}

bool StuckSearch::IsNeverStuck(PropertyResult& result) {
  machine::Relation& relation = checked_.Widest();
  machine::Unrolled from(checked_.terms, relation, checked_.inputs, machine::Start::kAnywhere,
                         "from " + std::to_string(checked_.terms.variable_count()));
  from.late = [this] { return checked_.Late(); };
  from.StartFrom([&relation](execute::CellId cell) { return relation.VariableOf(cell); }, relation.now());
  terms::TermId bad = checked_.terms.Bit(true);
  for (const Strategy& strategy : strategies_) {
    const std::optional<terms::TermId> reached = Reached(strategy, from, 0, result);
    if (!reached) return false;
    bad = checked_.terms.And(bad, checked_.terms.Not(*reached));
  }
  const MoreWords none;
  return IsNeverReached(checked_, QuestionOf(checked_, invariants_, bad, none), result);
}

}  // namespace

PropertyResult CheckNeverStuck(CheckedProgram& checked, ProgramInvariants& invariants, RunTrials& trials,
                               const Property& property) {
  PropertyResult result;
  result.periods = property.periods;
  for (const bool wanted : {true, false}) {
    StuckSearch search(checked, invariants, property, wanted);
    Reach reach = search.FromAnywhere(result);
    if (reach == Reach::kStuck && invariants.found().empty() && !checked.Late()) {
      std::vector<execute::CellId> cells;
      for (const auto& [cell, value] : search.stuck()) {
        if (!checked.inputs[cell.index]) cells.push_back(cell);
      }
      invariants.FindAround(cells);
      if (!invariants.found().empty()) reach = search.FromAnywhere(result);
    }
    for (uint32_t period = 1;
         reach == Reach::kStuck && period <= std::min(kMostStuckDepth, checked.options.most_periods); ++period) {
      const Reach after = search.After(period, result);
      if (after == Reach::kUnknown) return result;
      result.searched = period;
      if (after == Reach::kAlways) continue;
      result.periods = period;
      result.stuck_at = !wanted;
      result.reason = "from there no inputs make it " + std::to_string(wanted ? 1 : 0) + " within " +
                      std::to_string(property.periods) + " periods";
      trials.Conclude(property, result, terms::TermId(), result);
      return result;
    }
    if (reach == Reach::kStuck && search.IsNeverStuck(result)) reach = Reach::kAlways;
    if (reach == Reach::kAlways) continue;
    if (reach == Reach::kStuck) {
      result.reason = "there is a state from which no inputs make it " + std::to_string(wanted ? 1 : 0) +
                      ", and whether it can be reached is not known";
    }
    return result;
  }
  result.verdict = PropertyVerdict::kProved;
  result.reason.clear();
  result.invariants = std::max(result.invariants, static_cast<uint32_t>(invariants.found().size()));
  return result;
}

}  // namespace plcxx::prove::properties
