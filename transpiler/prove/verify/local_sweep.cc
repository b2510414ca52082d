#include "transpiler/prove/verify/local_sweep.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/division.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/form.h"
#include "transpiler/symbolic/terms/index_bits.h"
#include "transpiler/symbolic/terms/likely_values.h"
#include "transpiler/symbolic/terms/specialization.h"

namespace plcxx::prove::verify {
namespace {

constexpr int kVectors = 48;
constexpr size_t kMostCandidates = 3;  // of one class that a term is compared with
constexpr size_t kMostCopied = 600;    // terms of one question
constexpr uint32_t kQuestionMs = 300;  // for terms inside
constexpr uint32_t kFirstMs = 200;     // for the pairs themselves, for each cut
constexpr uint32_t kLastMs = 2000;     // for those that are open then
constexpr int kQuestionVectors = 64;
constexpr uint32_t kMostBits = 10;  // of variables of which all values are tried
constexpr size_t kMostTermsOfAllValues = 200;
constexpr size_t kMostTermsOfForm = 2000;

/// A word whose parts are known by themselves, too: cut, it would be another word than its parts are.
bool OnlyConnects(terms::TermKind kind) {
  return kind == terms::TermKind::kNot || kind == terms::TermKind::kConcat || kind == terms::TermKind::kExtract;
}

/// How a question is cut out of its terms: what is shared, `shared` such terms down, becomes a variable.
struct Cut {
  int shared = 0;
  /// Conditions are no such terms: that of several on one index at most one holds is seen nowhere else. Products and
  /// quotients become variables wherever they are met: what is written does not depend on where it is.
  bool opens_conditions = false;
};

enum Side : uint8_t { kNone = 0, kSideA = 1, kSideB = 2, kBoth = 3 };

class LocalSweep {
 public:
  LocalSweep(terms::Terms& terms, solver::Solver& solver, std::span<const solver::TermPair> pairs,
             uint64_t milliseconds, solver::AnsweredForms& answered)
      : terms_(terms),
        solver_(solver),
        pairs_(pairs),
        answers_(answered),
        deadline_(solver::Clock::kProcessor, milliseconds),
        likely_(terms) {}

  std::vector<solver::TermPair> Run();

 private:
  void MarkCones();
  void Simulate();
  void SimulateOnce(int vector);
  void SweepTerm(terms::TermId id);
  /// A choice in a choice that is the same without the outer one, whose condition follows from the inner one's.
  terms::TermId WithoutImplied(terms::TermId id);
  /// By one of the cuts, of which that at `likely` is tried first; it becomes the one by which they are.
  bool AreEqual(terms::TermId a, terms::TermId b, std::span<const Cut> cuts, size_t& likely, uint32_t milliseconds);
  /// None: it is too large.
  std::optional<solver::TermPair> Copy(const solver::TermPair& pair, const Cut& cut);
  terms::TermId CutOf(terms::TermId id);
  /// What values of its variables say of a condition, samples or all that there are: most questions need no solver.
  solver::Answer AskValues(terms::TermId condition);
  /// Most questions are the same one about other bytes of State: each is asked once.
  solver::Answer Ask(terms::TermId condition, uint32_t milliseconds);
  std::vector<terms::TermId> ConeFrom(terms::TermId condition);
  uint64_t ValueFor(const std::function<uint64_t(terms::TermId variable)>& variable);
  bool IsShared(terms::TermId id) const { return id.index < shared_.size() && shared_[id.index]; }
  void Share(terms::TermId id) {
    if (id.index >= shared_.size()) shared_.resize(terms_.size());
    shared_[id.index] = true;
  }
  terms::TermId Representative(terms::TermId id) const {
    return id.index < representative_.size() && representative_[id.index].valid() ? representative_[id.index] : id;
  }
  bool Late() const { return deadline_.IsOver(); }

