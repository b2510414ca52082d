#include "transpiler/prove/properties/reachable.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostWords = 1500;          // that count
constexpr size_t kMostDropped = 24;          // literals of one clause that are tried to do without
constexpr size_t kMostObligations = 20'000;  // after each other in one layer

/// A literal is 2 * bit + value; a cube is what several bits are at once, ascending.
using Literal = uint32_t;
using Cube = std::vector<Literal>;

bool Contains(const Cube& cube, const Cube& part) { return std::ranges::includes(cube, part); }

enum class Found : uint8_t {
  kUnreachable,
  kMoreWords,  // the search needs some that did not count
  kUnknown
};

class Search {
 public:
  /// `words`: those that count.
  Search(const ReachQuestion& question, solver::BitSolver& bits, const std::vector<StateWord>& words)
      : question_(question), terms_(question.terms), solver_(bits), words_(words) {
    for (uint32_t i = 0; i < words.size(); ++i) Track(i);
  }

  Found Run();
  /// Of kMoreWords.
  const std::set<terms::TermId>& missing() const { return missing_; }
  /// Of kUnreachable.
  FoundFacts Facts() const;

 private:
  struct Bit {
    uint32_t word;
    uint8_t bit;
    terms::TermId now;
    std::optional<bool> start;  // none: after power-on it may be either
  };
  /// A cube from which the bad one can be reached, by way of the obligation `next`.
  struct Obligation {
    uint32_t layer;
    Cube cube;
    size_t next;
    std::vector<terms::TermId> missing;
  };

  void Track(uint32_t word);
  void AddLayer();
  uint32_t Top() const { return static_cast<uint32_t>(layers_.size() - 1); }
  terms::TermId Now(Literal literal) const { return Signed(bits_[literal / 2].now, literal); }
  terms::TermId Signed(terms::TermId bit, Literal literal) const { return literal % 2 != 0 ? bit : terms_.Not(bit); }
  terms::TermId Next(Literal literal, size_t part);
  bool MeetsStart(const Cube& cube) const;
  Cube AwayFromStart(Cube cube, const Cube& whole) const;

  /// Whether all conditions can hold in a state of the layer; the first ones are `conditions`, as needed() counts.
  solver::Answer Ask(std::vector<terms::TermId> conditions, uint32_t layer);
  /// Whether a state of the layer that is not in the cube has a successor in it: kNever gives what of it is needed.
  solver::Answer Precedes(const Cube& cube, uint32_t layer, size_t& part, Cube& needed);
  /// From the model of the last question: the bits that are enough for `target`.
  bool Lift(std::span<const terms::TermId> targets, Obligation& obligation);
  bool Block(Cube cube, std::vector<terms::TermId> missing);
  bool BlockOne(Cube cube, uint32_t layer);
  bool Propagate();
  void Learn(const Cube& cube, uint32_t layer);
  bool IsBlocked(const Cube& cube, uint32_t layer) const;

  const ReachQuestion& question_;
  terms::Terms& terms_;
  solver::BitSolver& solver_;
  const std::vector<StateWord>& words_;
  std::vector<Bit> bits_;
  std::map<terms::TermId, uint32_t> first_bit_;  // by variable of a word that counts
  std::vector<std::vector<Cube>> layers_;        // those that are forbidden up to this layer and no further
  std::vector<terms::TermId> active_;            // by layer: its facts, and those of higher ones, are assumed
  std::vector<Obligation> obligations_;
  std::set<terms::TermId> missing_;
  bool unknown_ = false;
};

void Search::Track(uint32_t word) {
  const StateWord& state = words_[word];
  first_bit_[state.now] = static_cast<uint32_t>(bits_.size());
  for (uint8_t bit = 0; bit < terms_.Width(state.now); ++bit) {
    const terms::TermId at_start = terms_.Extract(state.start, bit, 1);
    bits_.push_back({.word = word, .bit = bit, .now = terms_.Extract(state.now, bit, 1), .start = {}});
    if (terms_.IsConst(at_start)) bits_.back().start = terms_.IsTrue(at_start);
  }
}

terms::TermId Search::Next(Literal literal, size_t part) {
  const Bit& bit = bits_[literal / 2];
  return Signed(terms_.Extract(words_[bit.word].next[part], bit.bit, 1), literal);
}

bool Search::MeetsStart(const Cube& cube) const {
  return std::ranges::none_of(cube, [this](Literal literal) {
    const std::optional<bool>& start = bits_[literal / 2].start;
    return start && *start != (literal % 2 != 0);
  });
}

Cube Search::AwayFromStart(Cube cube, const Cube& whole) const {
  if (!MeetsStart(cube)) return cube;
  for (const Literal literal : whole) {
    if (MeetsStart({literal})) continue;
    cube.insert(std::ranges::lower_bound(cube, literal), literal);
    break;
  }
  return cube;
}

