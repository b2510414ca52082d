// BitSolver by Z3's propositional solver, to which bit vectors are bits; see bit_solver.h for what it has to do.
#include <z3++.h>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/solver/z3/limits.h"
#include "transpiler/symbolic/solver/z3/translation.h"

namespace plcxx::solver {
namespace {

/// "Finite domains": bits only, incremental, with assumptions.
constexpr const char* kLogic = "QF_FD";

class Z3BitSolver : public BitSolver {
 public:
  explicit Z3BitSolver(const terms::Terms& terms) : solver_(context_, kLogic), translation_(context_, terms) {
    z3::params parameters(context_);
    parameters.set("core.minimize", false);
    solver_.set(parameters);
  }

  void Assume(terms::TermId condition) override { solver_.add(translation_.Holds(condition)); }

  Answer Check(std::span<const terms::TermId> conditions, const Limit& limit) override {
    model_.reset();
    needed_.assign(conditions.size(), false);
    try {
      z3::expr_vector assumptions(context_);
      std::unordered_map<uint32_t, size_t> index_of;  // by Z3's number of the literal
      std::vector<std::vector<size_t>> same(conditions.size());
      for (size_t i = 0; i < conditions.size(); ++i) {
        const z3::expr literal = LiteralOf(conditions[i]);
        const auto [at, added] = index_of.try_emplace(literal.id(), i);
        same[at->second].push_back(i);
        if (added) assumptions.push_back(literal);
      }
      solver_.set(Parameters(context_, limit));
      const z3::check_result result = solver_.check(assumptions);
      if (result == z3::sat) model_ = std::make_unique<z3::model>(solver_.get_model());
      if (result == z3::unsat) {
        for (const z3::expr& literal : solver_.unsat_core()) {
          const auto at = index_of.find(literal.id());
          if (at == index_of.end()) return Answer::kUnknown;
          for (const size_t i : same[at->second]) needed_[i] = true;
        }
      }
      return result == z3::unsat ? Answer::kNever : result == z3::sat ? Answer::kPossible : Answer::kUnknown;
    } catch (const z3::exception&) {
      return Answer::kUnknown;  // a limit inside a simplification
    }
  }

  const std::vector<bool>& needed() const override { return needed_; }

  uint64_t ValueOf(terms::TermId term) override {
    PLCXX_CHECK(model_ != nullptr);
    const z3::expr value = model_->eval(translation_.Translate(term), true);
    uint64_t number = 0;
    PLCXX_CHECK(value.is_numeral_u64(number));
    return number;
  }

 private:
  /// A name for the condition: only names and their negations can be assumptions.
  z3::expr LiteralOf(terms::TermId condition) {
    const auto found = literals_.find(condition.index);
    if (found != literals_.end()) return found->second;
    const z3::expr literal = context_.bool_const(("p" + std::to_string(condition.index)).c_str());
    solver_.add(literal == translation_.Holds(condition));
    literals_.emplace(condition.index, literal);
    return literal;
  }

  z3::context context_;
  z3::solver solver_;
  Translation translation_;
  std::unordered_map<uint32_t, z3::expr> literals_;  // by TermId
  std::vector<bool> needed_;
  std::unique_ptr<z3::model> model_;
};

}  // namespace
}  // namespace plcxx::solver

extern "C" __attribute__((visibility("default"))) plcxx::solver::BitSolver* plcxx_make_bit_solver(
    const plcxx::terms::Terms& terms) {
  return new plcxx::solver::Z3BitSolver(terms);
}
