#include "transpiler/prove/properties/check.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/wide_search.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostInvariantCells = 160;  // around which invariants are looked for
/// Of the time: a fortieth, but not much, for a few runs first, a tenth and a third of what is left for many.
constexpr uint32_t kQuickShare = 40, kSearchShare = 10, kThoroughShare = 3;
constexpr uint32_t kFirstInductionShare = 8, kInductionShare = 2;
constexpr uint32_t kMostFirstMs = 200, kMostQuickMs = 1500;
constexpr uint32_t kMostPlantedMs = 2000;  // after a violation without the plant
constexpr uint32_t kMostQuickWindow = 20;
constexpr uint32_t kMostNotRepeated = 3;  // what the control does by itself, it does in the next runs, too
constexpr std::chrono::seconds kRemarkTime{5};
constexpr std::chrono::milliseconds kDeepenedTime{1500};  // before runs are tried for long
constexpr size_t kMostQuestionTerms = 250'000;

const char* const kNoTime = "the time was not enough";

std::vector<execute::CellId> OperandCellsOf(const Property& property) {
  std::vector<execute::CellId> cells;
  for (const PropertyOperand& operand : property.operands)
    cells.insert(cells.end(), operand.cells.begin(), operand.cells.end());
  return cells;
}

std::string Periods(uint32_t count) { return std::to_string(count) + (count == 1 ? " period" : " periods"); }

}  // namespace

PropertyChecker::PropertyChecker(const machine::Version& version, CheckOptions options)
    : version_(version),
      options_(std::move(options)),
      inputs_(machine::InputsOf(version)),
      requests_(machine::RequestCells(version)) {
  solver::LoadedSolver loaded = solver::LoadSolver(terms_);
  solver_ = std::move(loaded.solver);
  refusal_ = std::move(loaded.reason);
  if (!refusal_.empty()) return;
  new_each_time_ = inputs_;
  for (uint32_t i = 0; i < version_.cells.count; ++i)
    new_each_time_[i] = inputs_[i] || machine::IsInbox(version_, execute::CellId(i));
  silent_ = std::make_unique<machine::Relation>(terms_, version_, machine::HostAnswers::kNothing);
  if (machine::AnswersMatter(version))
    any_ = std::make_unique<machine::Relation>(terms_, version_, machine::HostAnswers::kAny, silent_.get());
  const bool any_retentive = options_.retentive == RetentiveMemory::kAny;
  plain_ = std::make_unique<machine::Unrolled>(
      terms_, *silent_, inputs_, any_retentive ? machine::Start::kAnyRetentive : machine::Start::kPowerOn, "run");
  answered_ = std::make_unique<machine::Unrolled>(
      terms_, Widest(), inputs_, any_retentive ? machine::Start::kAnyRetentive : machine::Start::kAnsweredPowerOn,
      "answered run");
  if (!any_ && (any_retentive || !DependsOnPowerOn())) answered_.reset();
  anywhere_ = std::make_unique<machine::Unrolled>(terms_, Widest(), inputs_, machine::Start::kAnywhere, "any");
  for (machine::Unrolled* const unrolled : {plain_.get(), answered_.get(), anywhere_.get()}) {
    if (unrolled == nullptr) continue;
    unrolled->late = [this] { return Late(); };
    // Without answers nothing is ever done that the program asks for: as scenarios do it, the bit is taken back. So it
    // may be between two parts, whatever the control does in them.
    if (any_) unrolled->taken_back = requests_;
  }
  refusal_ = plain_->refusal();
  if (refusal_.empty()) refusal_ = anywhere_->refusal();
}

PropertyChecker::~PropertyChecker() = default;

bool PropertyChecker::DependsOnPowerOn() const {
  const std::vector<terms::TermId>& state = answered_->after_power_on();
  for (uint32_t i = 0; i < version_.cells.calls && i < state.size(); ++i) {
    const execute::CellId cell(i);
    if (!inputs_[i] && machine::IsState(version_, cell) && !terms_.IsConst(state[i])) return true;
  }
  return false;
}

