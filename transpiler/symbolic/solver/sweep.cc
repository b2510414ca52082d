#include "transpiler/symbolic/solver/sweep.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "transpiler/support/mixed.h"
#include "transpiler/symbolic/solver/counterparts.h"
#include "transpiler/symbolic/terms/aimed_values.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/form.h"
#include "transpiler/symbolic/terms/likely_values.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::solver {
namespace {

constexpr int kVectors = 24;
constexpr int kLikelyVectors = 24;
constexpr int kMostAimedVectors = 256;
constexpr uint8_t kOftenEnough = 3;             // that a condition holds, and that it does not
constexpr uint64_t kAimedShare = 16;            // of the time
constexpr size_t kMostCandidates = 3;           // of one class that a term is compared with
constexpr size_t kMostTermsToRefine = 200'000;  // a counterexample is evaluated on cones up to this size
constexpr size_t kMostTermsToSpread = 2'000'000;
constexpr size_t kMostTermsOfForm = 1000;
constexpr uint32_t kShortShare = 8;  // of the time for a pair: for each of them before any has more
constexpr size_t kMostRefutedFirst = 20;
constexpr size_t kMostRefuted = 400;             // questions that were answered by "possible"; then no more are asked
constexpr size_t kMostCounterparts = 1'000'000;  // pairs

/// With what a term is compared.
enum class Candidates : uint8_t {
  kCounterparts,  // what stands at its place in the other side
  kAlike          // what has its values on the samples
};

/// Not what one of several conditions chooses: there are as many of those as bits that are written.
bool IsCondition(const terms::Term& term) {
  using enum terms::TermKind;
  return term.kind == kEq || term.kind == kUlt || term.kind == kSlt ||
         (term.width == 1 && (term.kind == kAnd || term.kind == kOr));
}

enum Side : uint8_t { kNone = 0, kSideA = 1, kSideB = 2, kBoth = 3 };

class Sweeper {
 public:
  Sweeper(terms::Terms& terms, Solver& solver, std::span<const TermPair> pairs, const SweepLimits& limits)
      : terms_(terms), solver_(solver), pairs_(pairs), limits_(limits), deadline_(limits.clock, limits.total_ms) {}

  std::vector<Verdict> Run();

 private:
  void MarkCones();
  /// false: it was not done in time.
  bool Simulate();
  /// More values, by which conditions hold that did not yet.
  void SimulateRare(terms::LikelyValues& likely);
  void Refine(terms::TermId one, terms::TermId other, size_t most_terms);
  void EvaluateVector(const std::function<uint64_t(terms::TermId variable)>& variable);
  void EvaluateLikelyVector(int vector, terms::LikelyValues& likely);
  void AddToSignature(terms::TermId id, uint64_t value);
  void SweepTerm(terms::TermId id, Candidates candidates);
  /// Older terms.
  std::vector<terms::TermId> CandidatesOf(terms::TermId id, Candidates candidates) const;
  bool AllAreOne() const;
  /// What `id` is shown to be, else `id` with its operands as they are represented now.
  terms::TermId Rebuilt(terms::TermId id);
  void AskAboutPairs(std::vector<Verdict>& verdicts, uint32_t milliseconds);
  /// What a question about a pair has shown to be equal is one from then on; false: nothing has.
  bool TakeOver(const std::vector<Verdict>& verdicts);
  Answer Differ(terms::TermId a, terms::TermId b, uint32_t milliseconds);
  bool Late() const { return deadline_.IsOver(); }
  terms::TermId Representative(terms::TermId id) const {
    return id.index < representative_.size() && representative_[id.index].valid() ? representative_[id.index] : id;
  }

