#include "transpiler/review/diff/run_searches.h"

#include <algorithm>
#include <utility>

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::Effort;
using prove::diff::Sought;
using std::chrono::steady_clock;

// Of the comparison's time.
constexpr uint64_t kScenariosShare = 5, kQuickSearchShare = 40, kQuickWideShare = 10, kSearchShare = 6, kKeptShare = 60;

}  // namespace

prove::diff::SimulatedRuns RunSearches::Answers() {
  return {.find_different = [this](const Sought& sought, Effort effort,
                                   uint64_t most_ms) { return FindDifferent(sought, effort, most_ms); },
          .is_sought = [this](CellId old_cell) { return IsSought(old_cell); },
          .for_each_seen_state =
              [this](prove::diff::Which which, const auto& visit) {
                if (search_) search_->ForEachSeenState(which, visit);
              },
          .for_each_seen_pair =
              [this](const auto& visit) {
                if (search_) search_->ForEachSeenPair(visit);
              }};
}

/// Of a word that differs the other bits are not looked for any longer.
bool RunSearches::IsSought(CellId old_cell) const {
  const auto is_seen = [this](CellId cell) { return IsSeen(cell); };
  return !is_seen(old_cell) && std::ranges::none_of(old_.words.WordOf(old_cell).cells, is_seen);
}

std::vector<CellId> RunSearches::Open(const Sought& sought) const {
  std::vector<CellId> cells = sought.open;
  std::erase_if(cells, [this](CellId cell) { return !IsSought(cell); });
  return cells;
}

RunSearches::Time RunSearches::EndOfShare(uint64_t share) const {
  return std::min(end_, steady_clock::now() + std::chrono::milliseconds(options_.time_ms / share));
}

/// What a change leads to may show at a limit that was there before.
uint64_t RunSearches::ShareForCounts() const {
  return search_->has_changed_constants() || !runs_.difference_of.empty() ? kSearchShare : 4 * kSearchShare;
}

bool RunSearches::IsWorthExecuting() const { return end_ - steady_clock::now() > (steady_clock::now() - begin_) / 4; }

RunRequest RunSearches::RequestOf(const std::vector<CellId>& cells, Effort effort, Time end) const {
  return {.old_version = old_.version,
          .new_version = new_.version,
          .match = match_,
          .cells = cells,
          .effort = effort,
          .end = end,
          .round = round_};
}

void RunSearches::RunRandom(const std::vector<CellId>& cells, Effort effort, Time end) {
  if (!cells.empty()) RunBoth(old_.side, new_.side, RequestOf(cells, effort, end), options_, runs_);
}

void RunSearches::RunWaiting(const std::vector<CellId>& cells, Time end) {
  RunRequest request = RequestOf(cells, Effort::kThorough, end);
  request.waits_only = true;
  if (!cells.empty()) RunBoth(old_.side, new_.side, request, options_, runs_);
}

void RunSearches::RunWide(const Sought& sought, Time end) {
  if (!IsWorthExecuting()) return;
  search_->RunWideFromMoments(Open(sought), steady_clock::now() + (end - steady_clock::now()) / 2, runs_);
  search_->RunWide(Open(sought), end, runs_);
}

void RunSearches::TakeTurn(Way way, const Sought& sought, Time end) {
  const Time begin = steady_clock::now();
  const size_t before = runs_.difference_of.size();
  switch (way) {
    case Way::kWide:
      RunWide(sought, end);
      break;
    case Way::kAtWork:
      search_->Run(Open(sought), end, runs_);
      break;
  }
  turns_.Took(way, steady_clock::now() - begin, runs_.difference_of.size() - before);
}

void RunSearches::SearchQuickly(const Sought& sought) {
  RunRandom(sought.all, Effort::kQuick, end_);
  if (IsWorthExecuting()) search_->RunWideFromMoments(Open(sought), EndOfShare(kQuickWideShare), runs_);
  search_->Run(Open(sought), EndOfShare(kQuickSearchShare), runs_);
}

void RunSearches::SearchThoroughly(const Sought& sought) {
  if (search_->has_changed_constants()) search_->RunCounts(Open(sought), EndOfShare(kSearchShare), runs_);
  RunWaiting(Open(sought), EndOfShare(kSearchShare));
  ++round_;
  search_->Follow(sought.runs, EndOfShare(kSearchShare), runs_);
  TakeTurn(Way::kWide, sought, EndOfShare(IsMuchOpen(sought) ? 2 * kSearchShare : kSearchShare));
  TakeTurn(Way::kAtWork, sought, EndOfShare(IsMuchOpen(sought) ? 2 * kSearchShare : kSearchShare));
  search_->RunCounts(Open(sought), EndOfShare(ShareForCounts()), runs_);
  if (!Open(sought).empty() && !IsMuchOpen(sought)) search_->BeginWithKept(EndOfShare(kKeptShare), runs_);
  RunRandom(Open(sought), Effort::kThorough, end_);
}

void RunSearches::SearchLasting(const Sought& sought, uint64_t most_ms) {
  search_->Follow(sought.runs, end_, runs_);
  ++round_;
  const Time lasting_end = std::min(end_, steady_clock::now() + std::chrono::milliseconds(most_ms));
  if (IsMuchOpen(sought)) {
    TakeTurn(turns_.Next(), sought, lasting_end);
    return;
  }
  if (!Open(sought).empty()) search_->BeginWithKept(EndOfShare(kKeptShare), runs_);
  const auto counts_ms = std::chrono::milliseconds(most_ms / (ShareForCounts() / kSearchShare * 3));
  search_->RunCounts(Open(sought), std::min(end_, steady_clock::now() + counts_ms), runs_);
  // By turns: many runs at once, what begins with a machine at work, and what waits long or counts from power-on.
  TakeTurn(Way::kWide, sought, lasting_end - std::chrono::milliseconds(most_ms / 2));
  TakeTurn(Way::kAtWork, sought, steady_clock::now() + (lasting_end - steady_clock::now()) / 2);
  RunRandom(Open(sought), Effort::kLasting, lasting_end);
}

std::vector<CellId> RunSearches::FindDifferent(const Sought& sought, Effort effort, uint64_t most_ms) {
  // Too late to begin with anything.
  if (!search_ && steady_clock::now() >= end_) return {};
  if (!search_) {
    search_.emplace(old_.side, new_.side, old_.version, new_.version, match_, old_.words, sought.all);
  }
  switch (effort) {
    case Effort::kScenarios:
      if (!std::exchange(scenarios_are_run_, true)) search_->RunScenarios(EndOfShare(kScenariosShare), runs_);
      break;
    case Effort::kQuick:
      SearchQuickly(sought);
      break;
    case Effort::kThorough:
      SearchThoroughly(sought);
      break;
    case Effort::kLasting:
      SearchLasting(sought, most_ms);
      break;
  }
  std::vector<CellId> different;
  for (const auto& [cell, difference] : runs_.difference_of) different.push_back(cell);
  return different;
}

}  // namespace plcxx::review::diff