  terms::Terms& terms_;
  solver::Solver& solver_;
  std::span<const solver::TermPair> pairs_;
  solver::AnsweredForms& answers_;
  const solver::Deadline deadline_;
  std::vector<uint8_t> sides_;
  std::vector<terms::TermId> cone_;
  std::vector<uint64_t> signatures_, values_;
  terms::LikelyValues likely_;
  std::vector<terms::TermId> representative_;
  std::vector<bool> shared_;
  std::unordered_map<uint64_t, std::vector<terms::TermId>> classes_;  // looked up only
  std::unordered_map<uint32_t, terms::TermId> cuts_;                  // looked up only
  std::unordered_map<uint32_t, terms::TermId> copies_;                // of one question, by TermId; looked up only
  std::vector<terms::TermId> question_;                               // all terms of the last one
  std::vector<uint64_t> question_values_;                             // by TermId
  bool cut_ = false;
  bool has_unknown_ = false;  // a question was not answered
};

void LocalSweep::MarkCones() {
  sides_.assign(terms_.size(), kNone);
  for (const Side side : {kSideA, kSideB}) {
    std::vector<terms::TermId> roots;
    for (const solver::TermPair& pair : pairs_) {
      if (pair.a != pair.b) roots.push_back(side == kSideA ? pair.a : pair.b);
    }
    for (const terms::TermId id : terms::ConeOf(terms_, roots)) sides_[id.index] |= side;
  }
  for (uint32_t i = 0; i < sides_.size(); ++i) {
    if (sides_[i] == kNone) continue;
    const terms::TermId id(i);
    cone_.push_back(id);
    if (sides_[i] == kBoth) Share(id);
  }
  likely_.NoteConstants(cone_);
}

void LocalSweep::SimulateOnce(int vector) {
  for (const terms::TermId id : cone_) {
    const terms::Term& term = terms_[id];
    uint64_t value = terms::EvaluateTerm(
        terms_, term, [this](terms::TermId operand) { return values_[operand.index]; },
        [&](uint32_t) { return likely_.Of(vector, id); });
    if (term.kind == terms::TermKind::kApply) value = likely_.ResultOf(vector, term, value);
    values_[id.index] = value;
    uint64_t& signature = signatures_[id.index];
    signature = (signature ^ value) * 0x9E3779B97F4A7C15;
    signature ^= signature >> 32;
  }
}

void LocalSweep::Simulate() {
  values_.assign(terms_.size(), 0);
  signatures_.assign(terms_.size(), 0);
  likely_.NoteComparisons(cone_);
  for (int vector = 0; vector < kVectors; ++vector) SimulateOnce(vector);
}

terms::TermId LocalSweep::CutOf(terms::TermId id) {
  cut_ = true;
  terms::TermId& cut = cuts_[id.index];
  if (!cut.valid()) cut = terms_.Variable("cut " + std::to_string(id.index), terms_.Width(id));
  return cut;
}

std::optional<solver::TermPair> LocalSweep::Copy(const solver::TermPair& pair, const Cut& cut) {
  // Operands are older than what is made of them: when a term's turn comes, all that leads to it has been looked at, so
  // that it is cut everywhere or nowhere.
  std::map<uint32_t, int, std::greater<>> left = {{pair.a.index, cut.shared}, {pair.b.index, cut.shared}};
  std::vector<terms::TermId> inside;
  copies_.clear();
  while (!left.empty()) {
    const auto [index, most] = *left.begin();
    left.erase(left.begin());
    const terms::TermId id(index);
    const terms::Term term = terms_[id];
    if (term.kind == terms::TermKind::kConst || term.kind == terms::TermKind::kVariable) {
      copies_.emplace(index, id);
      continue;
    }
    const bool counts = IsShared(id) && !OnlyConnects(term.kind) && !(cut.opens_conditions && term.width == 1) &&
                        id != pair.a && id != pair.b;
    if (counts && (most == 0 || (cut.opens_conditions && terms::IsLaborious(term.kind)))) {
      copies_.emplace(index, CutOf(id));
      continue;
    }
    inside.push_back(id);
    if (inside.size() > kMostCopied) return std::nullopt;
    terms_.ForEachOperand(term, [&](terms::TermId operand) {
      int& of_operand = left[operand.index];
      of_operand = std::max(of_operand, counts ? most - 1 : most);
    });
  }
  for (const terms::TermId id : std::views::reverse(inside)) {
    const terms::Term term = terms_[id];
    std::vector<terms::TermId> operands;
    terms_.ForEachOperand(term, [&](terms::TermId operand) { operands.push_back(copies_.at(operand.index)); });
    copies_.emplace(id.index, terms_.Rebuild(term, operands));
  }
  return solver::TermPair{copies_.at(pair.a.index), copies_.at(pair.b.index)};
}

/// Of the last term of `question_`.
uint64_t LocalSweep::ValueFor(const std::function<uint64_t(terms::TermId variable)>& variable) {
  for (const terms::TermId id : question_) {
    const terms::Term& term = terms_[id];
    question_values_[id.index] = terms::EvaluateTerm(
        terms_, term, [this](terms::TermId operand) { return question_values_[operand.index]; },
        [&](uint32_t) { return variable(id); });
  }
  return question_values_[question_.back().index];
}

solver::Answer LocalSweep::AskValues(terms::TermId condition) {
  question_ = ConeFrom(condition);
  if (question_values_.size() < terms_.size()) question_values_.resize(terms_.size());
  uint32_t bits = 0;
  bool known = true;  // what functions give is, too
  for (const terms::TermId id : question_) {
    const terms::Term& term = terms_[id];
    if (term.kind == terms::TermKind::kVariable) bits += term.width;
    known = known && term.kind != terms::TermKind::kApply;
  }
  if (known && bits <= kMostBits && question_.size() <= kMostTermsOfAllValues) {
    for (uint64_t number = 0; number < uint64_t{1} << bits; ++number) {
      uint64_t rest = number;
      const auto next = [&](terms::TermId variable) {
        const uint8_t width = terms_.Width(variable);
        const uint64_t value = terms::Masked(rest, width);
        rest = width < 64 ? rest >> width : 0;
        return value;
      };
      if (ValueFor(next) != 0) return solver::Answer::kPossible;
    }
    return solver::Answer::kNever;
  }
  likely_.ForgetComparisonsOfVariables();
  likely_.NoteComparisons(question_);
  for (int vector = 0; vector < kQuestionVectors; ++vector) {
    if (ValueFor([&](terms::TermId variable) { return likely_.Of(vector, variable); }) != 0)
      return solver::Answer::kPossible;
  }
  return solver::Answer::kUnknown;
}

/// Operands first.
std::vector<terms::TermId> LocalSweep::ConeFrom(terms::TermId condition) {
  std::vector<terms::TermId> cone, open = {condition};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const terms::TermId id = open.back();
    open.pop_back();
    if (!seen.insert(id.index).second) continue;
    cone.push_back(id);
    terms_.ForEachOperand(terms_[id], [&open](terms::TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(cone);
  return cone;
}

solver::Answer LocalSweep::Ask(terms::TermId condition, uint32_t milliseconds) {
  const std::optional<std::string> form = terms::FormOf(terms_, condition, kMostTermsOfForm);
  solver::Answered own;
  solver::Answered& known = form ? answers_[*form] : own;
  if (known.Settles(milliseconds)) return known.answer;
  if (!known.has_tried_values) known.answer = AskValues(condition);
  known.has_tried_values = true;
  if (known.answer == solver::Answer::kUnknown) {
    const solver::Limit limit = deadline_.LimitFor(milliseconds);
    known.answer = solver_.Check({&condition, 1}, limit);
    known.milliseconds = limit.effort_ms;
  }
  return known.answer;
}

bool LocalSweep::AreEqual(terms::TermId a, terms::TermId b, std::span<const Cut> cuts, size_t& likely,
                          uint32_t milliseconds) {
  if (a == b) return true;
  const size_t first = likely;
  for (size_t n = 0; n < cuts.size(); ++n) {
    const size_t i = n == 0 ? first : n <= first ? n - 1 : n;
    const bool is_ahead = i > n;  // what is smaller has not been asked yet
    cut_ = false;
    const std::optional<solver::TermPair> copy = Copy({a, b}, cuts[i]);
    if (!copy && is_ahead) continue;
    if (!copy) return false;
    const terms::TermId differ = terms_.Ne(copy->a, copy->b);
    const solver::Answer answer = terms_.IsFalse(differ) ? solver::Answer::kNever : Ask(differ, milliseconds);
    if (answer == solver::Answer::kNever) {
      likely = i;
      return true;
    }
    has_unknown_ = has_unknown_ || answer == solver::Answer::kUnknown;
    // Where nothing was cut, they do differ.
    if (Late() || (!cut_ && !(is_ahead && answer == solver::Answer::kUnknown))) return false;
  }
  return false;
}

terms::TermId LocalSweep::WithoutImplied(terms::TermId id) {
  // p ? (q ? x : y) : y, as code writes it that asks whether an index is in range before it writes there.
  const terms::Term outer = terms_[id];
  if (outer.kind != terms::TermKind::kIte) return id;
  const terms::Term inner = terms_[terms::TermId(outer.b)];
  if (inner.kind != terms::TermKind::kIte || inner.c != outer.c) return id;
  const terms::KnownIndexBits known = terms::KnownWhere(terms_, terms::TermId(inner.a));
  const terms::TermId condition = terms::WhereKnown(terms_, terms::TermId(outer.a), known);
  if (!terms_.IsConst(condition)) return id;
  return terms::TermId(terms_.IsTrue(condition) ? outer.b : outer.c);
}

void LocalSweep::SweepTerm(terms::TermId id) {
  constexpr Cut kCuts[] = {{0}, {2}};
  const terms::Term term = terms_[id];
  std::vector<terms::TermId> operands;
  bool changed = false;
  terms_.ForEachOperand(term, [&](terms::TermId operand) {
    operands.push_back(Representative(operand));
    changed = changed || operands.back() != operand;
  });
  terms::TermId now = Representative(WithoutImplied(changed ? terms_.Rebuild(term, operands) : id));
  std::vector<terms::TermId>& members = classes_[signatures_[id.index]];
  if (sides_[id.index] == kSideB && !terms_.IsConst(now) && !IsShared(now) && !Late()) {
    size_t tried = 0;
    // The latest first: both executions go through the program in its order.
    for (auto member = members.rbegin(); member != members.rend() && tried < kMostCandidates; ++member) {
      const terms::TermId other = Representative(*member);
      if (sides_[member->index] == kSideB || terms_.Width(other) != term.width) continue;
      ++tried;
      size_t smallest = 0;
      if (!AreEqual(now, other, kCuts, smallest, kQuestionMs)) continue;
      now = other;
      break;
    }
  }
  // What the other side has, too, from now on.
  if (sides_[id.index] == kSideB && now.index < sides_.size() && (sides_[now.index] & kSideA) != 0) Share(now);
  representative_[id.index] = now;
  members.push_back(id);
}

std::vector<solver::TermPair> LocalSweep::Run() {
  constexpr Cut kCuts[] = {{0}, {0, true}, {2, true}, {1}, {3}, {8}, {20}};
  std::vector<solver::TermPair> alike(pairs_.begin(), pairs_.end());
  if (std::ranges::all_of(alike, [](const solver::TermPair& pair) { return pair.a == pair.b; })) return alike;
  MarkCones();
  Simulate();
  representative_.assign(terms_.size(), terms::TermId());
  for (const terms::TermId id : cone_) SweepTerm(id);
  // The elements of an array follow each other, and are decided alike.
  size_t likely = 0;
  for (solver::TermPair& pair : alike) {
    if (pair.a == pair.b) continue;
    pair = {Representative(pair.a), Representative(pair.b)};
    // What takes long at one depth is often answered at once at the next one, which knows more.
    has_unknown_ = false;
    bool are_equal = AreEqual(pair.a, pair.b, kCuts, likely, kFirstMs);
    if (!are_equal && has_unknown_) are_equal = AreEqual(pair.a, pair.b, kCuts, likely, kLastMs);
    if (are_equal) pair.b = pair.a;
  }
  return alike;
}

}  // namespace

std::vector<solver::TermPair> MakeAlike(terms::Terms& terms, solver::Solver& solver,
                                        std::span<const solver::TermPair> pairs, uint64_t milliseconds,
                                        solver::AnsweredForms& answered) {
  return LocalSweep(terms, solver, pairs, milliseconds, answered).Run();
}

}  // namespace plcxx::prove::verify