uint32_t PropertyChecker::RestMs() const {
  const auto rest =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now()).count();
  return static_cast<uint32_t>(std::clamp<int64_t>(rest, 0, std::numeric_limits<int32_t>::max()));
}

ValueAfter PropertyChecker::ValuesOf(machine::Unrolled& unrolled) {
  return [&unrolled](execute::CellId cell, uint32_t period) { return unrolled.Value(cell, period); };
}

bool PropertyChecker::Extend(machine::Unrolled& unrolled, uint32_t periods, PropertyResult& result) {
  while (unrolled.periods() < periods) unrolled.Advance();
  if (Late()) result.reason = kNoTime;
  return Late();
}

PropertyResult PropertyChecker::Check(const Property& property) {
  deadline_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(options_.time_ms);
  replays_ = 0;
  PropertyResult result = CheckInTime(property);
  if (result.verdict == PropertyVerdict::kViolated) PreferPlanted(property, result);
  // The time may end between two steps.
  if (result.verdict == PropertyVerdict::kUndecided && result.reason.empty()) result.reason = kNoTime;
  if (result.verdict == PropertyVerdict::kProved && options_.slices > 1 && DependsOnFastPart(property)) {
    result.verdict = PropertyVerdict::kUndecided;
    result.reason = "the fast part, on which it depends, runs in each of the " + std::to_string(options_.slices) +
                    " slices of a slow pass, behind what they have done so far: that is not followed";
  }
  if (result.verdict == PropertyVerdict::kProved) result.remark = RemarkOn(property);
  if (result.verdict == PropertyVerdict::kViolated) result.remark = RemarkOnOutputs(property);
  return result;
}

bool PropertyChecker::DependsOnFastPart(const Property& property) {
  if (!machine::HasFastPart(version_)) return false;
  machine::Relation& relation = Widest();
  if (!fast_part_)
    fast_part_ = machine::RunPart(terms_, version_, machine::Part::kFast,
                                  {.initial = [&relation](execute::CellId cell) { return relation.VariableOf(cell); },
                                   .now = relation.now(),
                                   .observed = {}});
  if (!fast_part_->refusal.empty()) return true;
  std::vector<terms::TermId> next;
  for (const execute::CellId cell : CellsBehind(terms_, relation, OperandCellsOf(property))) {
    const terms::TermId after = fast_part_->next[cell.index];
    if (!new_each_time_[cell.index] && after.valid()) next.push_back(after);
  }
  return std::ranges::any_of(terms::ConeOf(terms_, next), [&](terms::TermId id) {
    if (terms_[id].kind != terms::TermKind::kVariable) return false;
    const execute::CellId cell = relation.CellOf(id);
    if (!cell.valid()) return true;  // the time
    return cell.index < version_.cells.calls && !new_each_time_[cell.index] && machine::IsState(version_, cell);
  });
}

std::string PropertyChecker::RemarkOnOutputs(const Property& property) const {
  const machine::Uses uses = machine::UsesOf(version_);
  for (const PropertyOperand& operand : property.operands) {
    const bool is_set = std::ranges::all_of(operand.cells, [&](execute::CellId cell) {
      return inputs_[cell.index] && !uses.writes[cell.index] &&
             machine::DirectionOf(version_, cell) == ir::Direction::kOutput;
    });
    if (is_set) return "the program does not write '" + operand.text + "': anybody may set it";
  }
  return {};
}

