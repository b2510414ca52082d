// Outputs that can always still be moved: for every state there are inputs, which is not one question to a solver.
//
// A few sequences of inputs are collected, of which one works from every state: a state from which none of those so far
// works is found, then inputs that work from this very state, until there is no such state, or no such inputs. The host
// answers 0 here.
#include <algorithm>

#include "transpiler/prove/properties/check.h"

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

}  // namespace

/// Whether the strategy makes the output what is wanted, from the state of `from` after `period`; `asked` gets the
/// cells of that state on which it depends.
std::optional<terms::TermId> PropertyChecker::Reached(const StuckSearch& search, const Strategy& strategy,
                                                      machine::Unrolled& from, uint32_t period,
                                                      PropertyResult& result) {
  machine::Unrolled trial(terms_, *silent_, inputs_, machine::Start::kAnywhere, "trial");
  trial.late = [this] { return Late(); };
  trial.StartFrom([&from, period](execute::CellId cell) { return from.Value(cell, period); }, from.TimeAfter(period));
  trial.choose_input = [this, &strategy](execute::CellId cell, uint32_t at, uint32_t part) {
    const uint8_t width =
        execute::CellWidth(*version_.program, execute::CellAt(*version_.program, version_.cells, cell));
    const std::map<execute::CellId, uint64_t>& values = strategy[at - 1][part];
    const auto value = values.find(cell);
    return terms_.Const(value == values.end() ? 0 : value->second, width);
  };
  terms::TermId reached = terms_.Bit(false);
  for (uint32_t at = 1; at <= search.property.periods; ++at) {
    if (Extend(trial, at, result)) return std::nullopt;
    reached = terms_.Or(reached, Wanted(terms_, search.property, search.wanted, at, trial));
  }
  return reached;
}

/// Adds a strategy that works from this state; kStuck: there is none.
PropertyChecker::Reach PropertyChecker::FindStrategy(StuckSearch& search,
                                                     const std::map<execute::CellId, uint64_t>& state, uint64_t time,
                                                     PropertyResult& result) {
  machine::Unrolled trial(terms_, *silent_, inputs_, machine::Start::kAnywhere,
                          "try " + std::to_string(terms_.variable_count()));
  trial.late = [this] { return Late(); };
  trial.StartFrom(
      [this, &state](execute::CellId cell) {
        const auto value = state.find(cell);
        const uint8_t width =
            execute::CellWidth(*version_.program, execute::CellAt(*version_.program, version_.cells, cell));
        return terms_.Const(value == state.end() ? 0 : value->second, width);
      },
      terms_.Const(time, 32));
  terms::TermId reached = terms_.Bit(false);
  for (uint32_t period = 1; period <= search.property.periods; ++period) {
    if (Extend(trial, period, result)) return Reach::kUnknown;
    reached = terms_.Or(reached, Wanted(terms_, search.property, search.wanted, period, trial));
  }
  switch (Ask({&reached, 1}, RestMs())) {
    case solver::Answer::kNever:
      search.stuck = state;
      return Reach::kStuck;
    case solver::Answer::kUnknown:
      result.reason = WhyUnknown();
      return Reach::kUnknown;
    case solver::Answer::kPossible:
      break;
  }
  Strategy strategy;
  for (uint32_t period = 1; period <= search.property.periods; ++period) {
    strategy.emplace_back();
    for (const machine::Unrolled::Part& part : trial.parts(period)) {
      strategy.back().emplace_back();
      for (const auto& [cell, variable] : part) strategy.back().back()[cell] = solver_->ValueOf(variable);
    }
  }
  if (search.strategies.size() >= kMostStrategies) {
    result.reason = "no " + std::to_string(kMostStrategies) + " sequences of inputs are enough for all states";
    return Reach::kUnknown;
  }
  search.strategies.push_back(std::move(strategy));
  return Reach::kAlways;
}

PropertyChecker::Reach PropertyChecker::ReachFromAnywhere(StuckSearch& search, PropertyResult& result) {
  // Of a state only what the output depends on counts: facts are looked for around it. Properties that were checked
  // before have asked for other cells.
  std::vector<bool> matters(version_.cells.count);
  for (const execute::CellId cell : CellsBehind(terms_, *silent_, search.property.operands.front().cells))
    matters[cell.index] = true;
  std::vector<terms::TermId> conditions;
  for (const invariants::Invariant& invariant : invariants_) {
    conditions.push_back(
        invariants::ConditionOf(terms_, invariant, [this](execute::CellId cell) { return anywhere_->Value(cell, 0); }));
  }
  for (size_t tried = 0;;) {
    for (; tried < search.strategies.size(); ++tried) {
      const std::optional<terms::TermId> reached = Reached(search, search.strategies[tried], *anywhere_, 0, result);
      if (!reached) return Reach::kUnknown;
      conditions.push_back(terms_.Not(*reached));
    }
    Report("inputs that make it " + std::to_string(search.wanted ? 1 : 0) + ": " + std::to_string(tried));
    const solver::Answer answer = Ask(conditions, RestMs());
    if (answer == solver::Answer::kNever) return Reach::kAlways;
    if (answer == solver::Answer::kUnknown) {
      result.reason = WhyUnknown();
      return Reach::kUnknown;
    }
    std::map<execute::CellId, uint64_t> state;
    for (const auto& [cell, variable] : anywhere_->start_variables()) {
      if (matters[cell.index]) state[cell] = solver_->ValueOf(variable);
    }
    const uint64_t time = solver_->ValueOf(anywhere_->TimeAfter(0));
    const Reach found = FindStrategy(search, state, time, result);
    if (found != Reach::kAlways) return found;
  }
}

