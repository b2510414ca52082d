#include "transpiler/symbolic/solver/refuted.h"

#include <array>

namespace plcxx::solver {
namespace {

constexpr uint32_t kQuestionMs = 20;

}  // namespace

bool Refuted::Has(terms::TermId condition, uint64_t rest_ms) {
  if (terms_.IsConst(condition)) return terms_.IsFalse(condition);
  const auto known = known_.find(condition.index);
  if (known != known_.end()) return known->second;
  if (!bits_) bits_ = LoadBitSolver(terms_);
  if (!bits_ || rest_ms == 0) return false;
  const std::array conditions = {condition};
  const bool never = bits_->Check(conditions, Limit::Effort(kQuestionMs).Within(rest_ms)) == Answer::kNever;
  known_.emplace(condition.index, never);
  return never;
}

}  // namespace plcxx::solver