std::string PropertyChecker::RemarkOn(const Property& property) {
  const machine::Uses uses = machine::UsesOf(version_);
  for (const PropertyOperand& operand : property.operands) {
    const bool changes = std::ranges::any_of(
        operand.cells, [&](execute::CellId cell) { return inputs_[cell.index] || uses.writes[cell.index]; });
    if (!changes) return "nothing writes '" + operand.text + "'";
  }
  if (property.kind != PropertyKind::kResponse) return {};
  // The case comes when it can be shown that it does not stay away.
  Property never = property;
  never.kind = PropertyKind::kAlways;
  never.conditions.push_back({.kind = ConditionKind::kNot, .children = {property.condition}});
  never.condition = static_cast<uint32_t>(never.conditions.size() - 1);
  deadline_ = std::min(deadline_, std::chrono::steady_clock::now() + kRemarkTime);
  const auto why_not_shown = std::exchange(options_.why_not_shown, {});
  const PropertyVerdict verdict = CheckInTime(never).verdict;
  options_.why_not_shown = why_not_shown;
  switch (verdict) {
    case PropertyVerdict::kProved:
      return "what stands before 'implies' is never true";
    case PropertyVerdict::kUndecided:
      return "what stands before 'implies' is true in no run that was found";
    case PropertyVerdict::kViolated:
      return {};
  }
  PLCXX_UNREACHABLE();
}

PropertyResult PropertyChecker::CheckInTime(const Property& property) {
  invariants_.clear();
  wide_.reset();
  not_repeated_ = 0;
  if (property.kind == PropertyKind::kNeverStuck) return CheckNeverStuck(property);
  PropertyResult result;
  // Most of what holds is proved in less time than many runs would take.
  if (TryRuns(property, std::min(kMostFirstMs, RestMs() / kQuickShare), false, result)) return result;
  const uint32_t window = WindowOf(property);
  bool tried_runs = false, looked_for_invariants = false;
  const auto try_runs = [&] {
    if (std::exchange(tried_runs, true)) return false;
    return TryWideRuns(property, RestMs() / kThoroughShare / 2, result) ||
           TryRuns(property, RestMs() / kThoroughShare / 2, true, result);
  };
  const auto try_quickly = [&] {
    const auto time = [this] { return std::min(kMostQuickMs, RestMs() / kSearchShare) / 2; };
    return TryWideRuns(property, time(), result) || TryRuns(property, time(), true, result);
  };
  const auto search_runs = [&](uint32_t period) {
    if (!SearchRuns(property, period, result)) return false;
    // A run that the machine does not show says nothing of others.
    if (result.verdict == PropertyVerdict::kUndecided) try_runs();
    return true;
  };
  if (window > kMostQuickWindow) {
    // A long wait is found sooner by waiting, if it is found at all; what holds is counted.
    if (try_quickly()) return result;
    if (!options_.only_runs && TryCountingIn(RestMs() - RestMs() / kThoroughShare, property, result)) return result;
    if (try_runs()) return result;
  }
  // After `window` - 1 periods the induction looks at whole windows.
  for (uint32_t period = 1; period <= window; ++period) {
    if (search_runs(period)) return result;
  }
  auto deepened_end = std::chrono::steady_clock::time_point::max();
  for (uint32_t k = 1; window + k <= options_.most_periods || k == 1; ++k) {
    if (k == 2) deepened_end = std::chrono::steady_clock::now() + kDeepenedTime;
    if (!options_.only_runs && TryInduction(property, k, result)) return result;
    if (!options_.only_runs && !looked_for_invariants && !Late()) {
      looked_for_invariants = true;
      if (TryWideRuns(property, std::min(kMostFirstMs, RestMs() / kQuickShare), result)) return result;
      FindInvariantsFor(property);
      if (!invariants_.empty() && TryInduction(property, k, result)) return result;
      // Few facts are found at once; a violation that is not far away is found sooner than many.
      if (TryReachableFor(std::min(kMostQuickMs, RestMs() / kQuickShare), property, result)) return result;
      if (try_quickly()) return result;
      if (TryReachable(property, result)) return result;
    }
    // As long as they cost little, more periods hit what takes luck in a run.
    if (k > 1 && std::chrono::steady_clock::now() > deepened_end && try_runs()) return result;
    if (search_runs(window + k)) return result;
  }
  if (try_runs()) return result;
  result.reason = "no run of " + Periods(result.searched) + " from power-on violates it, and " +
                  std::to_string(options_.most_periods) + " periods are not enough to prove it";
  return result;
}

