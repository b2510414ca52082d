// Solver by Z3; see solver.h for what it has to do.
//
// What a function gives is a variable at first: most questions are about bits alone then, and Z3's solver for these is
// many times faster than the one that knows functions. That one is asked where equal arguments may matter: where the
// first finds values and functions are there. For it each of these variables is defined as what the function gives.
// Where both find values, and a few functions of floating point are there, a third one is asked, to which these are
// what they are (floats.h): the number that a product with 2.5 has to be of, or that there is none.
#include <z3++.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/solver/z3/floats.h"
#include "transpiler/symbolic/solver/z3/limits.h"
#include "transpiler/symbolic/solver/z3/translation.h"

namespace plcxx::solver {
namespace {

constexpr size_t kMostFloats = 8;    // functions of floating point in one question
constexpr uint32_t kFloatsMs = 500;  // of the solver's effort; what they are made of grows fast

class Z3Solver : public Solver {
 public:
  explicit Z3Solver(const terms::Terms& terms)
      : terms_(terms), bits_(context_, "QF_BV"), general_(context_), translation_(context_, terms) {}

  void Assume(terms::TermId condition) override {
    const z3::expr holds = translation_.Holds(condition);
    bits_.add(holds);
    general_.add(holds);
    Define(general_, {&condition, 1});
    assumed_applies_.back() = assumed_applies_.back() || translation_.Applies(condition);
    assumed_.push_back(condition);
  }
  void Push() override {
    bits_.push();
    general_.push();
    assumed_applies_.push_back(assumed_applies_.back());
    levels_.push_back(assumed_.size());
  }
  void Pop() override {
    bits_.pop();
    general_.pop();
    assumed_applies_.pop_back();
    assumed_.resize(levels_.back());
    levels_.pop_back();
  }

