#include "transpiler/prove/properties/wide_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostNearBits = 512, kMostConjuncts = 24;
constexpr size_t kMostSets = 200'000;  // that an episode remembers
constexpr size_t kMostNumbers = 64;
constexpr int kKeptBits = 8;
constexpr uint32_t kLanesToAState = 8;
constexpr float kConjunctWeight = 4;

/// What must all be so for the bit to be 1.
std::vector<terms::TermId> ConjunctsOf(terms::Terms& terms, terms::TermId bit) {
  std::vector<terms::TermId> conjuncts;
  std::vector<std::pair<terms::TermId, bool>> open{{bit, true}};  // and which value it must have
  while (!open.empty()) {
    const auto [id, value] = open.back();
    open.pop_back();
    const terms::Term term = terms[id];
    const auto each = [&](bool of_operands) {
      terms.ForEachOperand(term, [&](terms::TermId operand) { open.emplace_back(operand, of_operands); });
    };
    if (term.kind == terms::TermKind::kNot) {
      each(!value);
    } else if (term.width == 1 && term.kind == (value ? terms::TermKind::kAnd : terms::TermKind::kOr)) {
      each(value);
    } else {
      conjuncts.push_back(value ? id : terms.Not(id));
    }
    if (conjuncts.size() + open.size() > kMostConjuncts) return {};
  }
  return conjuncts;
}

/// A number as it counts for who has seen it: of a great one, as a time that runs, the highest digits.
uint64_t Kept(uint64_t value) {
  const auto width = static_cast<int>(std::bit_width(value));
  return width <= kKeptBits ? value : (value >> (width - 3)) << (width - 3);
}

}  // namespace

WideSearch::WideSearch(terms::Terms& terms, machine::Relation& relation, const RunSearch& search,
                       const std::vector<std::vector<execute::CellId>>& numbers, Time end)
    : terms_(terms), relation_(relation), handshakes_(machine::HandshakeCells(relation.version())) {
  const auto is_late = [end] { return std::chrono::steady_clock::now() >= end; };
  const machine::Transition init = wide::PowerOnAlone(terms, relation.version(), is_late);
  if (!init.refusal.empty() || is_late()) return;
  for (const PropertyOperand& operand : search.property->operands)
    named_.insert(named_.end(), operand.cells.begin(), operand.cells.end());
  std::ranges::sort(named_);
  named_.erase(std::ranges::unique(named_).begin(), named_.end());
  const std::vector<execute::CellId> cells = wide::DependedOn(terms, relation, named_);
  if (is_late()) return;
  machine_.emplace(terms, relation, cells, init);
  AddInputs(search, cells);
  AddNumbers(numbers);
  AddProperty(*search.property);
}

void WideSearch::AddInputs(const RunSearch& search, const std::vector<execute::CellId>& cells) {
  const machine::Version& version = relation_.version();
  std::vector<bool> is_input(version.cells.count);
  for (const execute::CellId cell : search.inputs) is_input[cell.index] = true;
  std::vector<wide::WideInputs::Input> inputs;
  wide::Reader reader{.relation = relation_, .numbers = {}};
  for (const execute::CellId cell : cells) {
    const size_t width = machine_->Planes(cell).size();
    if (is_input[cell.index] && width == 1) {
      reader.numbers[cell.index] = static_cast<uint32_t>(inputs.size());
      inputs.push_back({.cell = cell, .is_machines = machine::DirectionOf(version, cell) == ir::Direction::kInput});
      continue;
    }
    for (size_t bit = 0; bit < width && near_.size() < kMostNearBits; ++bit)
      near_.push_back({.cell = cell, .number = static_cast<uint8_t>(bit)});
  }
  inputs_.emplace(terms_, std::move(inputs), std::span(&reader, 1));
  std::ranges::copy_if(search.requests, std::back_inserter(requests_),
                       [this](execute::CellId cell) { return machine_->Has(cell); });
}

void WideSearch::AddNumbers(const std::vector<std::vector<execute::CellId>>& numbers) {
  for (const std::vector<execute::CellId>& cells : numbers) {
    Number number;
    for (const execute::CellId cell : cells) {
      const size_t width = machine_->Has(cell) ? machine_->Planes(cell).size() : 0;
      for (size_t bit = 0; bit < width; ++bit) number.bits.emplace_back(cell, static_cast<uint8_t>(bit));
    }
    if (number.bits.size() > 1 && numbers_.size() < kMostNumbers) numbers_.push_back(std::move(number));
  }
}

