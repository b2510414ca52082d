#include "transpiler/prove/properties/check.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/properties/computed_runs.h"
#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/counting.h"
#include "transpiler/prove/properties/stuck.h"
#include "transpiler/prove/properties/window_check.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

/// Of the time: a tenth and a third of what is left for many runs.
constexpr uint32_t kSearchShare = 10, kThoroughShare = 3;
constexpr uint32_t kFirstInductionShare = 8, kInductionShare = 2;
constexpr uint32_t kMostQuickMs = 1500;
constexpr uint32_t kMostQuickWindow = 20;
constexpr std::chrono::seconds kRemarkTime{5};
constexpr uint32_t kWholeShare = 2;                       // of the time, for the slow part in one piece
constexpr std::chrono::milliseconds kDeepenedTime{1500};  // before runs are tried for long

/// Whether a violated property speaks of an output that no statement writes: the run sets it like an input.
std::string RemarkOnOutputs(const CheckedProgram& checked, const Property& property) {
  const machine::Uses uses = machine::UsesOf(checked.version);
  for (const PropertyOperand& operand : property.operands) {
    const bool is_set = std::ranges::all_of(operand.cells, [&](execute::CellId cell) {
      return checked.inputs[cell.index] && !uses.writes[cell.index] &&
             machine::DirectionOf(checked.version, cell) == ir::Direction::kOutput;
    });
    if (is_set) return "the program does not write '" + operand.text + "': anybody may set it";
  }
  return {};
}

}  // namespace

PropertyResult PropertyChecker::Check(const Property& property, uint64_t milliseconds) {
  const CheckOptions& options = checked_.options;
  checked_.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  trials_.Begin();
  PropertyResult result;
  const auto check = [&] { return CheckInTime(property); };
  const bool in_slices = options.check_in_slices != nullptr;
  if (!in_slices) {
    result = check();
  } else if (property.kind != PropertyKind::kNeverStuck) {
    result = Within(checked_.RestMs() / kWholeShare, checked_, check);
  }
  if (result.verdict == PropertyVerdict::kViolated) trials_.PreferPlanted(property, result);
  // The time may end between two steps.
  if (result.verdict == PropertyVerdict::kUndecided && result.reason.empty()) result.reason = kNoTime;
  if (result.verdict != PropertyVerdict::kViolated && in_slices) CheckInSlices(property, result);
  if (result.verdict == PropertyVerdict::kProved) result.remark = RemarkOn(property);
  if (result.verdict == PropertyVerdict::kViolated) result.remark = RemarkOnOutputs(checked_, property);
  return result;
}

void PropertyChecker::CheckInSlices(const Property& property, PropertyResult& result) {
  const CheckOptions& options = checked_.options;
  checked_.Report("slice by slice");
  PropertyResult in_slices = options.check_in_slices(property, std::max(1U, checked_.RestMs()));
  const bool was_proved = result.verdict == PropertyVerdict::kProved;
  if (in_slices.verdict != PropertyVerdict::kUndecided) {
    result = std::move(in_slices);
  } else if (was_proved || property.kind == PropertyKind::kNeverStuck) {
    const std::string reason = was_proved ? "proved only where no input changes between the " +
                                                std::to_string(options.slices) +
                                                " slices of a slow pass; with inputs that do, "
                                          : std::string();
    result = std::move(in_slices);
    result.reason = reason + result.reason;
  }
}

