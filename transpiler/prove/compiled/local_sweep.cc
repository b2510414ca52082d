#include "transpiler/prove/compiled/local_sweep.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"
#include "transpiler/prove/terms/form.h"
#include "transpiler/prove/terms/random.h"

namespace plcxx::prove {
namespace {

constexpr int kVectors = 48;
constexpr size_t kMostCandidates = 3;  // of one class that a term is compared with
constexpr size_t kMostCopied = 600;    // terms of one question
constexpr uint32_t kQuestionMs = 300;  // for terms inside
constexpr uint32_t kLastMs = 2000;     // for the pairs themselves
constexpr int kQuestionVectors = 64;
constexpr uint32_t kMostBits = 10;  // of variables of which all values are tried
constexpr size_t kMostTermsOfAllValues = 200;
constexpr size_t kMostConstants = 4096;
constexpr size_t kMostTermsOfForm = 2000;

/// A word whose parts are known by themselves, too: cut, it would be another word than its parts are.
bool OnlyConnects(TermKind kind) {
  return kind == TermKind::kNot || kind == TermKind::kConcat || kind == TermKind::kExtract;
}

enum Side : uint8_t { kNone = 0, kSideA = 1, kSideB = 2, kBoth = 3 };

class LocalSweep {
 public:
  LocalSweep(Terms& terms, Solver& solver, std::span<const TermPair> pairs, uint64_t milliseconds,
             AnsweredForms& answered)
      : terms_(terms),
        solver_(solver),
        pairs_(pairs),
        answers_(answered),
        deadline_(std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds)) {}

  std::vector<TermPair> Run();

 private:
  void MarkCones();
  void Simulate();
  void SimulateOnce(int vector);
  uint64_t Sample(int vector, uint8_t width);
  uint64_t SampleFor(int vector, TermId variable);
  /// Notes what the terms of a cone are compared with.
  void NoteComparisons(std::span<const TermId> cone);
  void NoteComparison(TermId compared, uint64_t value);
  void SweepTerm(TermId id);
  bool AreEqual(TermId a, TermId b, std::span<const int> depths, uint32_t milliseconds);
  /// A copy of both in which what is shared, `depth` shared terms down, is a variable. None: it is too large.
  std::optional<TermPair> Copy(const TermPair& pair, int depth);
  TermId CutOf(TermId id);
  /// What values of its variables say of a condition, samples or all that there are: most questions need no solver.
  Answer AskValues(TermId condition);
  /// Most questions are the same one about other bytes of State: each is asked once.
  Answer Ask(TermId condition, uint32_t milliseconds);
  std::vector<TermId> ConeFrom(TermId condition);
  uint64_t ValueFor(const std::function<uint64_t(TermId variable)>& variable);
  bool IsShared(TermId id) const { return id.index < shared_.size() && shared_[id.index]; }
  void Share(TermId id) {
    if (id.index >= shared_.size()) shared_.resize(terms_.size());
    shared_[id.index] = true;
  }
  TermId Representative(TermId id) const {
    return id.index < representative_.size() && representative_[id.index].valid() ? representative_[id.index] : id;
  }
  bool Late() const { return std::chrono::steady_clock::now() >= deadline_; }