void Search::AddLayer() {
  layers_.emplace_back();
  active_.push_back(terms_.Variable("layer " + std::to_string(terms_.variable_count()), 1));
  if (layers_.size() > 1) return;
  for (uint32_t i = 0; i < bits_.size(); ++i) {
    if (!bits_[i].start) continue;
    solver_.Assume(terms_.Or(terms_.Not(active_[0]), Now(2 * i + (*bits_[i].start ? 1 : 0))));
  }
}

solver::Answer Search::Ask(std::vector<terms::TermId> conditions, uint32_t layer) {
  for (uint32_t i = layer; i <= (layer == 0 ? 0 : Top()); ++i) conditions.push_back(active_[i]);
  const uint32_t rest_ms = question_.rest_ms();
  const solver::Answer answer =
      rest_ms == 0 ? solver::Answer::kUnknown : solver_.Check(conditions, solver::Limit::Clock(rest_ms));
  unknown_ = unknown_ || answer == solver::Answer::kUnknown;
  return answer;
}

solver::Answer Search::Precedes(const Cube& cube, uint32_t layer, size_t& part, Cube& needed) {
  const terms::TermId outside = terms_.Variable("outside " + std::to_string(terms_.variable_count()), 1);
  terms::TermId clause = terms_.Not(outside);
  for (const Literal literal : cube) clause = terms_.Or(clause, terms_.Not(Now(literal)));
  solver_.Assume(clause);
  std::vector<bool> used(cube.size());
  solver::Answer answer = solver::Answer::kNever;
  for (part = 0; part < question_.parts; ++part) {
    std::vector<terms::TermId> conditions;
    bool never = false;
    for (const Literal literal : cube) {
      conditions.push_back(Next(literal, part));
      if (!terms_.IsFalse(conditions.back())) continue;
      never = true;
      used[conditions.size() - 1] = true;
      break;
    }
    if (never) continue;
    conditions.push_back(outside);
    answer = Ask(conditions, layer);
    if (answer != solver::Answer::kNever) break;
    for (size_t i = 0; i < cube.size(); ++i) used[i] = used[i] || solver_.needed()[i];
  }
  solver_.Assume(terms_.Not(outside));  // it is asked only here; a model stays
  if (answer != solver::Answer::kNever) return answer;
  needed.clear();
  for (size_t i = 0; i < cube.size(); ++i) {
    if (used[i]) needed.push_back(cube[i]);
  }
  needed = AwayFromStart(std::move(needed), cube);
  return answer;
}

bool Search::Lift(std::span<const terms::TermId> targets, Obligation& obligation) {
  struct Source {
    terms::TermId is;  // the bit has its value
    std::optional<Literal> literal;
    terms::TermId missing;
  };
  std::vector<Source> sources;
  for (const terms::TermId id : terms::ConeAboveFunctions(terms_, targets)) {
    const terms::TermKind kind = terms_[id].kind;
    if (kind != terms::TermKind::kVariable && kind != terms::TermKind::kApply) continue;
    const uint64_t value = solver_.ValueOf(id);
    const auto counted = first_bit_.find(id);
    const bool may_count = counted == first_bit_.end() && question_.state_of(id).has_value();
    for (uint8_t bit = 0; bit < terms_.Width(id); ++bit) {
      const bool one = (value >> bit & 1) != 0;
      const terms::TermId is = terms_.Extract(id, bit, 1);
      Source source{.is = one ? is : terms_.Not(is), .literal = {}, .missing = {}};
      if (counted != first_bit_.end()) {
        source.literal = 2 * (counted->second + bit) + (one ? 1 : 0);
      } else if (may_count) {
        source.missing = id;
      }
      sources.push_back(source);
    }
  }
  terms::TermId all = terms_.Bit(true);
  for (const terms::TermId target : targets) all = terms_.And(all, target);
  // Twice: what the first answer needs is often more than it has to be.
  for (int round = 0; round < 2; ++round) {
    std::vector<terms::TermId> conditions;
    for (const Source& source : sources) conditions.push_back(source.is);
    conditions.push_back(terms_.Not(all));
    const uint32_t rest_ms = question_.rest_ms();
    if (rest_ms == 0 || solver_.Check(conditions, solver::Limit::Clock(rest_ms)) != solver::Answer::kNever) {
      unknown_ = true;
      return false;
    }
    std::vector<Source> kept;
    for (size_t i = 0; i < sources.size(); ++i) {
      if (solver_.needed()[i]) kept.push_back(sources[i]);
    }
    sources = std::move(kept);
  }
  for (const Source& source : sources) {
    if (source.literal) obligation.cube.push_back(*source.literal);
    if (source.missing.valid()) obligation.missing.push_back(source.missing);
  }
  std::ranges::sort(obligation.cube);
  return true;
}

