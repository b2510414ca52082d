#include "transpiler/prove/diff/wide_runs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace plcxx::prove::diff {
namespace {

constexpr uint32_t kMostToldInVain = 3;
constexpr uint32_t kNewsPeriods = 4;
constexpr size_t kMostSources = 24, kMostTermsOfSources = 400;

/// Whether it has another value after a part than before it, perhaps.
bool IsComputed(const machine::Relation& relation, execute::CellId cell) {
  bool is_computed = false;
  relation.ForEachNext(cell, [&](terms::TermId) { is_computed = true; });
  return is_computed;
}

}  // namespace

WideRuns::~WideRuns() = default;

WideRuns::WideRuns(UnrolledVersions versions, const std::vector<execute::CellId>& sought, Time end)
    : versions_(std::move(versions)) {
  const auto is_late = [end] { return std::chrono::steady_clock::now() >= end; };
  const machine::Transition old_init = wide::PowerOnAlone(terms_, versions_.old_version, is_late),
                            new_init = wide::PowerOnAlone(terms_, versions_.new_version, is_late);
  if (!old_init.refusal.empty() || !new_init.refusal.empty()) return;
  const auto relation = [&](const machine::Version& version) {
    return std::make_unique<machine::Relation>(terms_, version, machine::HostAnswers::kNothing);
  };
  old_relation_ = relation(versions_.old_version);
  if (!old_relation_->refusal().empty()) return;
  new_relation_ = relation(versions_.new_version);
  if (!new_relation_->refusal().empty()) return;
  std::vector<execute::CellId> old_wanted, new_wanted;
  for (const execute::CellId cell : sought) {
    if (cell.index >= versions_.old_version.cells.calls) continue;
    old_wanted.push_back(cell);
    new_wanted.push_back(versions_.match.new_of_old[cell.index]);
  }
  const std::vector<execute::CellId> old_cells = wide::DependedOn(terms_, *old_relation_, old_wanted),
                                     new_cells = wide::DependedOn(terms_, *new_relation_, new_wanted);
  const auto without_calls = [](std::vector<execute::CellId> cells, const machine::Version& version) {
    std::erase_if(cells, [&](execute::CellId cell) { return cell.index >= version.cells.calls; });
    return cells;
  };
  old_machine_.emplace(terms_, *old_relation_, old_cells, old_init);
  new_machine_.emplace(terms_, *new_relation_, new_cells, new_init);
  std::vector<bool> may_be_set(versions_.old_version.cells.count);
  for (const execute::CellId cell : without_calls(old_cells, versions_.old_version)) may_be_set[cell.index] = true;
  for (const execute::CellId cell : without_calls(new_cells, versions_.new_version)) {
    const execute::CellId old_cell = versions_.match.old_of_new[cell.index];
    if (old_cell.valid()) may_be_set[old_cell.index] = true;
  }
  std::vector<execute::CellId> settable;
  for (uint32_t i = 0; i < may_be_set.size(); ++i) {
    if (may_be_set[i]) settable.emplace_back(i);
  }
  if (is_late()) return;
  FindPairs(settable);
  FindSources();
  for (const execute::CellId request : versions_.requests) {
    if (may_be_set[request.index]) requests_.push_back(request);
  }
  FindInputs(settable);
}