  terms::Terms& terms_;
  Solver& solver_;
  std::span<const TermPair> pairs_;
  std::vector<TermPair> open_pairs_;
  size_t refuted_ = 0, refuted_first_ = 0;
  const SweepLimits& limits_;
  const Deadline deadline_;
  std::vector<uint8_t> sides_;       // by TermId
  std::vector<terms::TermId> cone_;  // of the pairs that are not one term, operands first
  std::vector<uint64_t> signatures_, values_;
  std::array<std::vector<uint8_t>, 2> counts_;  // by TermId: how often a condition was 0 and 1
  std::vector<uint64_t> class_of_;              // by TermId: the signature before the first question
  std::vector<terms::TermId> representative_;
  std::vector<terms::TermId> equal_to_;  // by TermId: an earlier one, where a question has shown it
  std::vector<TermPair> asked_;          // by pair: what was asked about last
  uint32_t asked_ms_ = 0;                // how long each such question might take
  std::unordered_map<uint64_t, std::vector<terms::TermId>> classes_;  // looked up only
  CounterpartsOfTerms counterparts_;
  terms::Random random_{0x9E3779B97F4A7C15};
};

void Sweeper::MarkCones() {
  sides_.assign(terms_.size(), kNone);
  for (const Side side : {kSideA, kSideB}) {
    std::vector<terms::TermId> roots;
    for (const TermPair& pair : pairs_) {
      if (pair.a != pair.b) roots.push_back(side == kSideA ? pair.a : pair.b);
    }
    for (const terms::TermId id : terms::ConeOf(terms_, roots)) sides_[id.index] |= side;
  }
  for (uint32_t i = 0; i < sides_.size(); ++i) {
    if (sides_[i] != kNone) cone_.emplace_back(i);
  }
}

void Sweeper::EvaluateVector(const std::function<uint64_t(terms::TermId variable)>& variable) {
  for (const terms::TermId id : cone_) {
    const uint64_t value = terms::EvaluateTerm(
        terms_, terms_[id], [this](terms::TermId operand) { return values_[operand.index]; },
        [&](uint32_t) { return variable(id); });
    AddToSignature(id, value);
  }
}

void Sweeper::AddToSignature(terms::TermId id, uint64_t value) {
  values_[id.index] = value;
  uint64_t& signature = signatures_[id.index];
  signature = support::Mixed(signature, value);
  uint8_t& count = counts_[value & 1][id.index];
  if (count < kOftenEnough) ++count;
}

void Sweeper::EvaluateLikelyVector(int vector, terms::LikelyValues& likely) {
  for (const terms::TermId id : cone_) {
    const terms::Term& term = terms_[id];
    const uint64_t value = terms::EvaluateTerm(
        terms_, term, [this](terms::TermId operand) { return values_[operand.index]; },
        [&](uint32_t) { return likely.Of(vector, id); });
    AddToSignature(id, term.kind == terms::TermKind::kApply ? likely.ResultOf(vector, term, value) : value);
  }
}

/// Values as programs have them: bits of every density, and numbers that are small, large or anything.
bool Sweeper::Simulate() {
  values_.assign(terms_.size(), 0);
  signatures_.assign(terms_.size(), 0);
  counts_.fill(std::vector<uint8_t>(terms_.size(), 0));
  for (int vector = 0; vector < kVectors; ++vector) {
    if (Late()) return false;
    const uint64_t density = vector % 4 == 0 ? 128 : vector % 4 == 1 ? 16 : vector % 4 == 2 ? 240 : 64;
    EvaluateVector([&](terms::TermId variable) -> uint64_t {
      if (terms_.Width(variable) == 1) return (random_.Next() & 255) < density ? 1 : 0;
      switch (random_.Next() % 4) {
        case 0:
          return 0;
        case 1:
          return random_.Next() % 5;
        case 2:
          return ~uint64_t{0} - random_.Next() % 3;
        default:
          return random_.Next();
      }
    });
  }
  terms::LikelyValues likely(terms_);
  likely.NoteConstants(cone_);
  likely.NoteComparisons(cone_);
  for (int vector = 0; vector < kLikelyVectors; ++vector) {
    if (Late()) return false;
    EvaluateLikelyVector(vector, likely);
  }
  SimulateRare(likely);
  return true;
}

void Sweeper::SimulateRare(terms::LikelyValues& likely) {
  const Deadline deadline(limits_.clock, limits_.total_ms / kAimedShare);
  terms::AimedValues aimed(terms_, random_.Next());
  int vectors = 0;
  // From the last ones, which depend on most of what is before them.
  for (auto id = cone_.rbegin(); id != cone_.rend() && vectors < kMostAimedVectors && !deadline.IsOver(); ++id) {
    if (!IsCondition(terms_[*id])) continue;
    for (const uint64_t value : {0, 1}) {
      if (counts_[value][id->index] >= kOftenEnough) continue;
      aimed.AimAt(*id, value);
      EvaluateVector([&](terms::TermId variable) { return aimed.Of(variable, likely.Of(vectors, variable)); });
      ++vectors;
    }
  }
}

/// The values by which the solver told two terms apart tell others apart, too. Classes stay as they are; who is
/// compared looks at the signatures as well.
void Sweeper::Refine(terms::TermId one, terms::TermId other, size_t most_terms) {
  if (cone_.size() > most_terms) return;
  // What the question did not depend on may be anything.
  std::unordered_map<uint32_t, uint64_t> known;                           // by variable; looked up only
  std::map<std::pair<uint32_t, std::vector<uint64_t>>, uint64_t> result;  // of a function, by its arguments
  const auto has_no_meaning = [this](const terms::Term& term) {
    return term.kind == terms::TermKind::kApply && terms_.Info(terms::FunctionId(term.a)).evaluate == nullptr;
  };
  for (const terms::TermId id : terms::ConeOf(terms_, std::array{one, other})) {
    const terms::Term& term = terms_[id];
    if (term.kind == terms::TermKind::kVariable) known.emplace(term.a, solver_.ValueOf(id));
    if (!has_no_meaning(term)) continue;
    std::vector<uint64_t> arguments;
    for (const terms::TermId argument : terms_.Arguments(term)) arguments.push_back(solver_.ValueOf(argument));
    result.emplace(std::pair(term.a, std::move(arguments)), solver_.ValueOf(id));
  }
  const auto variable = [&](uint32_t number, uint8_t width) {
    const auto at = known.find(number);
    return at != known.end() ? at->second : width == 1 ? random_.Next() & 1 : random_.Next();
  };
  for (const terms::TermId id : cone_) {
    const terms::Term& term = terms_[id];
    uint64_t value = terms::EvaluateTerm(
        terms_, term, [this](terms::TermId operand) { return values_[operand.index]; },
        [&](uint32_t number) { return variable(number, term.width); });
    if (!result.empty() && has_no_meaning(term)) {
      std::vector<uint64_t> arguments;
      for (const terms::TermId argument : terms_.Arguments(term)) arguments.push_back(values_[argument.index]);
      const auto at = result.find(std::pair(term.a, std::move(arguments)));
      if (at != result.end()) value = at->second;
    }
    AddToSignature(id, value);
  }
}

Answer Sweeper::Differ(terms::TermId a, terms::TermId b, uint32_t milliseconds) {
  const terms::TermId differ = terms_.Ne(a, b);
  if (terms_.IsFalse(differ)) return Answer::kNever;
  const std::string form =
      limits_.answered == nullptr ? std::string() : terms::FormOf(terms_, differ, kMostTermsOfForm).value_or("");
  if (form.empty()) return solver_.Check({&differ, 1}, deadline_.LimitFor(milliseconds));
  Answered& known = (*limits_.answered)[form];
  // Where it is possible, who asks wants the values, too.
  if (known.answer != Answer::kPossible && known.Settles(milliseconds)) return known.answer;
  const Limit limit = deadline_.LimitFor(milliseconds);
  known.answer = solver_.Check({&differ, 1}, limit);
  known.milliseconds = limit.effort_ms;
  return known.answer;
}

terms::TermId Sweeper::Rebuilt(terms::TermId id) {
  if (const terms::TermId equal = equal_to_[id.index]; equal.valid()) return Representative(equal);
  const terms::Term term = terms_[id];
  std::vector<terms::TermId> operands;
  bool changed = false;
  terms_.ForEachOperand(term, [&](terms::TermId operand) {
    operands.push_back(Representative(operand));
    changed = changed || operands.back() != operand;
  });
  return changed ? Representative(terms_.Rebuild(term, operands)) : id;
}

std::vector<terms::TermId> Sweeper::CandidatesOf(terms::TermId id, Candidates candidates) const {
  if (candidates == Candidates::kCounterparts) {
    const auto at = counterparts_.find(id.index);
    return at == counterparts_.end() ? std::vector<terms::TermId>() : at->second;
  }
  const auto at = classes_.find(class_of_[id.index]);
  return at == classes_.end() ? std::vector<terms::TermId>() : at->second;
}

void Sweeper::SweepTerm(terms::TermId id, Candidates candidates) {
  const uint8_t width = terms_.Width(id);
  terms::TermId now = Rebuilt(id);
  // What became a term of the other side by its operands alone is found; a constant is its own best form; and what both
  // sides have in common needs no question.
  const bool found = now.index < sides_.size() && (sides_[now.index] | sides_[id.index]) == kBoth;
  // The second side looks for its counterpart in the first; the other way round pays now and then only.
  const bool first_side = sides_[id.index] == kSideA;
  const size_t refuted = first_side ? refuted_first_ : refuted_;
  const bool asks =
      !found && !terms_.IsConst(now) && !Late() && refuted < (first_side ? kMostRefutedFirst : kMostRefuted);
  if (asks) {
    size_t tried = 0;
    for (const terms::TermId member : CandidatesOf(id, candidates)) {
      const terms::TermId other = Representative(member);
      if (other == now) break;
      // An answer to the question before may have told them apart.
      if (signatures_[member.index] != signatures_[id.index]) continue;
      if (terms_.Width(other) != width || ++tried > kMostCandidates) continue;
      // Two terms of one side are rarely worth a question.
      if (sides_[member.index] == sides_[id.index]) continue;
      const Answer answer = Differ(now, other, limits_.inner_ms);
      if (answer == Answer::kNever) {
        now = other;
        equal_to_[id.index] = member;
        break;
      }
      if (answer == Answer::kPossible) {
        ++(first_side ? refuted_first_ : refuted_);
        Refine(now, other, kMostTermsToRefine);
      }
    }
  }
  representative_[id.index] = now;
  if (candidates == Candidates::kAlike) classes_[class_of_[id.index]].push_back(id);
}

bool Sweeper::AllAreOne() const {
  return std::ranges::all_of(pairs_,
                             [this](const TermPair& pair) { return Representative(pair.a) == Representative(pair.b); });
}

std::vector<Verdict> Sweeper::Run() {
  std::vector<Verdict> verdicts(pairs_.size(), Verdict::kEqual);
  const auto open = static_cast<size_t>(std::ranges::count_if(pairs_, [](const TermPair& p) { return p.a != p.b; }));
  if (open == 0) return verdicts;
  MarkCones();
  if (!Simulate()) {
    for (size_t i = 0; i < pairs_.size(); ++i) {
      if (pairs_[i].a != pairs_[i].b) verdicts[i] = Verdict::kUndecided;
    }
    return verdicts;
  }
  if (limits_.any_values_count) {
    // What random values tell apart needs no question; the cones of the rest are smaller.
    std::vector<TermPair> rest(pairs_.begin(), pairs_.end());
    for (size_t i = 0; i < rest.size(); ++i) {
      if (signatures_[rest[i].a.index] == signatures_[rest[i].b.index]) continue;
      verdicts[i] = Verdict::kDifferent;
      rest[i].b = rest[i].a;
    }
    open_pairs_ = std::move(rest);
    pairs_ = open_pairs_;
    cone_.clear();
    MarkCones();
  }
  class_of_ = signatures_;
  representative_.assign(terms_.size(), terms::TermId());
  equal_to_.assign(terms_.size(), terms::TermId());
  counterparts_ = Counterparts(terms_, pairs_, kMostCounterparts, [this](terms::TermId a, terms::TermId b) {
    return signatures_[a.index] == signatures_[b.index];
  });
  for (const terms::TermId id : cone_) SweepTerm(id, Candidates::kCounterparts);
  if (!AllAreOne()) {
    for (const terms::TermId id : cone_) SweepTerm(id, Candidates::kAlike);
  }
  asked_.resize(pairs_.size());
  // What is soon shown makes the others easier.
  for (const uint32_t milliseconds : {limits_.pair_ms / kShortShare, limits_.pair_ms}) {
    AskAboutPairs(verdicts, milliseconds);
    while (!Late() && TakeOver(verdicts)) AskAboutPairs(verdicts, milliseconds);
  }
  return verdicts;
}

void Sweeper::AskAboutPairs(std::vector<Verdict>& verdicts, uint32_t milliseconds) {
  const auto open = static_cast<size_t>(std::ranges::count_if(pairs_, [](const TermPair& p) { return p.a != p.b; }));
  size_t done = 0;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].a == pairs_[i].b) continue;
    if (limits_.progress) limits_.progress(++done, open);
    const terms::TermId a = Representative(pairs_[i].a), b = Representative(pairs_[i].b);
    const bool is_known =
        verdicts[i] == Verdict::kDifferent ||
        (a == asked_[i].a && b == asked_[i].b && (verdicts[i] == Verdict::kEqual || milliseconds == asked_ms_));
    asked_[i] = {a, b};
    if (is_known) continue;
    if (a == b) {
      verdicts[i] = Verdict::kEqual;
      continue;
    }
    // An answer to another pair may show this one, too.
    if (limits_.any_values_count && signatures_[pairs_[i].a.index] != signatures_[pairs_[i].b.index]) {
      verdicts[i] = Verdict::kDifferent;
      continue;
    }
    const Answer answer = Late() ? Answer::kUnknown : Differ(a, b, milliseconds);
    if (limits_.any_values_count && answer == Answer::kPossible) Refine(a, b, kMostTermsToSpread);
    verdicts[i] = answer == Answer::kNever      ? Verdict::kEqual
                  : answer == Answer::kPossible ? Verdict::kDifferent
                                                : Verdict::kUndecided;
  }
  asked_ms_ = milliseconds;
}

bool Sweeper::TakeOver(const std::vector<Verdict>& verdicts) {
  if (std::ranges::find(verdicts, Verdict::kUndecided) == verdicts.end()) return false;
  bool is_any = false;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const auto [first, last] = std::minmax(pairs_[i].a, pairs_[i].b);
    if (verdicts[i] != Verdict::kEqual || Representative(first) == Representative(last)) continue;
    equal_to_[last.index] = first;
    is_any = true;
  }
  if (!is_any) return false;
  for (const terms::TermId id : cone_) representative_[id.index] = Rebuilt(id);
  return true;
}

}  // namespace

std::vector<Verdict> Compare(terms::Terms& terms, Solver& solver, std::span<const TermPair> pairs,
                             const SweepLimits& limits) {
  return Sweeper(terms, solver, pairs, limits).Run();
}

}  // namespace plcxx::solver