bool Search::IsBlocked(const Cube& cube, uint32_t layer) const {
  for (size_t i = layer; i < layers_.size(); ++i) {
    if (std::ranges::any_of(layers_[i], [&](const Cube& known) { return Contains(cube, known); })) return true;
  }
  return false;
}

void Search::Learn(const Cube& cube, uint32_t layer) {
  for (uint32_t i = 1; i <= layer; ++i)
    std::erase_if(layers_[i], [&](const Cube& known) { return Contains(known, cube); });
  layers_[layer].push_back(cube);
  terms::TermId clause = terms_.Not(active_[layer]);
  for (const Literal literal : cube) clause = terms_.Or(clause, terms_.Not(Now(literal)));
  solver_.Assume(clause);
}

/// The cube has no predecessor in the layer below `layer`: less of it is tried, and higher layers.
bool Search::BlockOne(Cube cube, uint32_t layer) {
  size_t part = 0, tries = 0;
  Cube needed;
  for (size_t i = 0; i < cube.size() && cube.size() > 1 && tries < kMostDropped; ++tries) {
    Cube smaller = cube;
    smaller.erase(smaller.begin() + static_cast<ptrdiff_t>(i));
    if (!MeetsStart(smaller)) {
      const solver::Answer answer = Precedes(smaller, layer - 1, part, needed);
      if (answer == solver::Answer::kUnknown) return false;
      if (answer == solver::Answer::kNever) {
        cube = needed;
        continue;
      }
    }
    ++i;
  }
  while (layer < Top()) {
    const solver::Answer answer = Precedes(cube, layer, part, needed);
    if (answer == solver::Answer::kUnknown) return false;
    if (answer == solver::Answer::kPossible) break;
    ++layer;
  }
  Learn(cube, layer);
  return true;
}

/// false: the bad states may be reached, or it is not known.
bool Search::Block(Cube cube, std::vector<terms::TermId> missing) {
  obligations_.clear();
  const auto later = [this](size_t a, size_t b) {
    return obligations_[a].layer != obligations_[b].layer ? obligations_[a].layer > obligations_[b].layer : a < b;
  };
  std::priority_queue<size_t, std::vector<size_t>, decltype(later)> open(later);
  const auto add = [&](Obligation obligation) {
    obligations_.push_back(std::move(obligation));
    open.push(obligations_.size() - 1);
  };
  constexpr size_t kNone = ~size_t{0};
  add({.layer = Top(), .cube = std::move(cube), .next = kNone, .missing = std::move(missing)});
  while (!open.empty()) {
    const size_t at = open.top();
    const uint32_t layer = obligations_[at].layer;
    const Cube now = obligations_[at].cube;
    if (layer == 0 || MeetsStart(now)) {
      for (size_t i = at; i != kNone; i = obligations_[i].next)
        missing_.insert(obligations_[i].missing.begin(), obligations_[i].missing.end());
      return false;
    }
    open.pop();
    if (obligations_.size() > kMostObligations) {
      unknown_ = true;
      return false;
    }
    if (IsBlocked(now, layer)) {
      if (layer < Top())
        add({.layer = layer + 1, .cube = now, .next = obligations_[at].next, .missing = obligations_[at].missing});
      continue;
    }
    size_t part = 0;
    Cube needed;
    switch (Precedes(now, layer - 1, part, needed)) {
      case solver::Answer::kUnknown:
        return false;
      case solver::Answer::kNever:
        if (!BlockOne(std::move(needed), layer)) return false;
        if (layer < Top())
          add({.layer = layer + 1, .cube = now, .next = obligations_[at].next, .missing = obligations_[at].missing});
        break;
      case solver::Answer::kPossible: {
        Obligation before{.layer = layer - 1, .cube = {}, .next = at, .missing = {}};
        std::vector<terms::TermId> targets;
        for (const Literal literal : now) targets.push_back(Next(literal, part));
        if (!Lift(targets, before)) return false;
        add(std::move(before));
        open.push(at);
        break;
      }
    }
  }
  return true;
}

/// Whether two layers have become one.
bool Search::Propagate() {
  for (uint32_t layer = 1; layer < Top(); ++layer) {
    const std::vector<Cube> cubes = layers_[layer];
    for (const Cube& cube : cubes) {
      size_t part = 0;
      Cube needed;
      const solver::Answer answer = Precedes(cube, layer, part, needed);
      if (answer == solver::Answer::kUnknown) return false;
      if (answer == solver::Answer::kNever) Learn(cube, layer + 1);
    }
    if (layers_[layer].empty()) return true;
  }
  return false;
}

