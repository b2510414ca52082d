#include "transpiler/prove/diff/relations.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

#include "transpiler/ir/op.h"
#include "transpiler/prove/diff/joint_run.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/sets.h"
#include "transpiler/support/low_bits.h"
#include "transpiler/support/mixed.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::diff {
namespace {

constexpr int kRuns = 24, kPeriods = 400;
constexpr size_t kMostEvaluated = 40'000'000;             // terms, in all runs
constexpr size_t kPeriodsFromSeen = 40;                   // of a state that runs have come by
constexpr size_t kMostStates = 4000;                      // that are kept, of those that differ
constexpr size_t kMostNumbers = 80;                       // of one version
constexpr size_t kMostAmong = 16;                         // values of two numbers that belong together
constexpr size_t kMostWhile = 24;                         // bits of one version, while which a relation is looked for
constexpr uint8_t kLowBits = 4;                           // of a field, of which each is looked at alone
constexpr size_t kMostRelations = 200, kMostSeldom = 60;  // those that exclude one of four values of two bits

using States = std::vector<std::vector<uint64_t>>;  // by number

/// What is in no equal pair, and its version alone writes.
class OpenCells {
 public:
  explicit OpenCells(Comparison& comparison) : comparison_(comparison) {
    Add(Which::kOld, comparison.one_sided.old_only);
    Add(Which::kNew, comparison.one_sided.new_only);
    for (const PairResult& result : comparison.results) {
      if (comparison.pairing.IsEqual(result.old_cell)) continue;
      Add(Which::kOld, {&result.old_cell, 1});
      Add(Which::kNew, {&result.new_cell, 1});
    }
  }

  const std::set<execute::CellId>& of(Which which) const { return cells_[which == Which::kOld ? 0 : 1]; }
  std::vector<Number> NumbersOf(Which which) const;

 private:
  void Add(Which which, std::span<const execute::CellId> cells) {
    for (const execute::CellId cell : cells) {
      if (IsOwn(which, cell)) cells_[which == Which::kOld ? 0 : 1].insert(cell);
    }
  }
  /// What others set, or clear, between two parts, or keep without power, is not the version's own.
  bool IsOwn(Which which, execute::CellId cell) const {
    const machine::Version& version = comparison_.pairing.version(which);
    const machine::Uses& uses = which == Which::kOld ? comparison_.old_uses : comparison_.new_uses;
    const execute::CellId old_cell = which == Which::kOld ? cell : comparison_.match.old_of_new[cell.index];
    const bool is_others = machine::WhatControlWrites(version, cell) != execute::ControlWrite::kNothing ||
                           (machine::MayBeSetByHost(version, cell) && !uses.sets[cell.index]) ||
                           (old_cell.valid() && comparison_.IsInput(old_cell)) || machine::IsInbox(version, cell) ||
                           machine::IsRetentive(version, cell);
    return cell.index < version.cells.calls && machine::IsState(version, cell) && uses.writes[cell.index] && !is_others;
  }

  Comparison& comparison_;
  std::array<std::set<execute::CellId>, 2> cells_;
};

std::vector<Number> OpenCells::NumbersOf(Which which) const {
  const machine::Version& version = comparison_.pairing.version(which);
  const std::set<execute::CellId>& open = of(which);
  std::vector<Number> words, bits;
  for (const execute::CellId id : open) {
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
    const uint8_t width = execute::CellWidth(*version.program, cell);
    if (width > 1) words.push_back({.which = which, .cells = {id}, .width = width});
    for (uint8_t low = 0; low < std::min(width, kLowBits); ++low)
      bits.push_back({.which = which, .cells = {id}, .low = low});
  }
  std::set<std::vector<execute::CellId>> taken;
  std::set<execute::CellId> rest;
  for (const ir::Place& place : version.program->places) {
    const bool is_word = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                         place.type <= ir::Type::kI64 && execute::IsInside(*version.program, place);
    if (!is_word) continue;
    std::vector<execute::CellId> cells = execute::CellsOf(*version.program, version.cells, place);
    // The high digits may be equal, which are always 0.
    const bool is_open = std::ranges::any_of(cells, [&open](execute::CellId cell) { return open.contains(cell); });
    if (!is_open || !std::ranges::all_of(cells, [&](execute::CellId cell) { return IsOwn(which, cell); })) continue;
    std::ranges::reverse(cells);
    if (!taken.insert(cells).second) continue;
    for (const execute::CellId cell : cells) {
      if (!open.contains(cell) && rest.insert(cell).second) bits.push_back({.which = which, .cells = {cell}});
    }
    const auto width = static_cast<uint8_t>(cells.size());
    words.push_back({.which = which, .cells = std::move(cells), .width = width});
  }
  words.resize(std::min(words.size(), kMostNumbers / 2));
  bits.resize(std::min(bits.size(), kMostNumbers - words.size()));
  std::ranges::move(bits, std::back_inserter(words));
  return words;
}

/// What a number was in each state.
struct Seen {
  Number number;
  std::vector<VariablePart> parts;  // from the most significant down
  std::vector<uint64_t> values;     // by state
  bool is_same = false;             // as its counterpart in the other version, in each of them
  std::set<uint64_t> different;     // two at most, where one is asked about
};

class Observed {
 public:
  explicit Observed(Comparison& comparison) : comparison_(comparison), run_(comparison) {}

