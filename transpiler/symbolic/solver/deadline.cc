#include "transpiler/symbolic/solver/deadline.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace plcxx::solver {
namespace {

/// How much longer a step of the solver may take than Limit counts for it, seen with the samples.
constexpr uint64_t kSlowestStep = 2;

uint64_t NowMs(Clock clock) {
  if (clock == Clock::kProcessor) {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<uint64_t>(used.tv_sec) * 1000 + static_cast<uint64_t>(used.tv_nsec) / 1'000'000;
  }
  using std::chrono::milliseconds;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<uint64_t>(std::chrono::duration_cast<milliseconds>(now).count());
}

}  // namespace

Deadline::Deadline(Clock clock, uint64_t milliseconds) : clock_(clock) {
  const uint64_t now = NowMs(clock);
  end_ms_ = now + std::min(milliseconds, std::numeric_limits<uint64_t>::max() - now);
}

uint64_t Deadline::RestMs() const {
  const uint64_t now = NowMs(clock_);
  return end_ms_ - std::min(end_ms_, now);
}

Limit Deadline::LimitFor(uint32_t effort_ms) const {
  const uint64_t rest = std::max<uint64_t>(1, RestMs());
  if (clock_ == Clock::kWall) return Limit::Effort(effort_ms).Within(rest);
  // The last questions are smaller ones: none may take longer than what is left.
  return Limit::Effort(
      static_cast<uint32_t>(std::min<uint64_t>(effort_ms, std::max<uint64_t>(1, rest / kSlowestStep))));
}

}  // namespace plcxx::solver