/// The same from the states that runs of so many periods reach; kStuck comes with the run.
PropertyChecker::Reach PropertyChecker::ReachAfter(StuckSearch& search, uint32_t period, PropertyResult& result) {
  if (Extend(*plain_, period, result)) return Reach::kUnknown;
  const machine::Uses uses = machine::UsesOf(version_);
  const std::vector<execute::CellId>& outputs = search.property.operands.front().cells;
  // The whole state: what else is read decides, too. The output itself may be read by nobody, and counts.
  const auto decides = [&](execute::CellId cell) {
    return !inputs_[cell.index] && (uses.reads[cell.index] || std::ranges::find(outputs, cell) != outputs.end());
  };
  std::vector<terms::TermId> conditions;
  for (size_t tried = 0;;) {
    for (; tried < search.strategies.size(); ++tried) {
      const std::optional<terms::TermId> reached = Reached(search, search.strategies[tried], *plain_, period, result);
      if (!reached) return Reach::kUnknown;
      conditions.push_back(terms_.Not(*reached));
    }
    Report("states after " + std::to_string(period) + " periods: " + std::to_string(tried));
    const solver::Answer answer = Ask(conditions, RestMs());
    if (answer == solver::Answer::kNever) return Reach::kAlways;
    if (answer == solver::Answer::kUnknown) {
      result.reason = WhyUnknown();
      return Reach::kUnknown;
    }
    std::map<execute::CellId, uint64_t> state;
    terms::TermId same = terms_.Bit(true);
    for (uint32_t i = 0; i < version_.cells.count; ++i) {
      const execute::CellId cell(i);
      if (!decides(cell)) continue;
      const terms::TermId value = plain_->Value(cell, period);
      state[cell] = solver_->ValueOf(value);
      same = terms_.And(same, terms_.Eq(value, terms_.Const(state[cell], terms_.Width(value))));
    }
    const Reach found = FindStrategy(search, state, terms_.Value(plain_->TimeAfter(period)), result);
    if (found == Reach::kAlways) continue;
    if (found == Reach::kUnknown) return found;
    if (Ask({&same, 1}, RestMs()) != solver::Answer::kPossible) return Reach::kUnknown;
    result.run = RunOf(*plain_, same, period);
    return Reach::kStuck;
  }
}

/// Whether no state can be reached from which none of the sequences of inputs works.
bool PropertyChecker::IsNeverStuck(const StuckSearch& search, PropertyResult& result) {
  machine::Relation& relation = Widest();
  machine::Unrolled from(terms_, relation, inputs_, machine::Start::kAnywhere,
                         "from " + std::to_string(terms_.variable_count()));
  from.late = [this] { return Late(); };
  from.StartFrom([&relation](execute::CellId cell) { return relation.VariableOf(cell); }, relation.now());
  terms::TermId bad = terms_.Bit(true);
  for (const Strategy& strategy : search.strategies) {
    const std::optional<terms::TermId> reached = Reached(search, strategy, from, 0, result);
    if (!reached) return false;
    bad = terms_.And(bad, terms_.Not(*reached));
  }
  return IsNeverReached(bad, {}, result);
}

PropertyResult PropertyChecker::CheckNeverStuck(const Property& property) {
  PropertyResult result;
  result.periods = property.periods;
  for (const bool wanted : {true, false}) {
    StuckSearch search{.property = property, .wanted = wanted, .strategies = {}, .stuck = {}};
    Reach reach = ReachFromAnywhere(search, result);
    if (reach == Reach::kStuck && invariants_.empty() && !Late()) {
      std::vector<execute::CellId> cells;
      for (const auto& [cell, value] : search.stuck) {
        if (!inputs_[cell.index]) cells.push_back(cell);
      }
      FindInvariantsAround(cells);
      if (!invariants_.empty()) reach = ReachFromAnywhere(search, result);
    }
    for (uint32_t period = 1; reach == Reach::kStuck && period <= std::min(kMostStuckDepth, options_.most_periods);
         ++period) {
      const Reach after = ReachAfter(search, period, result);
      if (after == Reach::kUnknown) return result;
      result.searched = period;
      if (after == Reach::kAlways) continue;
      result.periods = period;
      result.stuck_at = !wanted;
      result.reason = "from there no inputs make it " + std::to_string(wanted ? 1 : 0) + " within " +
                      std::to_string(property.periods) + " periods";
      Conclude(property, result, terms::TermId(), result);
      return result;
    }
    if (reach == Reach::kStuck && IsNeverStuck(search, result)) reach = Reach::kAlways;
    if (reach == Reach::kAlways) continue;
    if (reach == Reach::kStuck) {
      result.reason = "there is a state from which no inputs make it " + std::to_string(wanted ? 1 : 0) +
                      ", and whether it can be reached is not known";
    }
    return result;
  }
  result.verdict = PropertyVerdict::kProved;
  result.reason.clear();
  result.invariants = std::max(result.invariants, static_cast<uint32_t>(invariants_.size()));
  return result;
}

}  // namespace plcxx::prove::properties