  bool Run();
  /// Without what was always the same in both, or with it.
  std::vector<Relation> Relations(bool with_same) const;
  bool HasSame() const { return std::ranges::any_of(old_, &Seen::is_same); }

 private:
  void AddNumbers();
  void AddState();
  /// From where it is.
  void RunOn(terms::Random& random, uint64_t one_in, size_t periods);

  void MarkSame();
  static bool Holds(const std::vector<uint32_t>& states, const Seen& a, const Seen& b, uint64_t factor,
                    uint64_t constant);
  static std::optional<Relation> LinearOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b);
  static std::optional<Relation> AmongOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b);
  static void AddComparisons(const std::vector<uint32_t>& states, const Seen& bit, const Seen& number,
                             std::vector<Relation>& relations);

  Comparison& comparison_;
  JointRun run_;
  std::vector<Seen> old_, new_;
  std::unordered_set<uint64_t> kept_;  // hashes of states
  uint32_t states_ = 0;
};

void Observed::AddNumbers() {
  const OpenCells open(comparison_);
  for (const Which which : {Which::kOld, Which::kNew}) {
    for (Number& number : open.NumbersOf(which)) {
      // The high digits of a small number are always 0.
      const auto is_zero = [&](execute::CellId cell) {
        return comparison_.terms.IsZero(comparison_.pairing.Initial(which, cell));
      };
      while (number.cells.size() > 1 && is_zero(number.cells.front())) {
        number.cells.erase(number.cells.begin());
        --number.width;
      }
      Seen seen{.number = std::move(number), .parts = {}, .values = {}, .different = {}};
      for (const execute::CellId cell : seen.number.cells) {
        const std::optional<VariablePart> part = run_.PartOf(which, cell);
        if (part) seen.parts.push_back(*part);
      }
      if (seen.parts.size() == seen.number.cells.size())
        (which == Which::kOld ? old_ : new_).push_back(std::move(seen));
    }
  }
}

void Observed::AddState() {
  if (states_ >= kMostStates) return;
  uint64_t hash = 0;
  for (std::vector<Seen>* const side : {&old_, &new_}) {
    for (Seen& seen : *side) {
      uint64_t value = 0;
      for (const VariablePart& part : seen.parts) value = value << part.width | run_.ValueOf(part);
      value = value >> seen.number.low & support::LowBits(seen.number.width);
      seen.values.push_back(value);
      hash = support::Mixed(hash, value);
    }
  }
  if (kept_.insert(hash).second) {
    ++states_;
    return;
  }
  for (std::vector<Seen>* const side : {&old_, &new_})
    for (Seen& seen : *side) seen.values.pop_back();
}

void Observed::RunOn(terms::Random& random, uint64_t one_in, size_t periods) {
  AddState();
  const ir::Schedule& schedule = comparison_.old_version.program->schedule;
  const bool is_timed = machine::HasTimedFastPart(comparison_.old_version);
  const uint32_t fast_parts = is_timed ? std::max(1U, schedule.period_ms / schedule.fast_ms) : 0;
  for (size_t period = 0; period < periods && !comparison_.Late(); ++period) {
    for (size_t input = 0; input < run_.input_count(); ++input) {
      if (random.OneIn(one_in)) run_.SetInput(input, random.Next());
    }
    // Of the fast parts between two periods one is enough to guess from; a time counts them all.
    for (uint32_t part = 0; part < std::min(fast_parts, 4U); ++part) {
      run_.Execute(0);
      run_.now_ms += schedule.period_ms / std::min(fast_parts, 4U);
      AddState();
    }
    const bool fast_alone = run_.part_count() > 1 && fast_parts == 0 && random.OneIn(8);
    run_.Execute(fast_alone ? 0 : run_.part_count() - 1);
    if (fast_parts == 0) run_.now_ms += schedule.period_ms;
    AddState();
  }
}