std::string PropertyChecker::RemarkOn(const Property& property) {
  const machine::Uses uses = machine::UsesOf(checked_.version);
  for (const PropertyOperand& operand : property.operands) {
    const bool changes = std::ranges::any_of(
        operand.cells, [&](execute::CellId cell) { return checked_.inputs[cell.index] || uses.writes[cell.index]; });
    if (!changes) return "nothing writes '" + operand.text + "'";
  }
  if (property.kind != PropertyKind::kResponse) return {};
  // The case comes when it can be shown that it does not stay away.
  Property never = property;
  never.kind = PropertyKind::kAlways;
  never.conditions.push_back({.kind = ConditionKind::kNot, .children = {property.condition}});
  never.condition = static_cast<uint32_t>(never.conditions.size() - 1);
  checked_.deadline = std::min(checked_.deadline, std::chrono::steady_clock::now() + kRemarkTime);
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
  invariants_.Clear();
  trials_.BeginSearch();
  if (property.kind == PropertyKind::kNeverStuck) return CheckNeverStuck(checked_, invariants_, trials_, property);
  PropertyResult result;
  // Most of what holds is proved in less time than many runs would take.
  if (trials_.Try(property, std::min(kMostFirstMs, checked_.RestMs() / kQuickShare), false, result)) return result;
  const uint32_t window = WindowOf(property);
  bool tried_runs = false, looked_for_invariants = false;
  const auto try_runs = [&] {
    if (std::exchange(tried_runs, true)) return false;
    return trials_.TryWide(property, checked_.RestMs() / kThoroughShare / 2, result) ||
           trials_.Try(property, checked_.RestMs() / kThoroughShare / 2, true, result);
  };
  const auto try_quickly = [&] {
    const auto time = [this] { return std::min(kMostQuickMs, checked_.RestMs() / kSearchShare) / 2; };
    return trials_.TryWide(property, time(), result) || trials_.Try(property, time(), true, result);
  };
  const auto search_runs = [&](uint32_t period) {
    if (!SearchRuns(checked_, trials_, property, period, result)) return false;
    // A run that the machine does not show says nothing of others.
    if (result.verdict == PropertyVerdict::kUndecided) try_runs();
    return true;
  };
  if (window > kMostQuickWindow) {
    // A long wait is found sooner by waiting, if it is found at all; what holds is counted.
    if (try_quickly()) return result;
    const auto count = [&] { return TryCounting(checked_, invariants_, property, result); };
    const uint32_t counting_ms = checked_.RestMs() - checked_.RestMs() / kThoroughShare;
    if (!checked_.options.only_runs && Within(counting_ms, checked_, count)) return result;
    if (try_runs()) return result;
  }
  // After `window` - 1 periods the induction looks at whole windows.
  for (uint32_t period = 1; period <= window; ++period) {
    if (search_runs(period)) return result;
  }
  auto deepened_end = std::chrono::steady_clock::time_point::max();
  for (uint32_t k = 1; window + k <= checked_.options.most_periods || k == 1; ++k) {
    if (k == 2) deepened_end = std::chrono::steady_clock::now() + kDeepenedTime;
    if (!checked_.options.only_runs && TryInduction(property, k, result)) return result;
    if (!checked_.options.only_runs && !looked_for_invariants && !checked_.Late()) {
      looked_for_invariants = true;
      if (trials_.TryWide(property, std::min(kMostFirstMs, checked_.RestMs() / kQuickShare), result)) return result;
      invariants_.FindFor(property);
      if (!invariants_.found().empty() && TryInduction(property, k, result)) return result;
      // Few facts are found at once; a violation that is not far away is found sooner than many.
      if (TryReachableFor(std::min(kMostQuickMs, checked_.RestMs() / kQuickShare), checked_, invariants_, property,
                          result))
        return result;
      if (try_quickly()) return result;
      if (TryReachable(checked_, invariants_, property, result)) return result;
    }
    // As long as they cost little, more periods hit what takes luck in a run.
    if (k > 1 && std::chrono::steady_clock::now() > deepened_end && try_runs()) return result;
    if (search_runs(window + k)) return result;
  }
  if (try_runs()) return result;
  result.reason = "no run of " + Periods(result.searched) + " from power-on violates it, and " +
                  std::to_string(checked_.options.most_periods) + " periods are not enough to prove it";
  return result;
}

/// From any state: `k` periods that do not violate it, in all of which the property sees a whole window, then one more.
/// The state that it begins with stands after the first of them.
bool PropertyChecker::TryInduction(const Property& property, uint32_t k, PropertyResult& result) {
  const uint32_t window = WindowOf(property);
  checked_.Report("induction over " + Periods(k));
  if (Extend(checked_, *checked_.anywhere, window + k - 1, result)) return true;
  std::vector<terms::TermId> conditions =
      invariants_.ConditionsOf([this](execute::CellId cell) { return checked_.anywhere->Value(cell, 0); });
  const ValueAfter value = [this](execute::CellId cell, uint32_t period) {
    return checked_.anywhere->Value(cell, period - 1);
  };
  for (uint32_t period = window; period < window + k; ++period)
    conditions.push_back(HoldsAfter(checked_.terms, property, period, value));
  conditions.push_back(checked_.terms.Not(HoldsAfter(checked_.terms, property, window + k, value)));
  // From a state that cannot be reached much may happen: the first answer need not be waited for.
  const uint32_t share = k == 1 && invariants_.found().empty() ? kFirstInductionShare : kInductionShare;
  switch (Ask(checked_, conditions, checked_.RestMs() / share)) {
    case solver::Answer::kPossible:
      return false;
    case solver::Answer::kUnknown:
      result.reason = WhyUnknown(checked_);
      return checked_.Late();
    case solver::Answer::kNever:
      break;
  }
  result.verdict = PropertyVerdict::kProved;
  result.periods = k;
  result.invariants = static_cast<uint32_t>(invariants_.found().size());
  result.reason.clear();
  return true;
}

}  // namespace plcxx::prove::properties