void PropertyChecker::AddInputsBehind(const std::vector<execute::CellId>& cells, RunSearch& search) {
  const auto add = [](execute::CellId cell, std::vector<execute::CellId>& to) {
    if (std::ranges::find(to, cell) == to.end()) to.push_back(cell);
  };
  // Where the host may answer anything, inputs that it writes within a period are answers, too: no cells.
  for (const execute::CellId cell : CellsBehind(terms_, *silent_, cells)) {
    if (inputs_[cell.index]) add(cell, search.inputs);
    if (requests_[cell.index]) add(cell, search.requests);
  }
}

bool PropertyChecker::TryRuns(const Property& property, uint64_t milliseconds, bool thorough, PropertyResult& result) {
  if (!options_.try_runs || options_.retentive == RetentiveMemory::kAny || Late()) return false;
  Report(thorough ? "trying runs" : "trying a few runs");
  RunSearch search{
      .property = &property, .inputs = {}, .requests = {}, .milliseconds = milliseconds, .thorough = thorough};
  if (options_.planted.try_runs) {
    search.milliseconds /= 2;
    if (TryPlantedRuns(property, search, result)) return true;
  }
  AddInputsBehind(OperandCellsOf(property), search);
  return TryFound(property, options_.try_runs(search), result);
}

bool PropertyChecker::TryWideRuns(const Property& property, uint64_t milliseconds, PropertyResult& result) {
  if (!options_.try_runs || options_.retentive == RetentiveMemory::kAny || Late()) return false;
  Report("trying runs side by side");
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  RunSearch search{.property = &property, .inputs = {}, .requests = {}, .milliseconds = milliseconds};
  AddInputsBehind(OperandCellsOf(property), search);
  if (!wide_) {
    const std::vector<execute::CellId> behind = CellsBehind(terms_, *silent_, OperandCellsOf(property));
    wide_ = std::make_unique<WideSearch>(terms_, *silent_, search, NumbersAmong(behind), end);
  }
  search.only_similar = true;
  while (not_repeated_ < kMostNotRepeated) {
    const std::optional<PropertyRun> run = wide_->Find(end);
    if (!run) return false;
    search.similar = &*run;
    search.milliseconds = std::max<uint64_t>(kMostFirstMs, RestMs() / kQuickShare);
    if (TryFound(property, options_.try_runs(search), result)) return true;
    ++not_repeated_;
  }
  return false;
}

bool PropertyChecker::TryPlantedRuns(const Property& property, RunSearch search, PropertyResult& result) {
  AddInputsBehind(OperandCellsOf(property), search);
  // What moves the plant moves the inputs that it drives.
  AddInputsBehind(options_.planted.reads, search);
  return TryFound(property, options_.planted.try_runs(search), result);
}

bool PropertyChecker::TryFound(const Property& property, std::optional<PropertyRun> run, PropertyResult& result) {
  if (!run) return false;
  PropertyResult found;
  found.periods = static_cast<uint32_t>(run->periods.size());
  found.run = std::move(run);
  // The program in one piece shows it; cut into slices it may not.
  PropertyResult concluded;
  Conclude(property, std::move(found), terms::TermId(), concluded);
  if (concluded.verdict != PropertyVerdict::kViolated) return false;
  concluded.searched = result.searched;
  result = std::move(concluded);
  return true;
}

void PropertyChecker::PreferPlanted(const Property& property, PropertyResult& result) {
  if (!options_.planted.try_runs || property.kind == PropertyKind::kNeverStuck) return;
  if (options_.retentive == RetentiveMemory::kAny || !result.run || result.run->has_plant || Late()) return;
  Report("trying runs with the plant");
  // A copy, for what is found is written into the result.
  const PropertyRun similar = *result.run;
  TryPlantedRuns(property,
                 {.property = &property,
                  .inputs = {},
                  .requests = {},
                  .milliseconds = std::min(kMostPlantedMs, RestMs()),
                  .thorough = true,
                  .similar = &similar},
                 result);
}

