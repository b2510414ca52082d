// Solver by Z3; see solver.h for what it has to do.
//
// What a function gives is a variable: questions are about bits alone then, and Z3's solver for these is many times
// faster than the one that knows functions. Where it finds values, and a function is there more than once, it is asked
// again with what that means: equal arguments, equal results. Only where that would be said of very many pairs the
// general solver is asked.
#include <z3++.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "transpiler/prove/solver/solver.h"
#include "transpiler/prove/solver/z3/translation.h"

namespace plcxx::prove {
namespace {

class Z3Solver : public Solver {
 public:
  explicit Z3Solver(const Terms& terms)
      : terms_(terms), bits_(context_, "QF_BV"), general_(context_), translation_(context_, terms) {}

  void Assume(TermId condition) override {
    const z3::expr holds = translation_.Holds(condition);
    bits_.add(holds);
    general_.add(holds);
    const std::vector<TermId> applied = AppliesIn({&condition, 1});
    Define(applied);
    assumed_.insert(assumed_.end(), applied.begin(), applied.end());
  }
  void Push() override {
    bits_.push();
    general_.push();
    levels_.push_back(assumed_.size());
  }
  void Pop() override {
    bits_.pop();
    general_.pop();
    assumed_.resize(levels_.back());
    levels_.pop_back();
  }

  Answer Check(std::span<const TermId> conditions, uint32_t milliseconds) override {
    model_.reset();
    z3::expr_vector holds(context_);
    for (const TermId condition : conditions) holds.push_back(translation_.Holds(condition));
    const auto ask = [&](z3::solver& solver, auto&& add) {
      solver.push();
      add();
      const Answer answer = Ask(solver, holds, milliseconds);
      solver.pop();
      return answer;
    };
    const Answer answer = ask(bits_, [] {});
    if (answer == Answer::kNever) return answer;
    const std::vector<TermId> applied = AppliesIn(conditions);
    const std::optional<std::vector<Pair>> pairs = PairsOf(applied);
    if (!pairs) return ask(general_, [&] { Define(applied); });
    if (pairs->empty()) return answer;
    return ask(bits_, [&] {
      for (const Pair& pair : *pairs) bits_.add(EqualWhereArgumentsAre(pair));
    });
  }

  uint64_t ValueOf(TermId term) override {
    PLCXX_CHECK(model_ != nullptr);
    const z3::expr value = model_->eval(translation_.Translate(term), true);
    uint64_t number = 0;
    PLCXX_CHECK(value.is_numeral_u64(number));
    return number;
  }

 private:
  Answer Ask(z3::solver& solver, const z3::expr_vector& holds, uint32_t milliseconds) {
    try {
      z3::params parameters(context_);
      parameters.set("timeout", milliseconds);
      solver.set(parameters);
      for (const z3::expr& one : holds) solver.add(one);
      const z3::check_result result = solver.check();
      model_.reset();
      if (result == z3::sat) model_ = std::make_unique<z3::model>(solver.get_model());
      return result == z3::unsat ? Answer::kNever : result == z3::sat ? Answer::kPossible : Answer::kUnknown;
    } catch (const z3::exception&) {
      return Answer::kUnknown;  // a timeout inside a simplification
    }
  }

  /// What functions give, anywhere in these conditions, ascending.
  std::vector<TermId> AppliesIn(std::span<const TermId> conditions) {
    std::vector<TermId> open, found;
    std::unordered_set<uint32_t> seen;
    const auto add = [&](TermId id) {
      if (translation_.Applies(id) && seen.insert(id.index).second) open.push_back(id);
    };
    for (const TermId condition : conditions) add(condition);
    while (!open.empty()) {
      const TermId id = open.back();
      open.pop_back();
      if (terms_[id].kind == TermKind::kApply) {
        found.push_back(id);
        // Nobody else has asked for its arguments yet.
        for (const TermId argument : terms_.Arguments(terms_[id])) translation_.Translate(argument);
      }
      terms_.ForEachOperand(terms_[id], add);
    }
    std::ranges::sort(found);
    return found;
  }

  /// Two results of one function.
  struct Pair {
    TermId one, other;
  };
  /// Of these and what is assumed; none: there are too many.
  std::optional<std::vector<Pair>> PairsOf(std::span<const TermId> applied) const {
    constexpr size_t kMostEqualities = 20'000;
    std::vector<TermId> all(assumed_);
    all.insert(all.end(), applied.begin(), applied.end());
    std::ranges::sort(all, {}, [this](TermId id) { return std::pair(terms_[id].a, id.index); });
    all.erase(std::ranges::unique(all).begin(), all.end());
    std::vector<Pair> pairs;
    size_t equalities = 0;
    for (size_t i = 0; i < all.size(); ++i) {
      for (size_t k = i + 1; k < all.size() && terms_[all[k]].a == terms_[all[i]].a; ++k) {
        equalities += terms_.Arguments(terms_[all[i]]).size();
        if (equalities > kMostEqualities) return std::nullopt;
        pairs.push_back({all[i], all[k]});
      }
    }
    return pairs;
  }

  z3::expr EqualWhereArgumentsAre(const Pair& pair) {
    const auto one = terms_.Arguments(terms_[pair.one]), other = terms_.Arguments(terms_[pair.other]);
    z3::expr_vector either(context_);
    either.push_back(translation_.Translate(pair.one) == translation_.Translate(pair.other));
    for (size_t i = 0; i < one.size(); ++i) {
      if (one[i] != other[i]) either.push_back(translation_.Translate(one[i]) != translation_.Translate(other[i]));
    }
    return z3::mk_or(either);
  }

  /// Tells the general solver what the variables are that stand for functions.
  void Define(std::span<const TermId> applied) {
    for (const TermId id : applied) general_.add(translation_.Translate(id) == Applied(terms_[id]));
  }

  z3::expr Applied(const Term& term) {
    z3::sort_vector domain(context_);
    z3::expr_vector arguments(context_);
    for (const TermId argument : terms_.Arguments(term)) {
      domain.push_back(context_.bv_sort(terms_.Width(argument)));
      arguments.push_back(translation_.Translate(argument));
    }
    const z3::func_decl function =
        context_.function(("f" + std::to_string(term.a)).c_str(), domain, context_.bv_sort(term.width));
    return function(arguments);
  }

  const Terms& terms_;
  z3::context context_;
  z3::solver bits_, general_;
  Translation translation_;
  std::vector<TermId> assumed_;  // what functions give in assumptions
  std::vector<size_t> levels_;   // how many of them before each Push
  std::unique_ptr<z3::model> model_;
};

}  // namespace
}  // namespace plcxx::prove

extern "C" __attribute__((visibility("default"))) plcxx::prove::Solver* plcxx_make_solver(
    const plcxx::prove::Terms& terms) {
  return new plcxx::prove::Z3Solver(terms);
}