void WideSearch::AddProperty(const Property& property) {
  std::vector<terms::LaneProgram::VariableAt> variables;
  for (const execute::CellId cell : named_) {
    variables.push_back({relation_.VariableOf(cell), static_cast<uint32_t>(first_count_)});
    first_count_ += machine_->Planes(cell).size();
  }
  size_t next_plane = first_count_;
  std::vector<terms::TermId> roots;  // no count is computed while another one is
  const terms::TermId holds = HoldsByCounting(
      terms_, property, [this](execute::CellId cell) { return relation_.VariableOf(cell); },
      [&](uint32_t most, const std::function<terms::TermId(terms::TermId)>& next) {
        const auto width = static_cast<uint8_t>(std::bit_width(most));
        const terms::TermId before = terms_.Variable("lanes' count " + std::to_string(terms_.variable_count()), width);
        variables.push_back({before, static_cast<uint32_t>(next_plane)});
        next_plane += width;
        count_widths_.push_back(width);
        roots.push_back(next(before));
        return roots.back();
      });
  const terms::TermId violated = terms_.Not(holds);
  roots.push_back(violated);
  const std::vector<terms::TermId> conjuncts = ConjunctsOf(terms_, violated);
  if (conjuncts.size() > 1) {
    conjuncts_ = conjuncts.size();
    roots.insert(roots.end(), conjuncts.begin(), conjuncts.end());
  }
  looked_at_.resize(next_plane);
  seen_counts_.resize(next_plane - first_count_);
  property_.emplace(terms_, variables, roots);
}

void WideSearch::PowerOn() {
  machine_->PowerOn();
  std::ranges::fill(looked_at_, terms::Plane());
  history_.clear();
  set_ = 0;
  now_ms_ = {};
}

terms::Plane WideSearch::Advance(const wide::Period& period) {
  for (const wide::WideSet& set : period.sets) machine_->Store(inputs_->inputs()[set.input].cell, set.where, set.value);
  for (const auto& [request, where] : period.done) machine_->Store(request, where, terms::Plane());
  const uint32_t period_ms = relation_.version().program->schedule.period_ms;
  machine_->RunPeriod(now_ms_, period_ms);
  for (uint64_t& now : now_ms_) now += period_ms;
  auto to = looked_at_.begin();
  for (const execute::CellId cell : named_) to = std::ranges::copy(machine_->Planes(cell), to).out;
  property_->Run(looked_at_);
  // The planes of a count may be another count's before this period: all are read before one is written.
  std::vector<terms::Plane> counts;
  for (size_t i = 0; i < count_widths_.size(); ++i) {
    const std::span<const terms::Plane> planes = property_->Root(i);
    counts.insert(counts.end(), planes.begin(), planes.end());
  }
  const terms::Plane violated = property_->Root(count_widths_.size()).front();
  std::ranges::copy(counts, to);
  return violated;
}

void WideSearch::AddRareLanes(const terms::Plane& bit, Seen& seen, wide::Scores& scores) {
  const uint32_t ones = wide::CountLanes(bit), zeros = terms::Plane::kLanes - ones;
  seen.ones += ones;
  seen.zeros += zeros;
  if (ones == 0 || zeros == 0) return;
  const bool is_rarely_set = seen.ones < seen.zeros;
  const auto share = static_cast<float>(std::min(seen.ones, seen.zeros)) / static_cast<float>(seen.ones + seen.zeros);
  wide::AddScore(is_rarely_set ? bit : ~bit, 1 - share, scores);
}

void WideSearch::AddRareLanes(Number& number, wide::Scores& scores) const {
  std::array<uint64_t, terms::Plane::kLanes> values{};
  for (size_t i = 0; i < std::min<size_t>(number.bits.size(), 64); ++i) {
    const auto& [cell, bit] = number.bits[i];
    wide::ForEachLane(std::as_const(*machine_).Planes(cell)[bit],
                      [&](uint32_t lane) { values[lane] |= uint64_t{1} << i; });
  }
  for (uint64_t& value : values) {
    value = Kept(value);
    ++number.seen[value];
  }
  for (uint32_t lane = 0; lane < terms::Plane::kLanes; ++lane)
    scores[lane] += 1 / static_cast<float>(number.seen[values[lane]]);
}