void PropertyChecker::Conclude(const Property& property, PropertyResult found, terms::TermId violated,
                               PropertyResult& result) {
  found.verdict = PropertyVerdict::kViolated;
  found.searched = result.searched;
  found.replay = replays_;
  const std::string why_not = options_.why_not_shown ? options_.why_not_shown(property, found) : std::string();
  if (options_.why_not_shown) ++replays_;
  if (!why_not.empty()) {
    found.verdict = PropertyVerdict::kUndecided;
    found.reason = violated.valid() && machine::DependsOnLoop(terms_, violated)
                       ? "it depends on a loop of which it is not known how often it goes round: a run of " +
                             Periods(found.periods) + " might violate it, but " + why_not
                       : "a run of " + Periods(found.periods) + " violates it, but " + why_not;
  }
  result = std::move(found);
}

std::vector<terms::TermId> PropertyChecker::StaysQuiet(machine::Unrolled& unrolled, uint32_t periods) {
  std::vector<terms::TermId> conditions;
  for (uint32_t period = 1; period <= periods; ++period) {
    for (const machine::Unrolled::Part& part : unrolled.parts(period)) {
      for (const auto& [cell, variable] : part) {
        if (machine::DirectionOf(version_, cell) != ir::Direction::kInput)
          conditions.push_back(terms_.Eq(variable, unrolled.Value(cell, 0)));
      }
    }
  }
  return conditions;
}

bool PropertyChecker::SearchRuns(const Property& property, uint32_t period, PropertyResult& result) {
  Report("runs of " + Periods(period));
  for (machine::Unrolled* const unrolled : {plain_.get(), answered_.get()}) {
    if (unrolled == nullptr) continue;
    if (Extend(*unrolled, period, result)) return true;
    const terms::TermId violated = terms_.Not(HoldsAfter(terms_, property, period, ValuesOf(*unrolled)));
    if (Late()) {
      result.reason = kNoTime;
      return true;
    }
    if (terms_.IsFalse(violated)) continue;
    // Runs that only move inputs of the machine are simulated as they are computed: they come first.
    solver::Answer answer = solver::Answer::kNever;
    std::vector<terms::TermId> conditions = StaysQuiet(*unrolled, period);
    if (!conditions.empty() && unrolled == plain_.get()) {
      conditions.push_back(violated);
      answer = Ask(conditions, RestMs() / 2);
    }
    if (answer != solver::Answer::kPossible) answer = Ask({&violated, 1}, RestMs());
    switch (answer) {
      case solver::Answer::kNever:
        break;
      case solver::Answer::kUnknown:
        result.reason = WhyUnknown();
        return true;
      case solver::Answer::kPossible:
        PropertyResult found;
        found.periods = period;
        found.run = RunOf(*unrolled, violated, period);
        if (unrolled == answered_.get()) {
          // What the host answered may not have mattered.
          PropertyResult shown;
          Conclude(property, std::move(found), violated, shown);
          if (shown.verdict == PropertyVerdict::kViolated) {
            shown.searched = result.searched;
            result = std::move(shown);
            return true;
          }
          result.reason = machine::DependsOnLoop(terms_, violated)
                              ? "after " + Periods(period) +
                                    " it depends on a loop of which it is not known how often it goes round"
                              : "after " + Periods(period) +
                                    " certain answers of the host violate it, which a simulation does not give";
          return true;
        }
        Conclude(property, std::move(found), violated, result);
        return true;
    }
  }
  result.searched = period;
  return false;
}

