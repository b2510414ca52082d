#include "transpiler/prove/properties/computed_runs.h"

#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/properties/run_of.h"

namespace plcxx::prove::properties {
namespace {

/// That what the host may write beside inputs of the machine stays as it is behind power-on.
std::vector<terms::TermId> StaysQuiet(CheckedProgram& checked, machine::Unrolled& unrolled, uint32_t periods) {
  std::vector<terms::TermId> conditions;
  for (uint32_t period = 1; period <= periods; ++period) {
    for (const machine::Unrolled::Part& part : unrolled.parts(period)) {
      for (const auto& [cell, variable] : part) {
        if (machine::DirectionOf(checked.version, cell) != ir::Direction::kInput)
          conditions.push_back(checked.terms.Eq(variable, unrolled.Value(cell, 0)));
      }
    }
  }
  return conditions;
}

}  // namespace

bool SearchRuns(CheckedProgram& checked, RunTrials& trials, const Property& property, uint32_t period,
                PropertyResult& result) {
  checked.Report("runs of " + Periods(period));
  for (machine::Unrolled* const unrolled : {checked.plain.get(), checked.answered.get()}) {
    if (unrolled == nullptr) continue;
    if (Extend(checked, *unrolled, period, result)) return true;
    const terms::TermId violated = checked.terms.Not(HoldsAfter(checked.terms, property, period, ValuesOf(*unrolled)));
    if (checked.Late()) {
      result.reason = kNoTime;
      return true;
    }
    if (checked.terms.IsFalse(violated)) continue;
    // Runs that only move inputs of the machine are simulated as they are computed: they come first.
    solver::Answer answer = solver::Answer::kNever;
    std::vector<terms::TermId> conditions = StaysQuiet(checked, *unrolled, period);
    if (!conditions.empty() && unrolled == checked.plain.get()) {
      conditions.push_back(violated);
      answer = Ask(checked, conditions, checked.RestMs() / 2);
    }
    if (answer != solver::Answer::kPossible) answer = Ask(checked, {&violated, 1}, checked.RestMs());
    switch (answer) {
      case solver::Answer::kNever:
        break;
      case solver::Answer::kUnknown:
        result.reason = WhyUnknown(checked);
        return true;
      case solver::Answer::kPossible:
        PropertyResult found;
        found.periods = period;
        found.run = RunOf(checked, *unrolled, violated, period);
        if (unrolled == checked.answered.get()) {
          // What the host answered may not have mattered.
          PropertyResult shown;
          trials.Conclude(property, std::move(found), violated, shown);
          if (shown.verdict == PropertyVerdict::kViolated) {
            shown.searched = result.searched;
            result = std::move(shown);
            return true;
          }
          result.reason = machine::DependsOnLoop(checked.terms, violated)
                              ? "after " + Periods(period) +
                                    " it depends on a loop of which it is not known how often it goes round"
                              : "after " + Periods(period) +
                                    " certain answers of the host violate it, which a simulation does not give";
          return true;
        }
        trials.Conclude(property, std::move(found), violated, result);
        return true;
    }
  }
  result.searched = period;
  return false;
}

}  // namespace plcxx::prove::properties
