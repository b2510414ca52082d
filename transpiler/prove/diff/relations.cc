#include "transpiler/prove/diff/relations.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/prove/diff/joint_run.h"
#include "transpiler/prove/diff/open_cells.h"
#include "transpiler/support/low_bits.h"
#include "transpiler/support/mixed.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::diff {
namespace {

constexpr int kRuns = 24, kPeriods = 400;
constexpr size_t kMostEvaluated = 40'000'000;             // terms, in all runs
constexpr size_t kPeriodsFromSeen = 40;                   // of a state that runs have come by
constexpr size_t kMostStates = 4000;                      // that are kept, of those that differ
constexpr size_t kMostAmong = 16;                         // values of two numbers that belong together
constexpr size_t kMostWhile = 24;                         // bits of one version, while which a relation is looked for
constexpr size_t kMostWhileTwo = 60;                      // pairs of numbers of which it is, while two bits are so
constexpr size_t kMostBitsWhile = 60;                     // relations of two bits, while a third one is so
constexpr size_t kLeastStatesWhileTwo = 12;               // or it says nothing that one more state does not break
constexpr size_t kMostRelations = 200, kMostSeldom = 60;  // those that exclude one of four values of two bits

using States = std::bitset<kMostStates>;

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
  bool RestrictRun();
  void LeaveOutFollowers();
  std::optional<Seen> SeenOf(Number number);
  void AddState();
  /// From where it is.
  void RunOn(terms::Random& random, uint64_t one_in, size_t periods);

  /// A bit with a value, and the states in which it has that.
  struct StatesWhile {
    Relation::While bit;
    std::vector<uint32_t> states;
  };
  std::vector<StatesWhile> Whiles(const std::vector<uint32_t>& all) const;
  std::vector<Relation> BitsWhile(const std::vector<StatesWhile>& whiles, bool with_same) const;
  struct Line {
    uint64_t factor = 1, constant = 0;
    size_t count = 0;
  };
  std::vector<Line> LinesOf(const Seen& a, const Seen& b) const;
  void AddWhileTwo(const std::vector<StatesWhile>& whiles, const Seen& a, const Seen& b,
                   std::vector<Relation>& relations) const;

  void MarkSame();
  static bool Holds(const std::vector<uint32_t>& states, const Seen& a, const Seen& b, uint64_t factor,
                    uint64_t constant);
  static std::optional<Relation> LinearOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b);
  static std::optional<Relation> SumOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b,
                                       const Seen& c);
  void AddSums(const std::vector<uint32_t>& states, const std::vector<Seen>& ones, const std::vector<Seen>& others,
               std::vector<Relation>& relations) const;
  static std::optional<Relation> AmongOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b);
  static void AddComparisons(const std::vector<uint32_t>& states, const Seen& bit, const Seen& number,
                             std::vector<Relation>& relations);

  Comparison& comparison_;
  JointRun run_;
  std::vector<Seen> old_, new_, equal_;  // equal_: bits
  std::unordered_set<uint64_t> kept_;    // hashes of states
  uint32_t states_ = 0;
};

std::optional<Seen> Observed::SeenOf(Number number) {
  Seen seen{.number = std::move(number), .parts = {}, .values = {}, .different = {}};
  for (const execute::CellId cell : seen.number.cells) {
    const std::optional<VariablePart> part = run_.PartOf(seen.number.which, cell);
    if (!part) return std::nullopt;
    seen.parts.push_back(*part);
  }
  return seen;
}

void Observed::AddNumbers() {
  const OpenCells open(comparison_);
  for (Number& bit : open.EqualBits()) {
    if (std::optional<Seen> seen = SeenOf(std::move(bit))) equal_.push_back(std::move(*seen));
  }
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
      if (std::optional<Seen> seen = SeenOf(std::move(number)))
        (which == Which::kOld ? old_ : new_).push_back(std::move(*seen));
    }
  }
}

