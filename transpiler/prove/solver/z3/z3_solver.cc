// Solver by Z3. The only file that includes it; see solver.h for what it has to do.
//
// What a function gives is a variable at first: most questions are about bits alone then, and Z3's solver for these is
// many times faster than the one that knows functions. That one is asked where equal arguments may matter: where the
// first finds values and functions are there. For it each of these variables is defined as what the function gives.
#include <z3++.h>

#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "transpiler/prove/solver/solver.h"

namespace plcxx::prove {
namespace {

class Z3Solver : public Solver {
 public:
  explicit Z3Solver(const Terms& terms)
      : terms_(terms), bits_(context_, "QF_BV"), general_(context_), one_(context_.bv_val(1, 1)) {}

  void Assume(TermId condition) override {
    const z3::expr holds = Holds(condition);
    bits_.add(holds);
    general_.add(holds);
    Define(general_, {&condition, 1});
    assumed_applies_.back() = assumed_applies_.back() || applies_[condition.index];
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

  Answer Check(std::span<const TermId> conditions, uint32_t milliseconds) override {
    model_.reset();
    z3::expr_vector holds(context_);
    bool applies = assumed_applies_.back();
    for (const TermId condition : conditions) {
      holds.push_back(Holds(condition));
      applies = applies || applies_[condition.index];
    }
    const auto ask = [&](z3::solver& solver, bool defines) {
      solver.push();
      if (defines) Define(solver, conditions);
      const Answer answer = Ask(solver, holds, milliseconds);
      solver.pop();
      return answer;
    };
    const Answer answer = ask(bits_, false);
    return applies && answer != Answer::kNever ? ask(general_, true) : answer;
  }

  uint64_t ValueOf(TermId term) override {
    PLCXX_CHECK(model_ != nullptr);
    const z3::expr value = model_->eval(Translate(term), true);
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

  /// Tells `solver` what the variables are that stand for functions in these conditions.
  void Define(z3::solver& solver, std::span<const TermId> conditions) {
    std::vector<TermId> open;
    std::unordered_set<uint32_t> seen;
    const auto add = [&](TermId id) {
      if (applies_[id.index] && seen.insert(id.index).second) open.push_back(id);
    };
    for (const TermId condition : conditions) add(condition);
    while (!open.empty()) {
      const Term& term = terms_[open.back()];
      if (term.kind == TermKind::kApply) solver.add(Get(open.back().index) == Applied(term));
      open.pop_back();
      terms_.ForEachOperand(term, add);
    }
  }

  z3::expr Holds(TermId condition) { return Translate(condition) == one_; }
  z3::expr Get(uint32_t id) { return z3::expr(context_, asts_[id]); }
  z3::expr AsBit(const z3::expr& condition) { return z3::ite(condition, one_, context_.bv_val(0, 1)); }

  /// Operands first, without recursion: a chain of branches may be as deep as the program is long.
  z3::expr Translate(TermId root) {
    if (asts_.size() < terms_.size()) {
      asts_.resize(terms_.size(), z3::ast(context_));
      known_.resize(terms_.size());
      applies_.resize(terms_.size());
    }
    std::vector<TermId> open{root};
    while (!open.empty()) {
      const TermId id = open.back();
      if (known_[id.index]) {
        open.pop_back();
        continue;
      }
      bool complete = true;
      bool applies = terms_[id].kind == TermKind::kApply;
      terms_.ForEachOperand(terms_[id], [&](TermId operand) {
        applies = applies || applies_[operand.index];
        if (known_[operand.index]) return;
        complete = false;
        open.push_back(operand);
      });
      if (!complete) continue;
      asts_[id.index] = Make(id.index, terms_[id]);
      known_[id.index] = true;
      applies_[id.index] = applies;
      open.pop_back();
    }
    return Get(root.index);
  }

  z3::expr Make(uint32_t number, const Term& term) {
    switch (term.kind) {
      case TermKind::kConst:
        return context_.bv_val((uint64_t{term.b} << 32) | term.a, term.width);
      case TermKind::kVariable:
        return context_.bv_const(("v" + std::to_string(term.a)).c_str(), term.width);
      case TermKind::kNot:
        return ~Get(term.a);
      case TermKind::kAnd:
        return Get(term.a) & Get(term.b);
      case TermKind::kOr:
        return Get(term.a) | Get(term.b);
      case TermKind::kXor:
        return Get(term.a) ^ Get(term.b);
      case TermKind::kAdd:
        return Get(term.a) + Get(term.b);
      case TermKind::kSub:
        return Get(term.a) - Get(term.b);
      case TermKind::kMul:
        return Get(term.a) * Get(term.b);
      case TermKind::kUdiv:
        return z3::udiv(Get(term.a), Get(term.b));
      case TermKind::kUrem:
        return z3::urem(Get(term.a), Get(term.b));
      case TermKind::kSdiv:
        return Get(term.a) / Get(term.b);
      case TermKind::kSrem:
        return z3::srem(Get(term.a), Get(term.b));
      case TermKind::kShl:
        return z3::shl(Get(term.a), Get(term.b));
      case TermKind::kLshr:
        return z3::lshr(Get(term.a), Get(term.b));
      case TermKind::kAshr:
        return z3::ashr(Get(term.a), Get(term.b));
      case TermKind::kEq:
        return AsBit(Get(term.a) == Get(term.b));
      case TermKind::kUlt:
        return AsBit(z3::ult(Get(term.a), Get(term.b)));
      case TermKind::kSlt:
        return AsBit(Get(term.a) < Get(term.b));
      case TermKind::kIte:
        return z3::ite(Get(term.a) == one_, Get(term.b), Get(term.c));
      case TermKind::kConcat:
        return z3::concat(Get(term.a), Get(term.b));
      case TermKind::kExtract:
        return Get(term.a).extract(term.b + term.width - 1, term.b);
      case TermKind::kApply:
        return context_.bv_const(("a" + std::to_string(number)).c_str(), term.width);
    }
    PLCXX_UNREACHABLE();
  }

  z3::expr Applied(const Term& term) {
    z3::sort_vector domain(context_);
    z3::expr_vector arguments(context_);
    for (const TermId argument : terms_.Arguments(term)) {
      domain.push_back(context_.bv_sort(terms_.Width(argument)));
      arguments.push_back(Get(argument.index));
    }
    const z3::func_decl function =
        context_.function(("f" + std::to_string(term.a)).c_str(), domain, context_.bv_sort(term.width));
    return function(arguments);
  }

  const Terms& terms_;
  z3::context context_;
  z3::solver bits_, general_;
  std::vector<bool> assumed_applies_ = {false};  // by level
  z3::expr one_;
  std::vector<z3::ast> asts_;  // by TermId, where known_
  std::vector<bool> known_;
  std::vector<bool> applies_;  // functions, it or what it is made of
  std::unique_ptr<z3::model> model_;
};

}  // namespace
}  // namespace plcxx::prove

extern "C" __attribute__((visibility("default"))) plcxx::prove::Solver* plcxx_make_solver(
    const plcxx::prove::Terms& terms) {
  return new plcxx::prove::Z3Solver(terms);
}
