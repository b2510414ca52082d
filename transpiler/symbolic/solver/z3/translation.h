// Terms as Z3's expressions; what a function gives is a variable. For the files of this module only.
#pragma once

#include <z3++.h>

#include <string>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

class Translation {
 public:
  Translation(z3::context& context, const terms::Terms& terms)
      : context_(context), terms_(terms), one_(context.bv_val(1, 1)) {}

  /// Of a term that has been translated: whether it depends on what a function gives.
  bool Applies(terms::TermId term) const { return applies_[term.index]; }
  z3::expr Holds(terms::TermId condition) { return Translate(condition) == one_; }

  /// Operands first, without recursion: a chain of branches may be as deep as the program is long.
  z3::expr Translate(terms::TermId root) {
    if (asts_.size() < terms_.size()) {
      asts_.resize(terms_.size(), z3::ast(context_));
      known_.resize(terms_.size());
      applies_.resize(terms_.size());
    }
    std::vector<terms::TermId> open{root};
    while (!open.empty()) {
      const terms::TermId id = open.back();
      if (known_[id.index]) {
        open.pop_back();
        continue;
      }
      bool complete = true;
      bool applies = terms_[id].kind == terms::TermKind::kApply;
      if (!applies) {
        terms_.ForEachOperand(terms_[id], [&](terms::TermId operand) {
          if (!known_[operand.index]) {
            complete = false;
            open.push_back(operand);
          }
          applies = applies || applies_[operand.index];
        });
      }
      if (!complete) continue;
      asts_[id.index] = Make(id);
      known_[id.index] = true;
      applies_[id.index] = applies;
      open.pop_back();
    }
    return Get(root.index);
  }

 private:
  z3::expr Get(uint32_t id) { return z3::expr(context_, asts_[id]); }
  z3::expr AsBit(const z3::expr& condition) { return z3::ite(condition, one_, context_.bv_val(0, 1)); }

  z3::expr Make(terms::TermId id) {
    const terms::Term& term = terms_[id];
    switch (term.kind) {
      case terms::TermKind::kConst:
        return context_.bv_val((uint64_t{term.b} << 32) | term.a, term.width);
      case terms::TermKind::kVariable:
        return context_.bv_const(("v" + std::to_string(term.a)).c_str(), term.width);
      case terms::TermKind::kNot:
        return ~Get(term.a);
      case terms::TermKind::kAnd:
        return Get(term.a) & Get(term.b);
      case terms::TermKind::kOr:
        return Get(term.a) | Get(term.b);
      case terms::TermKind::kXor:
        return Get(term.a) ^ Get(term.b);
      case terms::TermKind::kAdd:
        return Get(term.a) + Get(term.b);
      case terms::TermKind::kSub:
        return Get(term.a) - Get(term.b);
      case terms::TermKind::kMul:
        return Get(term.a) * Get(term.b);
      case terms::TermKind::kUdiv:
        return z3::udiv(Get(term.a), Get(term.b));
      case terms::TermKind::kUrem:
        return z3::urem(Get(term.a), Get(term.b));
      case terms::TermKind::kSdiv:
        return Get(term.a) / Get(term.b);
      case terms::TermKind::kSrem:
        return z3::srem(Get(term.a), Get(term.b));
      case terms::TermKind::kShl:
        return z3::shl(Get(term.a), Get(term.b));
      case terms::TermKind::kLshr:
        return z3::lshr(Get(term.a), Get(term.b));
      case terms::TermKind::kAshr:
        return z3::ashr(Get(term.a), Get(term.b));
      case terms::TermKind::kEq:
        return AsBit(Get(term.a) == Get(term.b));
      case terms::TermKind::kUlt:
        return AsBit(z3::ult(Get(term.a), Get(term.b)));
      case terms::TermKind::kSlt:
        return AsBit(Get(term.a) < Get(term.b));
      case terms::TermKind::kIte:
        return z3::ite(Get(term.a) == one_, Get(term.b), Get(term.c));
      case terms::TermKind::kConcat:
        return z3::concat(Get(term.a), Get(term.b));
      case terms::TermKind::kExtract:
        return Get(term.a).extract(term.b + term.width - 1, term.b);
      case terms::TermKind::kApply:
        return context_.bv_const(("a" + std::to_string(id.index)).c_str(), term.width);
    }
    PLCXX_UNREACHABLE();
  }

  z3::context& context_;
  const terms::Terms& terms_;
  z3::expr one_;
  std::vector<z3::ast> asts_;  // by TermId, where known_
  std::vector<bool> known_;
  std::vector<bool> applies_;  // functions, it or what it is made of
};

}  // namespace plcxx::solver
