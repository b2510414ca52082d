// Solver by Z3; see solver.h for what it has to do.
//
// What a function gives is a variable at first: most questions are about bits alone then, and Z3's solver for these is
// many times faster than the one that knows functions. That one is asked where equal arguments may matter: where the
// first finds values and functions are there. For it each of these variables is defined as what the function gives.
#include <z3++.h>

#include <chrono>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/solver/z3/limits.h"
#include "transpiler/symbolic/solver/z3/translation.h"

namespace plcxx::solver {
namespace {

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
  }
  void Push() override {
    bits_.push();
    general_.push();
    assumed_applies_.push_back(assumed_applies_.back());
  }
  void Pop() override {
    bits_.pop();
    general_.pop();
    assumed_applies_.pop_back();
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
    const Answer answer = ask(bits_, false);
    return applies && answer != Answer::kNever ? ask(general_, true) : answer;
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
  std::unique_ptr<z3::model> model_;
};

}  // namespace
}  // namespace plcxx::solver

extern "C" __attribute__((visibility("default"))) plcxx::solver::Solver* plcxx_make_solver(
    const plcxx::terms::Terms& terms) {
  return new plcxx::solver::Z3Solver(terms);
}