void Observed::AddState() {
  if (states_ >= kMostStates) return;
  uint64_t hash = 0;
  for (std::vector<Seen>* const side : {&old_, &new_, &equal_}) {
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
  for (std::vector<Seen>* const side : {&old_, &new_, &equal_})
    for (Seen& seen : *side) seen.values.pop_back();
}

void Observed::RunOn(terms::Random& random, uint64_t one_in, size_t periods) {
  AddState();
  const ir::Schedule& schedule = comparison_.old_version.program->schedule;
  const uint32_t fast_parts = ir::FastPartsOfPeriod(schedule);
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

/// To what the numbers are computed from; false: that is too much.
bool Observed::RestrictRun() {
  std::vector<VariablePart> looked_at;
  for (const std::vector<Seen>* const side : {&old_, &new_, &equal_}) {
    for (const Seen& seen : *side) std::ranges::copy(seen.parts, std::back_inserter(looked_at));
  }
  return run_.Restrict(looked_at);
}

/// Leaves what has a change of its own, and memory that one version alone has.
void Observed::LeaveOutFollowers() {
  equal_.clear();
  const auto follows = [this](const Seen& seen) {
    return std::ranges::all_of(seen.number.cells, [&](execute::CellId cell) {
      const bool is_old = seen.number.which == Which::kOld;
      const PairResult* const result = comparison_.ResultOf(is_old ? cell : comparison_.match.old_of_new[cell.index]);
      return result != nullptr && !result->changed_itself;
    });
  };
  std::erase_if(old_, follows);
  std::erase_if(new_, follows);
}

bool Observed::Run() {
  if (!run_.Prepare()) return false;
  AddNumbers();
  if (old_.empty() || new_.empty()) return false;
  if (!RestrictRun()) {
    // Very much may be behind what only takes its difference from others, or is equal.
    LeaveOutFollowers();
    if (old_.empty() || new_.empty() || !RestrictRun()) return false;
  }
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
  for (std::vector<Seen>* const side : {&old_, &new_, &equal_}) {
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
                  .values = {}};
}

/// a = b + c + constant, where neither b nor c stays what it is.
std::optional<Relation> Observed::SumOf(const std::vector<uint32_t>& states, const Seen& a, const Seen& b,
                                        const Seen& c) {
  if (states.empty()) return std::nullopt;
  const uint64_t mask = support::LowBits(a.number.width);
  const auto rest = [&](uint32_t state) { return (a.values[state] - b.values[state] - c.values[state]) & mask; };
  const uint64_t constant = rest(states.front());
  if (!std::ranges::all_of(states, [&](uint32_t state) { return rest(state) == constant; })) return std::nullopt;
  return Relation{.kind = Relation::Kind::kSum,
                  .number = a.number,
                  .other = b.number,
                  .third = c.number,
                  .constant = constant,
                  .values = {}};
}

void Observed::AddSums(const std::vector<uint32_t>& states, const std::vector<Seen>& ones,
                       const std::vector<Seen>& others, std::vector<Relation>& relations) const {
  for (const Seen& a : ones) {
    for (size_t b = 0; a.number.width > 1 && b < others.size() && !comparison_.Late(); ++b) {
      for (size_t c = b + 1; c < others.size(); ++c) {
        if (others[b].number.width == 1 || others[c].number.width == 1) continue;
        if (std::optional<Relation> sum = SumOf(states, a, others[b], others[c])) relations.push_back(std::move(*sum));
      }
    }
  }
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
  return Relation{
      .kind = Relation::Kind::kAmong, .number = a.number, .other = b.number, .values = {seen.begin(), seen.end()}};
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
                         .values = {}});
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

std::vector<Observed::StatesWhile> Observed::Whiles(const std::vector<uint32_t>& all) const {
  std::vector<StatesWhile> whiles;
  for (const std::vector<Seen>* const side : {&old_, &new_, &equal_}) {
    size_t count = 0;
    for (const Seen& seen : *side) {
      if (seen.number.width != 1 || seen.number.low != 0) continue;
      if (side != &equal_ && ++count > kMostWhile) continue;
      for (const bool is_set : {true, false}) {
        StatesWhile one{.bit = {.bit = seen.number, .is_set = is_set}, .states = {}};
        std::ranges::copy_if(all, std::back_inserter(one.states),
                             [&](uint32_t state) { return (seen.values[state] != 0) == is_set; });
        whiles.push_back(std::move(one));
      }
    }
  }
  return whiles;
}

/// The lines a = factor * b + constant that most states beside each other are on.
std::vector<Observed::Line> Observed::LinesOf(const Seen& a, const Seen& b) const {
  constexpr size_t kMostLines = 3;
  const uint64_t mask = support::LowBits(a.number.width);
  std::map<std::pair<uint64_t, uint64_t>, size_t> counts;  // by factor and constant
  for (uint32_t state = 0; state + 1 < states_; ++state) {
    const auto change = [&](const Seen& seen) {
      return static_cast<int64_t>(seen.values[state + 1]) - static_cast<int64_t>(seen.values[state]);
    };
    const int64_t by_a = change(a), by_b = change(b);
    if (by_a == 0 || by_b == 0 || by_a % by_b != 0) continue;
    const auto factor = static_cast<uint64_t>(by_a / by_b);
    ++counts[{factor, (a.values[state] - (b.values[state] & mask) * factor) & mask}];
  }
  std::vector<Line> lines;
  for (const auto& [line, count] : counts)
    lines.push_back({.factor = line.first, .constant = line.second, .count = count});
  std::ranges::stable_sort(lines, std::greater<>(), &Line::count);
  lines.resize(std::min(lines.size(), kMostLines));
  return lines;
}

/// Of each line the two bits while which most states are on it, where these are more than while one bit is so.
void Observed::AddWhileTwo(const std::vector<StatesWhile>& whiles, const Seen& a, const Seen& b,
                           std::vector<Relation>& relations) const {
  const uint64_t mask = support::LowBits(a.number.width);
  for (const Line& line : LinesOf(a, b)) {
    States of_line;
    for (uint32_t state = 0; state < states_; ++state) {
      of_line[state] = a.values[state] == ((b.values[state] & mask) * line.factor + line.constant & mask);
    }
    std::vector<States> states;
    size_t most = kLeastStatesWhileTwo;
    for (const StatesWhile& one : whiles) {
      States& of_one = states.emplace_back();
      for (const uint32_t state : one.states) of_one[state] = true;
      if ((of_one & ~of_line).none()) most = std::max(most, of_one.count());
    }
    std::optional<std::pair<size_t, size_t>> best;
    for (size_t one = 0; one < whiles.size() && !comparison_.Late(); ++one) {
      const States off_line = states[one] & ~of_line;
      for (size_t other = one + 1; other < whiles.size(); ++other) {
        if (whiles[one].bit.bit == whiles[other].bit.bit || (off_line & states[other]).any()) continue;
        const size_t count = (states[one] & states[other]).count();
        if (count <= most) continue;
        most = count;
        best = std::pair(one, other);
      }
    }
    if (!best) continue;
    relations.push_back({.kind = Relation::Kind::kLinear,
                         .number = a.number,
                         .other = b.number,
                         .factor = line.factor,
                         .constant = line.constant,
                         .values = {},
                         .whiles = {whiles[best->first].bit, whiles[best->second].bit}});
  }
}

/// That two bits are equal, or opposite, while a third one is set, or is not: those that are said of most states.
std::vector<Relation> Observed::BitsWhile(const std::vector<StatesWhile>& whiles, bool with_same) const {
  const auto states_of = [this](const Seen& seen) {
    States states;
    for (uint32_t state = 0; state < states_; ++state) states[state] = seen.values[state] != 0;
    return states;
  };
  const auto is_flag = [&](const Seen& seen) {
    return seen.number.width == 1 && seen.parts.size() == 1 && seen.parts.front().width == 1 &&
           (with_same || !seen.is_same);
  };
  std::vector<States> states_while;
  for (const StatesWhile& one : whiles) {
    States& states = states_while.emplace_back();
    for (const uint32_t state : one.states) states[state] = true;
  }
  std::vector<std::pair<size_t, Relation>> found;
  for (const Seen& a : old_) {
    for (const Seen& b : new_) {
      if (!is_flag(a) || !is_flag(b) || comparison_.Late()) continue;
      const States of_a = states_of(a), differ = of_a ^ states_of(b);
      for (size_t i = 0; i < whiles.size(); ++i) {
        if (whiles[i].bit.bit == a.number || whiles[i].bit.bit == b.number) continue;
        const States& here = states_while[i];
        const bool are_equal = (here & differ).none(), are_opposite = (here & differ) == here;
        // Where one of them stays what it is, each is an invariant of its version.
        const bool changes = (here & of_a).any() && (here & of_a) != here;
        if (!changes || are_equal == are_opposite) continue;
        Relation relation{.kind = Relation::Kind::kAmong, .number = a.number, .other = b.number, .values = {}};
        relation.values = are_equal ? std::vector<std::pair<uint64_t, uint64_t>>{{0, 0}, {1, 1}}
                                    : std::vector<std::pair<uint64_t, uint64_t>>{{0, 1}, {1, 0}};
        relation.whiles = {whiles[i].bit};
        found.emplace_back(here.count(), std::move(relation));
      }
    }
  }
  std::ranges::stable_sort(found, std::greater<>(), &std::pair<size_t, Relation>::first);
  found.resize(std::min(found.size(), kMostBitsWhile));
  std::vector<Relation> relations;
  for (auto& [count, relation] : found) relations.push_back(std::move(relation));
  return relations;
}

std::vector<Relation> Observed::Relations(bool with_same) const {
  std::vector<uint32_t> all(states_);
  for (uint32_t i = 0; i < states_; ++i) all[i] = i;
  const std::vector<StatesWhile> whiles = Whiles(all);
  size_t looked_at_two = 0;
  std::vector<Relation> always, while_two, sometimes, seldom;
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
      for (const StatesWhile& one : whiles) {
        linear = LinearOf(one.states, a, b);
        if (!linear) linear = LinearOf(one.states, b, a);
        if (!linear) continue;
        linear->whiles = {one.bit};
        sometimes.push_back(std::move(*linear));
      }
      if (++looked_at_two > kMostWhileTwo) continue;
      AddWhileTwo(whiles, a, b, while_two);
      AddWhileTwo(whiles, b, a, while_two);
    }
  }
  AddSums(all, old_, new_, always);
  AddSums(all, new_, old_, always);
  std::ranges::move(while_two, std::back_inserter(always));
  std::ranges::move(sometimes, std::back_inserter(always));
  std::ranges::move(BitsWhile(whiles, with_same), std::back_inserter(always));
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