void WideRuns::FindInputs(const std::vector<execute::CellId>& settable) {
  const std::vector<bool> old_read = wide::ReadCells(terms_, *old_relation_),
                          new_read = wide::ReadCells(terms_, *new_relation_);
  std::vector<wide::WideInputs::Input> inputs;
  wide::Reader by_old{.relation = *old_relation_, .numbers = {}}, by_new{.relation = *new_relation_, .numbers = {}};
  for (const execute::CellId old_cell : settable) {
    const execute::CellId new_cell = versions_.match.new_of_old[old_cell.index];
    // Nothing follows from the others, and there are thousands of them.
    if (!old_read[old_cell.index] && !(new_cell.valid() && new_read[new_cell.index])) continue;
    if (versions_.match.starts_otherwise[old_cell.index]) continue;
    if (!IsInputPair(versions_.old_version, versions_.new_version, versions_.old_uses, versions_.new_uses,
                     versions_.match, old_cell))
      continue;
    const auto number = static_cast<uint32_t>(inputs.size());
    input_of_[old_cell] = by_old.numbers[old_cell.index] = number;
    if (new_cell.valid()) by_new.numbers[new_cell.index] = number;
    inputs.push_back({.cell = old_cell,
                      .is_machines = machine::DirectionOf(versions_.old_version, old_cell) == ir::Direction::kInput});
  }
  inputs_.emplace(terms_, std::move(inputs), std::array{std::move(by_old), std::move(by_new)});
}

std::optional<uint32_t> WideRuns::NumberOf(execute::CellId old_cell) const {
  const auto at = input_of_.find(old_cell);
  return at == input_of_.end() ? std::nullopt : std::optional(at->second);
}

void WideRuns::FindPairs(const std::vector<execute::CellId>& cells) {
  for (const execute::CellId old_cell : cells) {
    const execute::CellId new_cell = versions_.match.new_of_old[old_cell.index];
    if (!old_machine_->Has(old_cell) || !new_machine_->Has(new_cell)) continue;
    // What is set alike and never computed does not differ.
    const bool begins_alike =
        std::ranges::equal(std::as_const(*old_machine_).Planes(old_cell), std::as_const(*new_machine_).Planes(new_cell),
                           [](const terms::Plane& one, const terms::Plane& other) { return one.words == other.words; });
    if (begins_alike && !IsComputed(*old_relation_, old_cell) && !IsComputed(*new_relation_, new_cell)) continue;
    pair_of_[old_cell] = static_cast<uint32_t>(pairs_.size());
    pairs_.push_back({.old_cell = old_cell, .new_cell = new_cell, .sources = {}});
  }
  differences_.resize(pairs_.size());
}

/// From a few terms on a location is computed from everything.
void WideRuns::FindSources() {
  std::vector<uint32_t> visit_of(terms_.size());
  uint32_t visit = 0;
  for (Pair& pair : pairs_) {
    ++visit;
    size_t visited = 0;
    std::vector<terms::TermId> open;
    const auto add = [&open](terms::TermId term) { open.push_back(term); };
    old_relation_->ForEachNext(pair.old_cell, add);
    new_relation_->ForEachNext(pair.new_cell, add);
    // Breadth first: what is near counts.
    for (size_t at = 0; at < open.size() && visited < kMostTermsOfSources && pair.sources.size() < kMostSources; ++at) {
      const terms::TermId id = open[at];
      if (visit_of[id.index] == visit) continue;
      visit_of[id.index] = visit;
      ++visited;
      if (terms_[id].kind != terms::TermKind::kVariable) {
        terms_.ForEachOperand(terms_[id], [&](terms::TermId operand) { open.push_back(operand); });
        continue;
      }
      execute::CellId source = old_relation_->CellOf(id);
      if (!source.valid()) {
        const execute::CellId of_new = new_relation_->CellOf(id);
        source = of_new.valid() ? versions_.match.old_of_new[of_new.index] : execute::CellId();
      }
      const auto number = source.valid() && source != pair.old_cell ? pair_of_.find(source) : pair_of_.end();
      if (number != pair_of_.end() && std::ranges::find(pair.sources, number->second) == pair.sources.end())
        pair.sources.push_back(number->second);
    }
  }
}

uint32_t WideRuns::period_ms() const {
  const ir::Schedule& schedule = versions_.old_version.program->schedule;
  return std::max({1U, schedule.period_ms, schedule.fast_every_ms});
}