bool Observed::Run() {
  if (!run_.Prepare()) return false;
  AddNumbers();
  if (old_.empty() || new_.empty()) return false;
  terms::Random random(0x2545F4914F6CDD1D);
  const size_t periods = std::min<size_t>(kPeriods, kMostEvaluated / kRuns / std::max<size_t>(1, run_.size()));
  for (int run = 0; run < kRuns; ++run) {
    run_.PowerOn();
    RunOn(random, uint64_t{2} << (run % 6), periods);
  }
  // What begins after seconds only random inputs do not come to.
  const size_t most_periods = kMostEvaluated / std::max<size_t>(1, run_.size());
  size_t from_seen = 0;
  if (comparison_.runs.for_each_seen_pair) {
    comparison_.runs.for_each_seen_pair(
        [&](const invariants::CellValues& of_old, const invariants::CellValues& of_new, uint64_t now_ms) {
          if (from_seen + kPeriodsFromSeen > most_periods || comparison_.Late()) return;
          from_seen += kPeriodsFromSeen;
          run_.Take(of_old, of_new, now_ms);
          RunOn(random, 8, kPeriodsFromSeen);
        });
  }
  for (std::vector<Seen>* const side : {&old_, &new_}) {
    for (Seen& seen : *side) {
      for (const uint64_t value : seen.values) {
        seen.different.insert(value);
        if (seen.different.size() > kMostAmong) break;
      }
    }
    // What is always the same is an invariant of its version.
    std::erase_if(*side, [](const Seen& seen) { return seen.different.size() < 2; });
  }
  MarkSame();
  return true;
}

void Observed::MarkSame() {
  for (Seen& seen : old_) {
    Number counterpart = seen.number;
    counterpart.which = Which::kNew;
    for (execute::CellId& cell : counterpart.cells) cell = comparison_.match.new_of_old[cell.index];
    const auto other = std::ranges::find(new_, counterpart, &Seen::number);
    if (other != new_.end() && other->values == seen.values) seen.is_same = other->is_same = true;
  }
}

bool Observed::Holds(const std::vector<uint32_t>& states, const Seen& a, const Seen& b, uint64_t factor,
                     uint64_t constant) {
  const uint64_t mask = support::LowBits(a.number.width);
  return std::ranges::all_of(
      states, [&](uint32_t state) { return a.values[state] == ((b.values[state] & mask) * factor + constant & mask); });
}

/// a = factor * b + constant, by the first two states in which b is another one.
std::optional<Relation> Observed::LinearOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b) {
  if (states.size() < 3) return std::nullopt;
  const uint32_t first = states.front();
  const auto other = std::ranges::find_if(
      states, [&](uint32_t state) { return b.values[state] != b.values[first] && a.values[state] != a.values[first]; });
  if (other == states.end()) return std::nullopt;
  const auto change = [&](const Seen& seen) {
    return static_cast<int64_t>(seen.values[*other]) - static_cast<int64_t>(seen.values[first]);
  };
  const int64_t by_a = change(a), by_b = change(b);
  if (by_a % by_b != 0) return std::nullopt;
  const auto factor = static_cast<uint64_t>(by_a / by_b);
  const uint64_t mask = support::LowBits(a.number.width);
  const uint64_t constant = (a.values[first] - (b.values[first] & mask) * factor) & mask;
  if (!Holds(states, a, b, factor, constant)) return std::nullopt;
  return Relation{.kind = Relation::Kind::kLinear,
                  .number = a.number,
                  .other = b.number,
                  .factor = factor,
                  .constant = constant,
                  .values = {},
                  .while_bit = {}};
}

/// Where each value of one has its own of the other one.
std::optional<Relation> Observed::AmongOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b) {
  std::set<std::pair<uint64_t, uint64_t>> seen;
  for (const uint32_t state : states) {
    seen.emplace(a.values[state], b.values[state]);
    if (seen.size() > kMostAmong) return std::nullopt;
  }
  std::set<uint64_t> firsts, seconds;
  for (const auto& [first, second] : seen) {
    firsts.insert(first);
    seconds.insert(second);
  }
  const bool says_something = seen.size() < firsts.size() * seconds.size();
  if (!says_something || firsts.size() < 2 || seconds.size() < 2) return std::nullopt;
  return Relation{.kind = Relation::Kind::kAmong,
                  .number = a.number,
                  .other = b.number,
                  .values = {seen.begin(), seen.end()},
                  .while_bit = {}};
}