/// From any state: `k` periods that do not violate it, in all of which the property sees a whole window, then one more.
/// The state that it begins with stands after the first of them.
bool PropertyChecker::TryInduction(const Property& property, uint32_t k, PropertyResult& result) {
  const uint32_t window = WindowOf(property);
  Report("induction over " + Periods(k));
  if (Extend(*anywhere_, window + k - 1, result)) return true;
  std::vector<terms::TermId> conditions;
  for (const invariants::Invariant& invariant : invariants_) {
    const auto value = [this](execute::CellId cell) { return anywhere_->Value(cell, 0); };
    conditions.push_back(invariants::ConditionOf(terms_, invariant, value));
  }
  const ValueAfter value = [this](execute::CellId cell, uint32_t period) { return anywhere_->Value(cell, period - 1); };
  for (uint32_t period = window; period < window + k; ++period)
    conditions.push_back(HoldsAfter(terms_, property, period, value));
  conditions.push_back(terms_.Not(HoldsAfter(terms_, property, window + k, value)));
  // From a state that cannot be reached much may happen: the first answer need not be waited for.
  const uint32_t share = k == 1 && invariants_.empty() ? kFirstInductionShare : kInductionShare;
  switch (Ask(conditions, RestMs() / share)) {
    case solver::Answer::kPossible:
      return false;
    case solver::Answer::kUnknown:
      result.reason = WhyUnknown();
      return Late();
    case solver::Answer::kNever:
      break;
  }
  result.verdict = PropertyVerdict::kProved;
  result.periods = k;
  result.invariants = static_cast<uint32_t>(invariants_.size());
  result.reason.clear();
  return true;
}

std::string PropertyChecker::WhyUnknown() const {
  return too_large_ ? "what it depends on is too much for the solver" : kNoTime;
}

solver::Answer PropertyChecker::Ask(std::span<const terms::TermId> conditions, uint32_t milliseconds) {
  // What was made when the time was over means nothing.
  too_large_ = false;
  if (Late()) return solver::Answer::kUnknown;
  // The solver's time begins when it has read the question.
  too_large_ = terms::ConeOf(terms_, conditions).size() > kMostQuestionTerms;
  if (too_large_) return solver::Answer::kUnknown;
  return solver_->Check(conditions, solver::Limit::Clock(std::max(1U, milliseconds)));
}

void PropertyChecker::FindInvariantsFor(const Property& property) {
  const uint32_t window = WindowOf(property);
  // The cells that the nearest periods depend on; those of the next ones as far as there are not too many.
  std::vector<execute::CellId> cells;
  const ValueAfter value = [this](execute::CellId cell, uint32_t period) { return anywhere_->Value(cell, period - 1); };
  for (uint32_t period = 1; period <= window + 1 && cells.size() < kMostInvariantCells; ++period) {
    const terms::TermId holds = HoldsAfter(terms_, property, period, value);
    for (const execute::CellId cell : CellsIn(terms_, holds, anywhere_->start_variables())) {
      if (std::ranges::find(cells, cell) == cells.end()) cells.push_back(cell);
    }
  }
  FindInvariantsAround(cells);
}

void PropertyChecker::FindInvariantsAround(const std::vector<execute::CellId>& cells) {
  // Of those that outlive a fast part, too, no property is known that needs them.
  if (version_.program->schedule.fast_ms != 0) return;
  const std::vector<execute::CellId> behind = CellsBehind(terms_, Widest(), cells);
  std::vector<terms::TermId> next;
  for (const execute::CellId cell : behind) {
    if (Widest().period()[cell.index].valid()) next.push_back(Widest().period()[cell.index]);
  }
  if (terms::ConeOf(terms_, next).size() > kMostQuestionTerms) return;
  Report("invariants");
  const invariants::SeenStates seen =
      [this](const std::function<void(const invariants::CellValues&, uint64_t)>& visit) { wide_->ForEachState(visit); };
  invariants::InvariantFinder finder(
      terms_, *solver_,
      {.version = version_,
       .cells = cells,
       .is_input = [this](execute::CellId cell) { return bool{new_each_time_[cell.index]}; },
       .seen_states = wide_ ? seen : invariants::SeenStates()});
  finder.Find(RestMs() / 3);
  invariants_ = finder.invariants();
}

}  // namespace plcxx::prove::properties