  Answer Check(std::span<const terms::TermId> conditions, const Limit& limit) override {
    model_.reset();
    z3::expr_vector holds(context_);
    bool applies = assumed_applies_.back();
    for (const terms::TermId condition : conditions) {
      holds.push_back(translation_.Holds(condition));
      applies = applies || translation_.Applies(condition);
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(limit.clock_ms);
    const auto ask = [&](z3::solver& solver, bool defines) {
      solver.push();
      if (defines) Define(solver, conditions);
      const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      const Answer answer =
          rest.count() <= 0 ? Answer::kUnknown : Ask(solver, holds, limit.Within(static_cast<uint64_t>(rest.count())));
      solver.pop();
      return answer;
    };
    Answer answer = ask(bits_, false);
    if (!applies || answer == Answer::kNever) return answer;
    answer = ask(general_, true);
    const std::vector<terms::TermId> floats = answer == Answer::kPossible ? FloatsOf(conditions) : NoTerms();
    if (floats.empty() || floats.size() > kMostFloats) return answer;
    // What was found before stays where nothing else is.
    std::unique_ptr<z3::model> found = std::move(model_);
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    const Answer exact =
        rest.count() <= 0 ? Answer::kUnknown : AskWithFloats(floats, holds, static_cast<uint64_t>(rest.count()), limit);
    if (exact == Answer::kUnknown) model_ = std::move(found);
    return exact == Answer::kNever ? exact : answer;
  }

  uint64_t ValueOf(terms::TermId term) override {
    PLCXX_CHECK(model_ != nullptr);
    const z3::expr value = model_->eval(translation_.Translate(term), true);
    uint64_t number = 0;
    PLCXX_CHECK(value.is_numeral_u64(number));
    return number;
  }

 private:
  Answer Ask(z3::solver& solver, const z3::expr_vector& holds, const Limit& limit) {
    try {
      solver.set(Parameters(context_, limit));
      for (const z3::expr& one : holds) solver.add(one);
      const z3::check_result result = solver.check();
      model_.reset();
      if (result == z3::sat) model_ = std::make_unique<z3::model>(solver.get_model());
      return result == z3::unsat ? Answer::kNever : result == z3::sat ? Answer::kPossible : Answer::kUnknown;
    } catch (const z3::exception&) {
      return Answer::kUnknown;  // a limit inside a simplification
    }
  }

  /// Tells `solver` what the variables are that stand for functions in these conditions.
  void Define(z3::solver& solver, std::span<const terms::TermId> conditions) {
    std::vector<terms::TermId> open;
    std::unordered_set<uint32_t> seen;
    const auto add = [&](terms::TermId id) {
      if (translation_.Applies(id) && seen.insert(id.index).second) open.push_back(id);
    };
    for (const terms::TermId condition : conditions) add(condition);
    while (!open.empty()) {
      const terms::Term& term = terms_[open.back()];
      if (term.kind == terms::TermKind::kApply) solver.add(translation_.Translate(open.back()) == Applied(term));
      open.pop_back();
      terms_.ForEachOperand(term, add);
    }
  }

  using NoTerms = std::vector<terms::TermId>;

  /// What these conditions, and those that are assumed, depend on.
  std::vector<terms::TermId> FloatsOf(std::span<const terms::TermId> conditions) const {
    std::vector<terms::TermId> open, floats;
    std::unordered_set<uint32_t> seen;
    const auto add = [&](terms::TermId id) {
      if (translation_.Applies(id) && seen.insert(id.index).second) open.push_back(id);
    };
    std::ranges::for_each(assumed_, add);
    std::ranges::for_each(conditions, add);
    while (!open.empty()) {
      const terms::TermId id = open.back();
      open.pop_back();
      const terms::Term& term = terms_[id];
      if (term.kind == terms::TermKind::kApply && Floats::IsNamed(terms_.Info(terms::FunctionId(term.a)).name))
        floats.push_back(id);
      terms_.ForEachOperand(term, add);
    }
    return floats;
  }

  /// Other functions may give anything: that nothing can be is true all the more.
  Answer AskWithFloats(std::span<const terms::TermId> floats, const z3::expr_vector& holds, uint64_t rest_ms,
                       const Limit& limit) {
    try {
      z3::solver solver(context_, "QF_BVFP");
      Floats meaning(context_);
      for (const terms::TermId id : floats) {
        const terms::Term& term = terms_[id];
        z3::expr_vector operands(context_);
        for (const terms::TermId argument : terms_.Arguments(term))
          operands.push_back(translation_.Translate(argument));
        const std::optional<z3::expr> result = meaning.Result(terms_.Info(terms::FunctionId(term.a)).name, operands);
        if (result) solver.add(translation_.Translate(id) == *result);
      }
      for (const terms::TermId condition : assumed_) solver.add(translation_.Holds(condition));
      Limit exact = limit.Within(rest_ms);
      exact.effort_ms = std::min(exact.effort_ms, kFloatsMs);
      return Ask(solver, holds, exact.Within(kFloatsMs * Limit::kPatience));
    } catch (const z3::exception&) {
      return Answer::kUnknown;
    }
  }

  z3::expr Applied(const terms::Term& term) {
    z3::sort_vector domain(context_);
    z3::expr_vector arguments(context_);
    for (const terms::TermId argument : terms_.Arguments(term)) {
      domain.push_back(context_.bv_sort(terms_.Width(argument)));
      arguments.push_back(translation_.Translate(argument));
    }
    const z3::func_decl function =
        context_.function(("f" + std::to_string(term.a)).c_str(), domain, context_.bv_sort(term.width));
    return function(arguments);
  }

  const terms::Terms& terms_;
  z3::context context_;
  z3::solver bits_, general_;
  Translation translation_;
  std::vector<bool> assumed_applies_ = {false};  // by level
  std::vector<terms::TermId> assumed_;           // on all levels
  std::vector<size_t> levels_;                   // how many there were before each Push
  std::unique_ptr<z3::model> model_;
};

}  // namespace
}  // namespace plcxx::solver

extern "C" __attribute__((visibility("default"))) plcxx::solver::Solver* plcxx_make_solver(
    const plcxx::terms::Terms& terms) {
  return new plcxx::solver::Z3Solver(terms);
}