void Observed::AddComparisons(const std::vector<uint32_t>& states, const Seen& bit, const Seen& number,
                              std::vector<Relation>& relations) {
  // The least and greatest value while the bit is 0, and while it is 1.
  std::array<uint64_t, 2> least{~uint64_t{0}, ~uint64_t{0}}, greatest{};
  std::array<std::set<uint64_t>, 2> values;
  for (const uint32_t state : states) {
    const uint64_t value = number.values[state];
    const size_t side = bit.values[state];
    least[side] = std::min(least[side], value);
    greatest[side] = std::max(greatest[side], value);
    if (values[side].size() < 3) values[side].insert(value);
  }
  if (values[0].empty() || values[1].empty()) return;
  const auto add = [&](Relation::Kind kind, uint64_t constant, bool is_inverted) {
    relations.push_back({.kind = kind,
                         .number = bit.number,
                         .other = number.number,
                         .constant = constant,
                         .is_inverted = is_inverted,
                         .values = {},
                         .while_bit = {}});
  };
  for (const size_t set : {size_t{1}, size_t{0}}) {
    const size_t clear = 1 - set;
    if (values[set].size() == 1) {
      const uint64_t only = *values[set].begin();
      const bool is_alone = std::ranges::none_of(
          states, [&](uint32_t state) { return bit.values[state] == clear && number.values[state] == only; });
      if (is_alone) add(Relation::Kind::kIs, only, set == 0);
    }
    if (greatest[clear] < least[set]) {
      add(Relation::Kind::kAtLeast, least[set], set == 0);
      if (greatest[clear] + 1 != least[set]) add(Relation::Kind::kAtLeast, greatest[clear] + 1, set == 0);
    }
  }
}

std::vector<Relation> Observed::Relations(bool with_same) const {
  std::vector<uint32_t> all(states_);
  for (uint32_t i = 0; i < states_; ++i) all[i] = i;
  // Whose states, and which relation is said of them.
  struct While {
    const Seen* bit = nullptr;
    bool set = false;
    std::vector<uint32_t> states;
  };
  std::vector<While> whiles;
  for (const std::vector<Seen>* const side : {&old_, &new_}) {
    size_t count = 0;
    for (const Seen& seen : *side) {
      if (seen.number.width != 1 || seen.number.low != 0 || ++count > kMostWhile) continue;
      for (const bool set : {true, false}) {
        While one{.bit = &seen, .set = set, .states = {}};
        std::ranges::copy_if(all, std::back_inserter(one.states),
                             [&](uint32_t state) { return (seen.values[state] != 0) == set; });
        whiles.push_back(std::move(one));
      }
    }
  }
  std::vector<Relation> always, sometimes, seldom;
  for (const Seen& a : old_) {
    for (const Seen& b : new_) {
      if (comparison_.Late()) return {};
      if (!with_same && (a.is_same || b.is_same)) continue;
      const bool are_bits = a.number.width == 1 && b.number.width == 1;
      if (are_bits) {
        std::optional<Relation> among = AmongOf(all, a, b);
        if (among) (among->values.size() == 2 ? always : seldom).push_back(std::move(*among));
        continue;
      }
      if (a.number.width == 1) AddComparisons(all, a, b, always);
      if (b.number.width == 1) AddComparisons(all, b, a, always);
      if (std::optional<Relation> among = AmongOf(all, a, b)) always.push_back(std::move(*among));
      if (a.number.width == 1 || b.number.width == 1) continue;
      std::optional<Relation> linear = LinearOf(all, a, b);
      if (!linear) linear = LinearOf(all, b, a);
      if (linear) {
        always.push_back(std::move(*linear));
        continue;
      }
      for (const While& one : whiles) {
        linear = LinearOf(one.states, a, b);
        if (!linear) linear = LinearOf(one.states, b, a);
        if (!linear) continue;
        linear->while_bit = one.bit->number;
        linear->while_set = one.set;
        sometimes.push_back(std::move(*linear));
      }
    }
  }
  std::ranges::move(sometimes, std::back_inserter(always));
  seldom.resize(std::min(seldom.size(), kMostSeldom));
  std::ranges::move(seldom, std::back_inserter(always));
  always.resize(std::min(always.size(), kMostRelations));
  return always;
}

}  // namespace

std::vector<std::vector<Relation>> GuessRelations(Comparison& comparison) {
  Observed observed(comparison);
  if (!observed.Run()) return {};
  std::vector<std::vector<Relation>> sets{observed.Relations(false)};
  if (observed.HasSame()) sets.push_back(observed.Relations(true));
  std::erase_if(sets, [](const std::vector<Relation>& set) { return set.empty(); });
  return sets;
}

}  // namespace plcxx::prove::diff
