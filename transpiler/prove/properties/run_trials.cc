#include "transpiler/prove/properties/run_trials.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/properties/cone.h"
#include "transpiler/prove/properties/numbers.h"

namespace plcxx::prove::properties {
namespace {

constexpr uint32_t kMostPlantedMs = 2000;  // after a violation without the plant
constexpr uint32_t kMostNotRepeated = 3;   // what the control does by itself, it does in the next runs, too

}  // namespace

void RunTrials::BeginSearch() {
  wide_.reset();
  not_repeated_ = 0;
}

invariants::SeenStates RunTrials::SeenStates() const {
  if (!wide_) return {};
  return
      [this](const std::function<void(const invariants::CellValues&, uint64_t)>& visit) { wide_->ForEachState(visit); };
}

void RunTrials::AddInputsBehind(const std::vector<execute::CellId>& cells, RunSearch& search) {
  const auto add = [](execute::CellId cell, std::vector<execute::CellId>& to) {
    if (std::ranges::find(to, cell) == to.end()) to.push_back(cell);
  };
  // Where the host may answer anything, inputs that it writes within a period are answers, too: no cells.
  for (const execute::CellId cell : CellsBehind(checked_.terms, *checked_.silent, cells)) {
    if (checked_.inputs[cell.index]) add(cell, search.inputs);
    if (checked_.requests[cell.index]) add(cell, search.requests);
  }
}

bool RunTrials::Try(const Property& property, uint64_t milliseconds, bool thorough, PropertyResult& result) {
  if (!checked_.options.try_runs || checked_.options.retentive == RetentiveMemory::kAny || checked_.Late())
    return false;
  checked_.Report(thorough ? "trying runs" : "trying a few runs");
  RunSearch search{
      .property = &property, .inputs = {}, .requests = {}, .milliseconds = milliseconds, .thorough = thorough};
  if (checked_.options.planted.try_runs) {
    search.milliseconds /= 2;
    if (TryPlanted(property, search, result)) return true;
  }
  AddInputsBehind(OperandCellsOf(property), search);
  return TryFound(property, checked_.options.try_runs(search), result);
}

bool RunTrials::TryWide(const Property& property, uint64_t milliseconds, PropertyResult& result) {
  if (!checked_.options.try_runs || checked_.options.retentive == RetentiveMemory::kAny || checked_.Late())
    return false;
  checked_.Report("trying runs side by side");
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  RunSearch search{.property = &property, .inputs = {}, .requests = {}, .milliseconds = milliseconds};
  AddInputsBehind(OperandCellsOf(property), search);
  if (!wide_) {
    const std::vector<execute::CellId> behind = CellsBehind(checked_.terms, *checked_.silent, OperandCellsOf(property));
    wide_ = std::make_unique<WideSearch>(checked_.terms, *checked_.silent, search, NumbersAmong(checked_, behind), end);
  }
  search.only_similar = true;
  while (not_repeated_ < kMostNotRepeated) {
    const std::optional<PropertyRun> run = wide_->Find(end);
    if (!run) return false;
    search.similar = &*run;
    search.milliseconds = std::max<uint64_t>(kMostFirstMs, checked_.RestMs() / kQuickShare);
    if (TryFound(property, checked_.options.try_runs(search), result)) return true;
    ++not_repeated_;
  }
  return false;
}

bool RunTrials::TryPlanted(const Property& property, RunSearch search, PropertyResult& result) {
  AddInputsBehind(OperandCellsOf(property), search);
  // What moves the plant moves the inputs that it drives.
  AddInputsBehind(checked_.options.planted.reads, search);
  return TryFound(property, checked_.options.planted.try_runs(search), result);
}

bool RunTrials::TryFound(const Property& property, std::optional<PropertyRun> run, PropertyResult& result) {
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

void RunTrials::PreferPlanted(const Property& property, PropertyResult& result) {
  if (!checked_.options.planted.try_runs || property.kind == PropertyKind::kNeverStuck) return;
  if (checked_.options.retentive == RetentiveMemory::kAny || !result.run || result.run->has_plant || checked_.Late())
    return;
  checked_.Report("trying runs with the plant");
  // A copy, for what is found is written into the result.
  const PropertyRun similar = *result.run;
  TryPlanted(property,
             {.property = &property,
              .inputs = {},
              .requests = {},
              .milliseconds = std::min(kMostPlantedMs, checked_.RestMs()),
              .thorough = true,
              .similar = &similar},
             result);
}

void RunTrials::Conclude(const Property& property, PropertyResult found, terms::TermId violated,
                         PropertyResult& result) {
  found.verdict = PropertyVerdict::kViolated;
  found.searched = result.searched;
  found.replay = replays_;
  const std::string why_not =
      checked_.options.why_not_shown ? checked_.options.why_not_shown(property, found) : std::string();
  if (checked_.options.why_not_shown) ++replays_;
  if (!why_not.empty()) {
    found.verdict = PropertyVerdict::kUndecided;
    found.reason = violated.valid() && machine::DependsOnLoop(checked_.terms, violated)
                       ? "it depends on a loop of which it is not known how often it goes round: a run of " +
                             Periods(found.periods) + " might violate it, but " + why_not
                       : "a run of " + Periods(found.periods) + " violates it, but " + why_not;
  }
  result = std::move(found);
}

}  // namespace plcxx::prove::properties
