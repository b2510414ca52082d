// Which relations outlive a part: all are asked about at once, and what fails in the solver's answer is dropped, until
// nothing does.
//
// Of many guesses most fail, and each would cost a question of its own; one answer shows many of them. Where the bits
// alone do not decide in time, those that are left are asked about one by one.
#include <algorithm>
#include <span>
#include <utility>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::diff {
namespace {

using Next = std::function<terms::TermId(Which which, execute::CellId cell)>;

struct Candidate {
  size_t relation;  // index of Comparison::relations
  terms::TermId fails;
};

/// Those that may fail after the part.
std::vector<Candidate> CandidatesOf(Comparison& comparison, const Next& next) {
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < comparison.relations.size(); ++i) {
    const terms::TermId holds = ConditionOf(comparison.terms, comparison.relations[i], next);
    if (!comparison.terms.IsTrue(holds)) candidates.push_back({i, comparison.terms.Not(holds)});
  }
  return candidates;
}

uint32_t DropRelations(Comparison& comparison, const std::vector<bool>& fails) {
  size_t at = 0;
  return static_cast<uint32_t>(std::erase_if(comparison.relations, [&](const Relation&) { return fails[at++]; }));
}

/// States that are like the one that a solver has found: all that is known holds there as well.
class StatesAlike {
 public:
  /// `known`: conditions; `fails`: what is asked of such a state. The solver has just answered.
  StatesAlike(const terms::Terms& terms, solver::BitSolver& bits, std::span<const terms::TermId> known,
              std::span<const terms::TermId> fails)
      : terms_(terms), known_(known) {
    std::vector<terms::TermId> roots(known.begin(), known.end());
    const std::vector<terms::TermId> known_cone = terms::ConeOf(terms, roots);
    roots.insert(roots.end(), fails.begin(), fails.end());
    cone_ = terms::ConeOf(terms, roots);
    values_.resize(terms.size());
    found_.resize(terms.size());
    for (const terms::TermId id : cone_) {
      if (!IsOpen(id)) continue;
      found_[id.index] = bits.ValueOf(id);
      (std::ranges::binary_search(known_cone, id) ? state_ : inputs_).push_back(id);
    }
  }

  /// Calls `visit` with the values by TermId.
  void ForEach(terms::Random& random, const std::function<void(const std::vector<uint64_t>& values)>& visit) {
    constexpr int kStates = 96;
    for (int i = 0; i < kStates; ++i) {
      std::vector<uint64_t> open = found_;
      for (const terms::TermId id : inputs_) {
        if (random.OneIn(2)) open[id.index] = AnyOf(random, id);
      }
      for (uint64_t left = state_.empty() ? 0 : i % 3; left > 0; --left) {
        const terms::TermId id = state_[(random.Next() >> 20) % state_.size()];
        open[id.index] = AnyOf(random, id);
      }
      for (const terms::TermId id : cone_) {
        values_[id.index] =
            IsOpen(id) ? open[id.index]
                       : terms::EvaluateTerm(
                             terms_, terms_[id], [this](terms::TermId operand) { return values_[operand.index]; },
                             [](uint32_t) { return uint64_t{0}; });
      }
      if (std::ranges::all_of(known_, [this](terms::TermId id) { return values_[id.index] != 0; })) visit(values_);
    }
  }

 private:
  /// A variable, or what a function without meaning gives.
  bool IsOpen(terms::TermId id) const {
    const terms::Term& term = terms_[id];
    return term.kind == terms::TermKind::kVariable ||
           (term.kind == terms::TermKind::kApply && terms_.Info(terms::FunctionId(term.a)).evaluate == nullptr);
  }
  uint64_t AnyOf(terms::Random& random, terms::TermId id) const {
    const uint64_t any = random.Next() >> 8;
    const uint64_t value = random.OneIn(2) ? any % 4 : random.OneIn(2) ? found_[id.index] + any % 3 - 1 : any;
    return terms::Masked(value, terms_.Width(id));
  }

  const terms::Terms& terms_;
  std::span<const terms::TermId> known_;
  std::vector<terms::TermId> cone_, state_, inputs_;  // all; those of the variables that something is known of; others
  std::vector<uint64_t> found_, values_;              // by TermId
};

/// True: those that are left are proved. False: nothing is said of them.
bool DropTogether(Comparison& comparison, Known known, const Next& next, uint32_t& dropped) {
  if (!comparison.bits) comparison.bits = solver::LoadBitSolver(comparison.terms);
  if (!comparison.bits) return false;
  const solver::Deadline deadline(solver::Clock::kWall, std::min(comparison.RestMs(), comparison.round_ms / 2));
  terms::Random random(0x9E3779B97F4A7C15);
  for (;;) {
    const std::vector<Candidate> candidates = CandidatesOf(comparison, next);
    terms::TermId any = comparison.terms.Bit(false);
    for (const Candidate& candidate : candidates) any = comparison.terms.Or(any, candidate.fails);
    if (comparison.terms.IsFalse(any)) return true;
    const std::vector<terms::TermId> conditions = comparison.KnownConditions(known);
    std::vector<terms::TermId> question = conditions;
    question.push_back(any);
    if (deadline.IsOver()) return false;
    switch (comparison.bits->Check(question, solver::Limit().Within(deadline.RestMs()))) {
      case solver::Answer::kNever:
        return true;
      case solver::Answer::kUnknown:
        return false;
      case solver::Answer::kPossible:
        break;
    }
    std::vector<bool> fails(comparison.relations.size());
    std::vector<terms::TermId> terms;
    for (const Candidate& candidate : candidates) {
      fails[candidate.relation] = comparison.bits->ValueOf(candidate.fails) != 0;
      terms.push_back(candidate.fails);
    }
    StatesAlike alike(comparison.terms, *comparison.bits, conditions, terms);
    alike.ForEach(random, [&](const std::vector<uint64_t>& values) {
      for (const Candidate& candidate : candidates)
        if (values[candidate.fails.index] != 0) fails[candidate.relation] = true;
    });
    const uint32_t now = DropRelations(comparison, fails);
    if (now == 0) return false;
    dropped += now;
  }
}

}  // namespace

uint32_t DropFailingRelations(Comparison& comparison, Known known, const Next& next) {
  uint32_t dropped = 0;
  if (CandidatesOf(comparison, next).empty()) return dropped;
  if (comparison.before_questions) std::exchange(comparison.before_questions, nullptr)();
  if (DropTogether(comparison, known, next, dropped)) return dropped;
  const std::vector<Candidate> candidates = CandidatesOf(comparison, next);
  std::vector<Question> questions;
  for (const Candidate& candidate : candidates)
    questions.push_back({{candidate.fails, comparison.terms.Bit(false)}, 0});
  const std::vector<solver::Verdict> verdicts = Answers(comparison, questions, known);
  std::vector<bool> fails(comparison.relations.size());
  for (size_t i = 0; i < candidates.size(); ++i) fails[candidates[i].relation] = verdicts[i] != solver::Verdict::kEqual;
  return dropped + DropRelations(comparison, fails);
}

}  // namespace plcxx::prove::diff
