// Runs in many lanes that begin with two versions at work.
#include <algorithm>
#include <map>

#include "transpiler/prove/diff/wide_runs.h"

namespace plcxx::prove::diff {
namespace {

constexpr uint32_t kOfWord = 64;
constexpr size_t kMostNear = 128;
constexpr uint32_t kMomentPeriods = 5;  // that one input is held: a filter and an edge are through
constexpr uint32_t kSeveralPeriods = 24, kSeveralEvery = 6;
constexpr size_t kMostRepeated = 16;  // runs of an episode: what the control forbids is told again and again

}  // namespace

std::vector<uint32_t> WideRuns::InputsNear(std::vector<execute::CellId> read) const {
  std::vector<uint32_t> near;
  std::vector<bool> has_cell(versions_.old_version.cells.count), has_term(terms_.size());
  for (const execute::CellId cell : read) has_cell[cell.index] = true;
  std::vector<terms::TermId> open;
  const auto add = [&open](terms::TermId term) { open.push_back(term); };
  // Cell by cell, and of each what is near its root first.
  for (size_t next = 0; next < read.size() && near.size() < kMostNear; ++next) {
    if (const std::optional<uint32_t> number = NumberOf(read[next])) near.push_back(*number);
    open.clear();
    old_relation_->ForEachNext(read[next], add);
    if (const execute::CellId new_cell = versions_.match.new_of_old[read[next].index]; new_cell.valid())
      new_relation_->ForEachNext(new_cell, add);
    for (size_t at = 0; at < open.size(); ++at) {
      const terms::TermId id = open[at];
      if (has_term[id.index]) continue;
      has_term[id.index] = true;
      if (terms_[id].kind != terms::TermKind::kVariable) {
        terms_.ForEachOperand(terms_[id], add);
        continue;
      }
      execute::CellId cell = old_relation_->CellOf(id);
      if (!cell.valid()) {
        const execute::CellId of_new = new_relation_->CellOf(id);
        cell = of_new.valid() ? versions_.match.old_of_new[of_new.index] : execute::CellId();
      }
      if (!cell.valid() || has_cell[cell.index]) continue;
      has_cell[cell.index] = true;
      read.push_back(cell);
    }
  }
  return near;
}

void WideRuns::BeginAt(uint32_t word, const SeenState& state) {
  old_machine_->Load(word, [&state](execute::CellId cell) { return state.value(Which::kOld, cell); });
  new_machine_->Load(word, [&state](execute::CellId cell) { return state.value(Which::kNew, cell); });
  now_ms_[word] = state.now_ms;
  Begin& begin = begins_[word];
  begin.levels.clear();
  for (const wide::WideInputs::Input& input : inputs_->inputs())
    begin.levels.push_back(static_cast<uint8_t>(state.value(Which::kOld, input.cell)));
}

std::vector<wide::WideSet> WideRuns::Opposites(const std::vector<uint32_t>& near, WideStarts::Changes changes) {
  std::map<uint32_t, terms::Plane> lanes;  // by number of the input
  for (uint32_t lane = 0; lane < kLanes; ++lane) {
    const uint32_t first = begins_[lane / kOfWord].first_near + lane % kOfWord;
    if (changes == WideStarts::Changes::kOneByOne && first < near.size()) {
      lanes[near[first]].Set(lane, true);
      continue;
    }
    for (uint64_t i = (random_.Next() >> 20) % 4 + 1; i > 0; --i) {
      // Those in front matter more.
      const uint64_t below = 1 + (random_.Next() >> 20) % near.size();
      lanes[near[(random_.Next() >> 20) % below]].Set(lane, true);
    }
  }
  std::vector<wide::WideSet> sets;
  for (const auto& [number, where] : lanes) {
    const execute::CellId old_cell = inputs_->inputs()[number].cell;
    const bool has_old = old_machine_->Has(old_cell);
    const wide::WideMachine& machine = has_old ? *old_machine_ : *new_machine_;
    const execute::CellId cell = has_old ? old_cell : versions_.match.new_of_old[old_cell.index];
    if (!machine.Has(cell)) continue;
    sets.push_back({.input = number, .where = where, .value = ~machine.Planes(cell)[0]});
  }
  return sets;
}

void WideRuns::EpisodeFrom(const std::vector<uint32_t>& near, WideStarts::Changes changes, std::vector<uint32_t>& open,
                           Time end, std::vector<Seen>& seen) {
  const bool is_one_by_one = changes == WideStarts::Changes::kOneByOne;
  const uint32_t periods = is_one_by_one ? kMomentPeriods : kSeveralPeriods;
  for (uint32_t i = 0; i < periods && !open.empty() && std::chrono::steady_clock::now() < end; ++i) {
    wide::Period period;
    if (i % kSeveralEvery == 0) {
      if (i != 0) Select(open, seen, period);
      period.sets = Opposites(near, changes);
      if (!is_one_by_one) period.done = wide::DrawDone(requests_, random_);
    }
    Advance(period);
    history_.push_back(std::move(period));
    Compare(open, seen);
  }
}

void WideRuns::SearchFrom(const WideStarts& starts, const std::vector<execute::CellId>& sought, Time end,
                          const std::function<bool(execute::CellId)>& is_open,
                          const std::function<void(const Run&, size_t start)>& found) {
  if (!is_ready() || starts.count == 0) return;
  const std::vector<uint32_t> near = InputsNear(starts.read);
  if (near.empty()) return;
  // Of each start as many words as its inputs need; of all starts those in front come first.
  const size_t words = starts.changes == WideStarts::Changes::kOneByOne ? (near.size() + kOfWord - 1) / kOfWord : 1;
  for (size_t next = 0; next < words * starts.count && std::chrono::steady_clock::now() < end;) {
    std::vector<uint32_t> open = OpenPairs(sought, is_open);
    if (open.empty()) return;
    PowerOn();
    begins_.resize(kWords);
    for (uint32_t word = 0; word < kWords; ++word, ++next) {
      const size_t which = next % (words * starts.count);
      begins_[word].start = which % starts.count;
      begins_[word].first_near = static_cast<uint32_t>(which / starts.count * kOfWord);
      starts.visit(begins_[word].start, [&](const SeenState& state) { BeginAt(word, state); });
    }
    std::vector<Seen> seen;
    // Locations that differ at a start were told then.
    Compare(open, seen);
    seen.clear();
    EpisodeFrom(near, starts.changes, open, end, seen);
    size_t repeated = 0;
    for (const std::vector<uint32_t>& path : Cover(seen)) {
      if (++repeated > kMostRepeated || std::chrono::steady_clock::now() >= end) break;
      found(RunOf(path), begins_[path.front() / kOfWord].start);
    }
  }
}

}  // namespace plcxx::prove::diff