Found Search::Run() {
  AddLayer();
  AddLayer();
  while (!unknown_) {
    for (;;) {
      const solver::Answer answer = Ask({question_.bad}, Top());
      if (answer == solver::Answer::kNever) break;
      if (answer == solver::Answer::kUnknown) return Found::kUnknown;
      Obligation bad{.layer = Top(), .cube = {}, .next = 0, .missing = {}};
      if (!Lift({&question_.bad, 1}, bad)) return Found::kUnknown;
      if (!Block(std::move(bad.cube), std::move(bad.missing)))
        return unknown_ || missing_.empty() ? Found::kUnknown : Found::kMoreWords;
    }
    AddLayer();
    if (Propagate()) return Found::kUnreachable;
    if (question_.progress) {
      size_t facts = 0;
      for (const std::vector<Cube>& layer : layers_) facts += layer.size();
      question_.progress("states after " + std::to_string(Top()) + " steps: " + std::to_string(bits_.size()) +
                         " bits, " + std::to_string(facts) + " facts");
    }
  }
  return Found::kUnknown;
}

FoundFacts Search::Facts() const {
  // After the empty layer.
  size_t begin = 1;
  while (!layers_[begin].empty()) ++begin;
  FoundFacts facts{.words = words_, .forbidden = {}};
  for (size_t i = begin; i < layers_.size(); ++i) {
    for (const Cube& cube : layers_[i]) {
      facts.forbidden.emplace_back();
      for (const Literal literal : cube)
        facts.forbidden.back().push_back({bits_[literal / 2].word, bits_[literal / 2].bit, literal % 2 != 0});
    }
  }
  return facts;
}

terms::TermId HoldsOf(terms::Terms& terms, const std::vector<StateBit>& fact,
                      const std::function<terms::TermId(uint32_t word)>& value) {
  terms::TermId clause = terms.Bit(false);
  for (const StateBit& bit : fact) {
    const terms::TermId is = terms.Extract(value(bit.word), bit.bit, 1);
    clause = terms.Or(clause, bit.value ? terms.Not(is) : is);
  }
  return clause;
}

/// The facts hold after power-on, every part keeps them, and where they hold nothing is bad.
bool AreProof(const ReachQuestion& question, const FoundFacts& facts) {
  terms::Terms& terms = question.terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);  // it knows nothing of the search
  std::vector<terms::TermId> conditions = question.known;
  terms::TermId wrong_at_start = terms.Bit(false);
  for (const std::vector<StateBit>& fact : facts.forbidden) {
    conditions.push_back(HoldsOf(terms, fact, [&](uint32_t word) { return facts.words[word].now; }));
    const terms::TermId at_start = HoldsOf(terms, fact, [&](uint32_t word) { return facts.words[word].start; });
    wrong_at_start = terms.Or(wrong_at_start, terms.Not(at_start));
  }
  const auto never = [&](std::span<const terms::TermId> all) {
    const uint32_t rest_ms = question.rest_ms();
    return rest_ms != 0 && solver->Check(all, solver::Limit::Clock(rest_ms)) == solver::Answer::kNever;
  };
  if (!terms.IsFalse(wrong_at_start) && !never({&wrong_at_start, 1})) return false;
  conditions.push_back(question.bad);
  if (!never(conditions)) return false;
  for (size_t part = 0; part < question.parts; ++part) {
    terms::TermId broken = terms.Bit(false);
    for (const std::vector<StateBit>& fact : facts.forbidden) {
      const terms::TermId kept = HoldsOf(terms, fact, [&](uint32_t word) { return facts.words[word].next[part]; });
      broken = terms.Or(broken, terms.Not(kept));
    }
    conditions.back() = broken;
    if (!terms.IsFalse(broken) && !never(conditions)) return false;
  }
  return true;
}

}  // namespace

std::optional<FoundFacts> ShowUnreachable(const ReachQuestion& question) {
  const std::unique_ptr<solver::BitSolver> bits = solver::LoadBitSolver(question.terms);
  if (!bits) return std::nullopt;
  std::vector<StateWord> words;
  for (const terms::TermId id : terms::ConeAboveFunctions(question.terms, {&question.bad, 1})) {
    if (question.terms[id].kind != terms::TermKind::kVariable) continue;
    if (std::optional<StateWord> word = question.state_of(id)) words.push_back(std::move(*word));
  }
  for (const terms::TermId known : question.known) bits->Assume(known);
  for (;;) {
    Search search(question, *bits, words);
    switch (search.Run()) {
      case Found::kUnknown:
        return std::nullopt;
      case Found::kUnreachable: {
        FoundFacts facts = search.Facts();
        if (!AreProof(question, facts)) return std::nullopt;
        return facts;
      }
      case Found::kMoreWords:
        break;
    }
    for (const terms::TermId variable : search.missing()) words.push_back(*question.state_of(variable));
    if (words.size() > kMostWords) return std::nullopt;
  }
}

}  // namespace plcxx::prove::properties
