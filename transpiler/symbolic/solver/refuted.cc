#include "transpiler/symbolic/solver/refuted.h"

#include <algorithm>
#include <array>

namespace plcxx::solver {
namespace {

constexpr uint32_t kQuestionMs = 20;

}  // namespace

bool Refuted::Has(terms::TermId condition, uint64_t series, uint64_t rest_ms) {
  if (terms_.IsConst(condition)) return terms_.IsFalse(condition);
  const auto known = known_.find(condition.index);
  if (known != known_.end()) return known->second;
  if (!bits_) bits_ = LoadBitSolver(terms_);
  if (!bits_ || rest_ms == 0) return false;
  Series& before = series_[series];
  if (before.passed < std::min(kMostPassed, (1U << std::min(before.in_vain, 8U)) - 1)) {
    ++before.passed;
    return false;
  }
  const std::array conditions = {condition};
  const Answer answer = bits_->Check(conditions, Limit::Effort(kQuestionMs).Within(rest_ms));
  before = {.in_vain = answer == Answer::kUnknown ? before.in_vain + 1 : 0};
  known_.emplace(condition.index, answer == Answer::kNever);
  return answer == Answer::kNever;
}

}  // namespace plcxx::solver
