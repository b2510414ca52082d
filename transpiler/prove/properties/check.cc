#include "transpiler/prove/properties/check.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/cone.h"

namespace plcxx::prove {
namespace {

constexpr size_t kMostInvariantCells = 160;  // around which invariants are looked for

const char* const kNoTime = "the time was not enough";

std::string Periods(uint32_t count) { return std::to_string(count) + (count == 1 ? " period" : " periods"); }

}  // namespace

PropertyChecker::PropertyChecker(const Version& version, CheckOptions options)
    : version_(version), options_(std::move(options)), inputs_(InputsOf(version)) {
  LoadedSolver loaded = LoadSolver(terms_);
  solver_ = std::move(loaded.solver);
  refusal_ = std::move(loaded.reason);
  if (!refusal_.empty()) return;
  answers_matter_ = AnswersMatter(*version.program);
  const Start start = options_.retentive == RetentiveMemory::kAny ? Start::kAnyRetentive : Start::kPowerOn;
  plain_ = std::make_unique<Unrolled>(terms_, version_, inputs_, start, HostAnswers::kNothing, "run");
  if (answers_matter_)
    answered_ = std::make_unique<Unrolled>(terms_, version_, inputs_, start, HostAnswers::kAny, "answered run");
  anywhere_ = std::make_unique<Unrolled>(terms_, version_, inputs_, Start::kAnywhere,
                                         answers_matter_ ? HostAnswers::kAny : HostAnswers::kNothing, "any");
  refusal_ = plain_->refusal();
}

uint32_t PropertyChecker::RestMs() const {
  const auto rest =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now()).count();
  return static_cast<uint32_t>(std::clamp<int64_t>(rest, 0, std::numeric_limits<int32_t>::max()));
}

ValueAfter PropertyChecker::ValuesOf(Unrolled& unrolled) {
  return [&unrolled](CellId cell, uint32_t period) { return unrolled.Value(cell, period); };
}

bool PropertyChecker::Extend(Unrolled& unrolled, uint32_t periods, PropertyResult& result) {
  while (unrolled.periods() < periods && unrolled.refusal().empty() && !Late()) unrolled.Advance();
  result.reason = !unrolled.refusal().empty() ? unrolled.refusal() : unrolled.periods() < periods ? kNoTime : "";
  return !result.reason.empty();
}

PropertyResult PropertyChecker::Check(const Property& property) {
  deadline_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(options_.time_ms);
  invariants_.clear();
  if (property.kind == PropertyKind::kNeverStuck) return CheckNeverStuck(property);
  PropertyResult result;
  const uint32_t window = WindowOf(property);
  // Behind `window` - 1 periods the induction looks at whole windows.
  for (uint32_t period = 1; period <= window; ++period) {
    if (SearchRuns(property, period, result)) return result;
  }
  bool looked_for_invariants = false;
  for (uint32_t k = 1; window + k <= options_.most_periods || k == 1; ++k) {
    if (TryInduction(property, k, result)) return result;
    if (!looked_for_invariants && !Late()) {
      looked_for_invariants = true;
      FindInvariantsFor(property);
      if (!invariants_.empty() && TryInduction(property, k, result)) return result;
    }
    if (SearchRuns(property, window + k, result)) return result;
  }
  result.reason = "no run of " + Periods(result.searched) + " from power-on violates it, and " +
                  std::to_string(options_.most_periods) + " periods are not enough to prove it";
  return result;
}

bool PropertyChecker::SearchRuns(const Property& property, uint32_t period, PropertyResult& result) {
  Report("runs of " + Periods(period));
  for (Unrolled* const unrolled : {plain_.get(), answered_.get()}) {
    if (unrolled == nullptr) continue;
    if (Extend(*unrolled, period, result)) return true;
    const TermId violated = terms_.Not(HoldsAfter(terms_, property, period, ValuesOf(*unrolled)));
    if (terms_.IsFalse(violated)) continue;
    switch (solver_->Check({&violated, 1}, std::max(1U, RestMs()))) {
      case Answer::kNever:
        break;
      case Answer::kUnknown:
        result.reason = kNoTime;
        return true;
      case Answer::kPossible:
        if (unrolled == answered_.get()) {
          result.reason =
              "after " + Periods(period) + " certain answers of the host violate it, which a simulation does not give";
          return true;
        }
        result.verdict = PropertyVerdict::kViolated;
        result.periods = period;
        result.run = RunOf(*unrolled, violated, period);
        return true;
    }
  }
  result.searched = period;
  return false;
}