  Terms& terms_;
  Solver& solver_;
  std::span<const TermPair> pairs_;
  AnsweredForms& answers_;
  std::chrono::steady_clock::time_point deadline_;
  std::vector<uint8_t> sides_;
  std::vector<TermId> cone_;
  std::vector<uint64_t> constants_, signatures_, values_;
  std::vector<TermId> representative_;
  std::vector<bool> shared_;
  std::unordered_map<uint32_t, std::vector<uint64_t>> compared_;  // by TermId of a variable; looked up only
  std::unordered_map<uint32_t, std::vector<uint64_t>> results_;   // by function without meaning; looked up only
  std::unordered_map<uint64_t, std::vector<TermId>> classes_;     // looked up only
  std::unordered_map<uint32_t, TermId> cuts_;                     // looked up only
  std::unordered_map<uint32_t, TermId> copies_;                   // of one question, by TermId; looked up only
  std::vector<TermId> question_;                                  // all terms of the last one
  std::vector<uint64_t> question_values_;                         // by TermId
  bool cut_ = false;
  Random random_{0x9E3779B97F4A7C15};
};

void LocalSweep::MarkCones() {
  sides_.assign(terms_.size(), kNone);
  for (const Side side : {kSideA, kSideB}) {
    std::vector<TermId> roots;
    for (const TermPair& pair : pairs_) {
      if (pair.a != pair.b) roots.push_back(side == kSideA ? pair.a : pair.b);
    }
    for (const TermId id : ConeOf(terms_, roots)) sides_[id.index] |= side;
  }
  for (uint32_t i = 0; i < sides_.size(); ++i) {
    if (sides_[i] == kNone) continue;
    const TermId id(i);
    cone_.push_back(id);
    if (sides_[i] == kBoth) Share(id);
    if (terms_.IsConst(id) && terms_.Width(id) > 1) constants_.push_back(terms_.Value(id));
  }
  std::ranges::sort(constants_);
  constants_.erase(std::ranges::unique(constants_).begin(), constants_.end());
  if (constants_.size() > kMostConstants) constants_.resize(kMostConstants);
}

/// Programs ask for their constants: so they are among the samples.
uint64_t LocalSweep::Sample(int vector, uint8_t width) {
  const uint64_t random = random_.Next();
  if (width == 1) {
    const uint64_t density = vector % 4 == 0 ? 128 : vector % 4 == 1 ? 16 : vector % 4 == 2 ? 240 : 64;
    return (random & 255) < density ? 1 : 0;
  }
  switch (random >> 8 & 7) {
    case 0:
      return 0;
    case 1:
      return random >> 16 & 3;
    case 2:
      return ~uint64_t{0} - (random >> 16 & 3);
    case 3:
    case 4:
      return random_.Next();
    default:
      return constants_.empty() ? random : constants_[(random >> 16) % constants_.size()] + (random >> 11 & 3) - 1;
  }
}

void LocalSweep::NoteComparison(TermId compared, uint64_t value) {
  Term term = terms_[compared];
  while (term.kind == TermKind::kConcat && terms_.IsZero(TermId(term.a))) {
    compared = TermId(term.b);
    term = terms_[compared];
  }
  if (term.kind == TermKind::kExtract) {
    value <<= term.b;
    compared = TermId(term.a);
    term = terms_[compared];
  }
  if (term.kind == TermKind::kVariable) compared_[compared.index].push_back(value);
  if (term.kind == TermKind::kApply && terms_.Info(FunctionId(term.a)).evaluate == nullptr)
    results_[term.a].push_back(value);
}

void LocalSweep::NoteComparisons(std::span<const TermId> cone) {
  for (const TermId id : cone) {
    const Term term = terms_[id];
    const bool compares = term.kind == TermKind::kEq || term.kind == TermKind::kUlt || term.kind == TermKind::kSlt;
    if (!compares) continue;
    for (const auto& [one, other] : {std::pair(TermId(term.a), TermId(term.b)), {TermId(term.b), TermId(term.a)}}) {
      if (!terms_.IsConst(other)) continue;
      NoteComparison(one, terms_.Value(other));
      if (term.kind != TermKind::kEq) NoteComparison(one, terms_.Value(other) - 1);
    }
  }
}

/// A condition that asks for one value of a word would hardly ever hold else.
uint64_t LocalSweep::SampleFor(int vector, TermId variable) {
  const auto own = compared_.find(variable.index);
  const uint64_t random = random_.Next();
  if (own == compared_.end() || (random & 1) != 0) return Sample(vector, terms_.Width(variable));
  return own->second[(random >> 1) % own->second.size()];
}

void LocalSweep::SimulateOnce(int vector) {
  for (const TermId id : cone_) {
    const Term& term = terms_[id];
    uint64_t value = EvaluateTerm(
        terms_, term, [this](TermId operand) { return values_[operand.index]; },
        [&](uint32_t) { return SampleFor(vector, id); });
    // Any function will do, if equal arguments give equal results.
    if (term.kind == TermKind::kApply && (value & 1) != 0) {
      const auto own = results_.find(term.a);
      if (own != results_.end()) value = Masked(own->second[(value >> 1) % own->second.size()], term.width);
    }
    values_[id.index] = value;
    uint64_t& signature = signatures_[id.index];
    signature = (signature ^ value) * 0x9E3779B97F4A7C15;
    signature ^= signature >> 32;
  }
}

void LocalSweep::Simulate() {
  values_.assign(terms_.size(), 0);
  signatures_.assign(terms_.size(), 0);
  NoteComparisons(cone_);
  for (int vector = 0; vector < kVectors; ++vector) SimulateOnce(vector);
}

TermId LocalSweep::CutOf(TermId id) {
  cut_ = true;
  TermId& cut = cuts_[id.index];
  if (!cut.valid()) cut = terms_.Variable("cut " + std::to_string(id.index), terms_.Width(id));
  return cut;
}

std::optional<TermPair> LocalSweep::Copy(const TermPair& pair, int depth) {
  // Operands are older than what is made of them: when a term's turn comes, all that leads to it has been looked at, so
  // that it is cut everywhere or nowhere.
  std::map<uint32_t, int, std::greater<>> left = {{pair.a.index, depth}, {pair.b.index, depth}};
  std::vector<TermId> inside;
  copies_.clear();
  while (!left.empty()) {
    const auto [index, most] = *left.begin();
    left.erase(left.begin());
    const TermId id(index);
    const Term term = terms_[id];
    if (term.kind == TermKind::kConst || term.kind == TermKind::kVariable) {
      copies_.emplace(index, id);
      continue;
    }
    const bool counts = IsShared(id) && !OnlyConnects(term.kind) && id != pair.a && id != pair.b;
    if (counts && most == 0) {
      copies_.emplace(index, CutOf(id));
      continue;
    }
    inside.push_back(id);
    if (inside.size() > kMostCopied) return std::nullopt;
    terms_.ForEachOperand(term, [&](TermId operand) {
      int& of_operand = left[operand.index];
      of_operand = std::max(of_operand, counts ? most - 1 : most);
    });
  }
  for (const TermId id : std::views::reverse(inside)) {
    const Term term = terms_[id];
    std::vector<TermId> operands;
    terms_.ForEachOperand(term, [&](TermId operand) { operands.push_back(copies_.at(operand.index)); });
    copies_.emplace(id.index, terms_.Rebuild(term, operands));
  }
  return TermPair{copies_.at(pair.a.index), copies_.at(pair.b.index)};
}

/// Of the last term of `question_`.
uint64_t LocalSweep::ValueFor(const std::function<uint64_t(TermId variable)>& variable) {
  for (const TermId id : question_) {
    const Term& term = terms_[id];
    question_values_[id.index] = EvaluateTerm(
        terms_, term, [this](TermId operand) { return question_values_[operand.index]; },
        [&](uint32_t) { return variable(id); });
  }
  return question_values_[question_.back().index];
}

Answer LocalSweep::AskValues(TermId condition) {
  question_ = ConeFrom(condition);
  if (question_values_.size() < terms_.size()) question_values_.resize(terms_.size());
  uint32_t bits = 0;
  bool known = true;  // what functions give is, too
  for (const TermId id : question_) {
    const Term& term = terms_[id];
    if (term.kind == TermKind::kVariable) bits += term.width;
    known = known && term.kind != TermKind::kApply;
  }
  if (known && bits <= kMostBits && question_.size() <= kMostTermsOfAllValues) {
    for (uint64_t number = 0; number < uint64_t{1} << bits; ++number) {
      uint64_t rest = number;
      const auto next = [&](TermId variable) {
        const uint8_t width = terms_.Width(variable);
        const uint64_t value = Masked(rest, width);
        rest = width < 64 ? rest >> width : 0;
        return value;
      };
      if (ValueFor(next) != 0) return Answer::kPossible;
    }
    return Answer::kNever;
  }
  compared_.clear();
  NoteComparisons(question_);
  for (int vector = 0; vector < kQuestionVectors; ++vector) {
    if (ValueFor([&](TermId variable) { return SampleFor(vector, variable); }) != 0) return Answer::kPossible;
  }
  return Answer::kUnknown;
}

/// Operands first.
std::vector<TermId> LocalSweep::ConeFrom(TermId condition) {
  std::vector<TermId> cone, open = {condition};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (!seen.insert(id.index).second) continue;
    cone.push_back(id);
    terms_.ForEachOperand(terms_[id], [&open](TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(cone);
  return cone;
}

Answer LocalSweep::Ask(TermId condition, uint32_t milliseconds) {
  const std::optional<std::string> form = FormOf(terms_, condition, kMostTermsOfForm);
  Answered own;
  Answered& known = form ? answers_[*form] : own;
  if (known.Settles(milliseconds)) return known.answer;
  if (!known.has_tried_values) known.answer = AskValues(condition);
  known.has_tried_values = true;
  if (known.answer == Answer::kUnknown) {
    known.answer = solver_.Check({&condition, 1}, milliseconds);
    known.milliseconds = milliseconds;
  }
  return known.answer;
}

bool LocalSweep::AreEqual(TermId a, TermId b, std::span<const int> depths, uint32_t milliseconds) {
  if (a == b) return true;
  for (const int depth : depths) {
    cut_ = false;
    const std::optional<TermPair> copy = Copy({a, b}, depth);
    if (!copy) return false;
    const TermId differ = terms_.Ne(copy->a, copy->b);
    if (terms_.IsFalse(differ)) return true;
    if (Ask(differ, milliseconds) == Answer::kNever) return true;
    // Where nothing was cut, they do differ.
    if (!cut_ || Late()) return false;
  }
  return false;
}

void LocalSweep::SweepTerm(TermId id) {
  constexpr int kDepths[] = {0, 2};
  const Term term = terms_[id];
  std::vector<TermId> operands;
  bool changed = false;
  terms_.ForEachOperand(term, [&](TermId operand) {
    operands.push_back(Representative(operand));
    changed = changed || operands.back() != operand;
  });
  TermId now = changed ? Representative(terms_.Rebuild(term, operands)) : id;
  std::vector<TermId>& members = classes_[signatures_[id.index]];
  if (sides_[id.index] == kSideB && !terms_.IsConst(now) && !IsShared(now) && !Late()) {
    size_t tried = 0;
    // The latest first: both executions go through the program in its order.
    for (auto member = members.rbegin(); member != members.rend() && tried < kMostCandidates; ++member) {
      const TermId other = Representative(*member);
      if (sides_[member->index] == kSideB || terms_.Width(other) != term.width) continue;
      ++tried;
      if (!AreEqual(now, other, kDepths, kQuestionMs)) continue;
      now = other;
      break;
    }
  }
  // What the other side has, too, from now on.
  if (sides_[id.index] == kSideB && now.index < sides_.size() && (sides_[now.index] & kSideA) != 0) Share(now);
  representative_[id.index] = now;
  members.push_back(id);
}

std::vector<TermPair> LocalSweep::Run() {
  constexpr int kDepths[] = {0, 1, 3, 8, 20};
  std::vector<TermPair> alike(pairs_.begin(), pairs_.end());
  if (std::ranges::all_of(alike, [](const TermPair& pair) { return pair.a == pair.b; })) return alike;
  MarkCones();
  Simulate();
  representative_.assign(terms_.size(), TermId());
  for (const TermId id : cone_) SweepTerm(id);
  for (TermPair& pair : alike) {
    if (pair.a == pair.b) continue;
    pair = {Representative(pair.a), Representative(pair.b)};
    if (AreEqual(pair.a, pair.b, kDepths, kLastMs)) pair.b = pair.a;
  }
  return alike;
}

}  // namespace

std::vector<TermPair> MakeAlike(Terms& terms, Solver& solver, std::span<const TermPair> pairs, uint64_t milliseconds,
                                AnsweredForms& answered) {
  return LocalSweep(terms, solver, pairs, milliseconds, answered).Run();
}

}  // namespace plcxx::prove