void WideRuns::PowerOn() {
  old_machine_->PowerOn();
  new_machine_->PowerOn();
  history_.clear();
  begins_.clear();
  now_ms_ = {};
}

void WideRuns::Advance(const wide::Period& period) {
  const auto store = [this](execute::CellId old_cell, const terms::Plane& where, const terms::Plane& value) {
    old_machine_->Store(old_cell, where, value);
    new_machine_->Store(versions_.match.new_of_old[old_cell.index], where, value);
  };
  for (const wide::WideSet& set : period.sets) store(inputs_->inputs()[set.input].cell, set.where, set.value);
  for (const auto& [request, where] : period.done) store(request, where, terms::Plane());
  for (wide::WideMachine* const machine : {&*old_machine_, &*new_machine_}) machine->RunPeriod(now_ms_, period_ms());
  for (uint64_t& now : now_ms_) now += period_ms();
}

void WideRuns::Compare(std::vector<uint32_t>& open, std::vector<Seen>& seen) {
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const std::span<const terms::Plane> one = std::as_const(*old_machine_).Planes(pairs_[i].old_cell),
                                        other = std::as_const(*new_machine_).Planes(pairs_[i].new_cell);
    terms::Plane differ;
    for (size_t bit = 0; bit < std::min(one.size(), other.size()); ++bit) differ = differ | (one[bit] ^ other[bit]);
    differences_[i] = differ;
  }
  const auto period = static_cast<uint32_t>(history_.size());
  std::erase_if(open, [&](uint32_t pair) {
    if (differences_[pair].IsZero()) return false;
    seen.push_back({pairs_[pair].old_cell, period, differences_[pair]});
    return true;
  });
}

void WideRuns::Select(const std::vector<uint32_t>& open, const std::vector<Seen>& seen, wide::Period& period) {
  wide::Scores scores{};
  for (const uint32_t pair : open) {
    terms::Plane near;
    for (const uint32_t source : pairs_[pair].sources) near = near | differences_[source];
    wide::AddScore(near, 1, scores);
  }
  // Where something was seen for the first time a moment ago, more follows.
  for (size_t i = seen.size(); i > 0 && seen[i - 1].period + kNewsPeriods > history_.size(); --i)
    wide::AddScore(seen[i - 1].lanes, 1, scores);
  period.copy_of = wide::DrawCopies(scores, random_);
  // Not one after the other: one may be copied from a word that another one is copied to.
  for (wide::WideMachine* const machine : {&*old_machine_, &*new_machine_}) machine->Spread(period.copy_of);
  wide::SpreadTimes(now_ms_, period.copy_of);
  for (uint32_t word = 0; word < kWords; ++word) {
    if (random_.OneIn(4)) inputs_->ChangeHabits(word);
  }
}

void WideRuns::Episode(std::vector<uint32_t>& open, Time end, std::vector<Seen>& seen) {
  constexpr std::array<uint32_t, 5> kPeriods = {24, 60, 150, 60, 300}, kSelectEvery = {3, 2, 4, 8, 12};
  const uint32_t periods = kPeriods[episodes_ % kPeriods.size()],
                 every = kSelectEvery[episodes_ / 2 % kSelectEvery.size()];
  ++episodes_;
  PowerOn();
  inputs_->Begin();
  for (uint32_t i = 0; i < periods && !open.empty() && std::chrono::steady_clock::now() < end; ++i) {
    wide::Period period;
    if (i != 0 && i % every == 0) Select(open, seen, period);
    period.sets = inputs_->Next(i == 0);
    period.done = wide::DrawDone(requests_, random_);
    Advance(period);
    history_.push_back(std::move(period));
    Compare(open, seen);
  }
}

/// What an input is before a run; no value of a cell where nobody knows.
uint64_t WideRuns::LevelAtBegin(execute::CellId cell, uint32_t lane) const {
  if (begins_.empty()) return uint64_t{machine::PowerOnValue(versions_.old_version, cell)};
  const std::optional<uint32_t> number = NumberOf(cell);
  return number ? uint64_t{begins_[lane / 64].levels[*number]} : ~uint64_t{0};
}