/// From any state: `k` periods that do not violate it, in all of which the property sees a whole window, then one more.
bool PropertyChecker::TryInduction(const Property& property, uint32_t k, PropertyResult& result) {
  const uint32_t window = WindowOf(property);
  Report("induction over " + Periods(k));
  if (Extend(*anywhere_, window + k, result)) return true;
  std::vector<TermId> conditions;
  for (const Invariant& invariant : invariants_) {
    const auto value = [this](CellId cell) { return anywhere_->Value(cell, 0); };
    conditions.push_back(ConditionOf(terms_, invariant, value));
  }
  for (uint32_t period = window; period < window + k; ++period)
    conditions.push_back(HoldsAfter(terms_, property, period, ValuesOf(*anywhere_)));
  conditions.push_back(terms_.Not(HoldsAfter(terms_, property, window + k, ValuesOf(*anywhere_))));
  switch (solver_->Check(conditions, std::max(1U, RestMs() / 2))) {
    case Answer::kPossible:
      return false;
    case Answer::kUnknown:
      result.reason = kNoTime;
      return Late();
    case Answer::kNever:
      break;
  }
  result.verdict = PropertyVerdict::kProved;
  result.periods = k;
  result.invariants = static_cast<uint32_t>(invariants_.size());
  result.reason.clear();
  return true;
}

void PropertyChecker::FindInvariantsFor(const Property& property) {
  const uint32_t window = WindowOf(property);
  // The cells that the nearest periods depend on; those of the next ones as far as there are not too many.
  std::vector<CellId> cells;
  for (uint32_t period = 1; period <= window + 1 && cells.size() < kMostInvariantCells; ++period) {
    const TermId holds = HoldsAfter(terms_, property, period, ValuesOf(*anywhere_));
    for (const CellId cell : CellsIn(terms_, holds, anywhere_->start_variables())) {
      if (std::ranges::find(cells, cell) == cells.end()) cells.push_back(cell);
    }
  }
  FindInvariantsAround(cells);
}

void PropertyChecker::FindInvariantsAround(const std::vector<CellId>& cells) {
  // They are proved for the slow part's period alone.
  if (version_.program->schedule.fast_ms != 0) return;
  Report("invariants");
  invariants_ = FindInvariants(
      terms_, *solver_, version_, cells, [this](CellId cell) { return bool{inputs_[cell.index]}; }, RestMs() / 3);
}

PropertyRun PropertyChecker::RunOf(Unrolled& unrolled, TermId violated, uint32_t periods) {
  const Cone cone(terms_, violated);
  struct Input {
    uint32_t period, part;
    CellId cell;
    uint32_t variable;
  };
  std::vector<Input> inputs;
  std::vector<uint64_t> values(terms_.variable_count());
  for (uint32_t period = 1; period <= periods; ++period) {
    for (uint32_t part = 0; part < unrolled.part_count(); ++part) {
      for (const auto& [cell, variable] : unrolled.parts(period)[part]) {
        if (!cone.Has(variable)) continue;
        inputs.push_back({period, part, cell, terms_[variable].a});
        values[inputs.back().variable] = solver_->ValueOf(variable);
      }
    }
  }
  // An input that need not change does not; one that need not be 1 is 0.
  std::map<CellId, uint64_t> before;
  for (const Input& input : inputs) {
    const uint64_t value = values[input.variable];
    if (value != before[input.cell]) {
      values[input.variable] = before[input.cell];
      if (Late() || cone.Evaluate(values) == 0) values[input.variable] = value;
    }
    before[input.cell] = values[input.variable];
  }
  PropertyRun run;
  run.periods.assign(periods, std::vector<std::vector<InputValue>>(unrolled.part_count()));
  std::map<CellId, uint64_t> now;
  for (const Input& input : inputs) {
    if (now.try_emplace(input.cell, 0).second) run.periods[0][0].push_back({input.cell, false});
  }
  for (const Input& input : inputs) {
    if (values[input.variable] == now[input.cell]) continue;
    now[input.cell] = values[input.variable];
    std::vector<InputValue>& part = run.periods[input.period - 1][input.part];
    const auto same = std::ranges::find(part, input.cell, &InputValue::cell);
    if (same != part.end()) {
      same->value = now[input.cell] != 0;
    } else {
      part.push_back({input.cell, now[input.cell] != 0});
    }
  }
  return run;
}

}  // namespace plcxx::prove
