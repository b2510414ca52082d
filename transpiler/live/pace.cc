#include "transpiler/live/pace.h"

#include <algorithm>

namespace plcxx::live {
namespace {

constexpr double kUsPerMs = 1000;
/// Of real time: what a slow machine or a stopped process owes is not run at once.
constexpr uint64_t kMostOwedUs = 250'000;
constexpr uint64_t kUnlimited = 1000;

}  // namespace

void Pace::Begin(uint64_t us, uint32_t unit_ms, double speed) {
  begin_us_ = us;
  told_ = 0;
  periods_per_us_ = speed / (unit_ms * kUsPerMs);
}

uint64_t Pace::Due(uint64_t us) {
  if (periods_per_us_ == 0) return kUnlimited;
  const uint64_t passed = us - std::min(us, begin_us_);
  const auto wanted = static_cast<uint64_t>(static_cast<double>(passed) * periods_per_us_);
  uint64_t due = wanted - std::min(wanted, told_);
  const uint64_t most = std::max<uint64_t>(1, static_cast<uint64_t>(kMostOwedUs * periods_per_us_));
  due = std::min(due, most);
  told_ = wanted;
  return due;
}

uint64_t Pace::UsUntilNext(uint64_t us) const {
  if (periods_per_us_ == 0) return 0;
  const auto next = begin_us_ + static_cast<uint64_t>(static_cast<double>(told_ + 1) / periods_per_us_) + 1;
  return next - std::min(next, us);
}

}  // namespace plcxx::live