void WideSearch::Select(wide::Period& period) {
  wide::Scores scores{};
  for (StateBit& bit : near_) AddRareLanes(std::as_const(*machine_).Planes(bit.cell)[bit.number], bit.seen, scores);
  for (size_t i = 0; i < seen_counts_.size(); ++i) AddRareLanes(looked_at_[first_count_ + i], seen_counts_[i], scores);
  for (Number& number : numbers_) AddRareLanes(number, scores);
  if (conjuncts_ != 0) {
    std::array<uint32_t, terms::Plane::kLanes> count{};
    for (size_t i = 0; i < conjuncts_; ++i)
      wide::ForEachLane(property_->Root(count_widths_.size() + 1 + i).front(), [&](uint32_t lane) { ++count[lane]; });
    const uint32_t most = *std::ranges::max_element(count);
    terms::Plane nearest;
    for (uint32_t lane = 0; lane < terms::Plane::kLanes; ++lane) nearest.Set(lane, count[lane] == most);
    wide::AddScore(nearest, kConjunctWeight, scores);
  }
  period.copy_of = wide::DrawCopies(scores, random_);
  machine_->Spread(period.copy_of);
  wide::SpreadLanes(std::span(looked_at_).subspan(first_count_), period.copy_of);
  wide::SpreadTimes(now_ms_, period.copy_of);
  for (uint32_t word = 0; word < kWords; ++word) {
    if (random_.OneIn(4)) inputs_->ChangeHabits(word);
  }
}

std::optional<PropertyRun> WideSearch::Episode(Time end) {
  constexpr std::array<uint32_t, 6> kLengths = {24, 150, 60, 400, 60, 2000};
  constexpr std::array<uint32_t, 5> kSelectEvery = {3, 2, 5, 8, 16};
  const uint32_t periods = kLengths[episodes_ % kLengths.size()],
                 every = kSelectEvery[episodes_ / 2 % kSelectEvery.size()];
  ++episodes_;
  PowerOn();
  inputs_->Begin();
  for (uint32_t i = 0; i < periods && set_ < kMostSets && std::chrono::steady_clock::now() < end; ++i) {
    wide::Period& period = history_.emplace_back();
    if (i != 0 && i % every == 0) Select(period);
    period.sets = inputs_->Next(i == 0);
    period.done = wide::DrawDone(requests_, random_);
    set_ += period.sets.size() + period.done.size();
    const terms::Plane violated = Advance(period);
    if (violated.IsZero()) continue;
    uint32_t first = terms::Plane::kLanes;
    wide::ForEachLane(violated, [&first](uint32_t lane) { first = std::min(first, lane); });
    return RunOf(first);
  }
  return std::nullopt;
}

PropertyRun WideSearch::RunOf(uint32_t lane) const {
  const auto end = static_cast<uint32_t>(history_.size());
  const std::vector<uint32_t> way = wide::WayOf(history_, lane, end);
  const uint32_t parts = std::max(1U, ir::FastPartsOfPeriod(relation_.version().program->schedule));
  PropertyRun run;
  run.periods.assign(end, std::vector<std::vector<InputValue>>(parts));
  std::map<execute::CellId, bool> level;
  for (uint32_t i = 0; i < end; ++i) {
    std::map<execute::CellId, bool> sets;
    wide::ForEachSet(history_[i], *inputs_, way[i], [&sets](execute::CellId cell, bool value) { sets[cell] = value; });
    for (const auto& [cell, value] : sets) {
      const auto [at, is_first] = level.try_emplace(cell, value);
      // What the program writes, too, has another value there, perhaps.
      const bool stays = !handshakes_[cell.index] && std::ranges::find(requests_, cell) == requests_.end();
      if (!is_first && at->second == value && stays) continue;
      at->second = value;
      run.periods[i].front().push_back({cell, value});
    }
  }
  return run;
}

std::optional<PropertyRun> WideSearch::Find(Time end) {
  if (!machine_ || (inputs_->inputs().empty() && requests_.empty())) return std::nullopt;
  while (std::chrono::steady_clock::now() < end) {
    if (std::optional<PropertyRun> run = Episode(end)) return run;
  }
  return std::nullopt;
}

void WideSearch::ForEachState(
    const std::function<void(const invariants::CellValues& state, uint64_t now_ms)>& visit) const {
  if (!machine_ || history_.empty()) return;
  for (uint32_t lane = 0; lane < terms::Plane::kLanes; lane += kLanesToAState) {
    const auto value = [&](execute::CellId cell) {
      return machine_->Has(cell) ? terms::ValueInLane(machine_->Planes(cell), lane) : 0;
    };
    visit(value, now_ms_[lane / 64]);
  }
}

}  // namespace plcxx::prove::properties