Run WideRuns::RunOf(const std::vector<uint32_t>& path) const {
  Run run;
  std::map<execute::CellId, uint64_t> level;
  for (uint32_t i = 0; i < path.size(); ++i) {
    std::map<execute::CellId, SetCell> sets;
    wide::ForEachSet(history_[i], *inputs_, path[i], [&](execute::CellId cell, bool value) {
      sets[cell] = {.old_cell = cell, .new_cell = versions_.match.new_of_old[cell.index], .value = uint64_t{value}};
    });
    std::vector<SetCell>& set = run.periods.emplace_back();
    for (const auto& [cell, one] : sets) {
      // What a version writes has another value there, perhaps.
      const bool is_kept = !versions_.old_uses.writes[cell.index] &&
                           !(one.new_cell.valid() && versions_.new_uses.writes[one.new_cell.index]);
      const auto [at, first] = level.try_emplace(cell, 0);
      const uint64_t before = first ? LevelAtBegin(cell, path.front()) : at->second;
      at->second = one.value;
      if (!is_kept || before != one.value) set.push_back(one);
    }
  }
  return run;
}

std::vector<std::vector<uint32_t>> WideRuns::Cover(const std::vector<Seen>& seen) const {
  std::vector<const Seen*> left;
  for (const Seen& one : seen) left.push_back(&one);
  std::vector<std::vector<uint32_t>> paths;
  while (!left.empty()) {
    // In one lane as many as can be; of lanes that were copied since, each period counts for itself.
    const Seen* const latest = *std::ranges::max_element(left, {}, &Seen::period);
    std::array<uint32_t, kLanes> count{};
    for (const Seen* const one : left) {
      if (one->period == latest->period) wide::ForEachLane(one->lanes, [&](uint32_t lane) { ++count[lane]; });
    }
    const auto best = static_cast<uint32_t>(std::ranges::max_element(count) - count.begin());
    paths.push_back(wide::WayOf(history_, best, latest->period));
    const std::vector<uint32_t>& path = paths.back();
    std::erase_if(left, [&path](const Seen* one) { return one->lanes.Get(path[one->period - 1]); });
  }
  std::ranges::sort(paths);
  return paths;
}

std::vector<uint32_t> WideRuns::OpenPairs(const std::vector<execute::CellId>& sought,
                                          const std::function<bool(execute::CellId)>& is_open) const {
  std::vector<uint32_t> open;
  for (const execute::CellId cell : sought) {
    const auto pair = pair_of_.find(cell);
    if (pair != pair_of_.end() && is_open(cell)) open.push_back(pair->second);
  }
  return open;
}

void WideRuns::Search(const std::vector<execute::CellId>& sought, Time end,
                      const std::function<bool(execute::CellId)>& is_open,
                      const std::function<void(const Run&, size_t shared)>& found) {
  if (!is_ready()) return;
  while (std::chrono::steady_clock::now() < end) {
    std::vector<uint32_t> open = OpenPairs(sought, is_open);
    std::erase_if(open, [this](uint32_t pair) { return pairs_[pair].told_in_vain >= kMostToldInVain; });
    if (open.empty()) return;
    std::vector<Seen> seen;
    Episode(open, end, seen);
    std::vector<uint32_t> before;
    for (const std::vector<uint32_t>& path : Cover(seen)) {
      if (std::chrono::steady_clock::now() >= end) return;
      const auto shared = std::ranges::mismatch(before, path).in1 - before.begin();
      found(RunOf(path), static_cast<size_t>(shared));
      before = path;
    }
    for (const Seen& one : seen) {
      if (is_open(one.cell)) ++pairs_[pair_of_.at(one.cell)].told_in_vain;
    }
  }
}

}  // namespace plcxx::prove::diff
