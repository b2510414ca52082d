#include "transpiler/sim/clock.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::sim {

Clock::Clock(const ir::Program& program, std::vector<Engine*> engines)
    : program_(program), engines_(std::move(engines)), period_ms_(std::max(1u, program.schedule.period_ms)) {
  PLCXX_CHECK(!engines_.empty());
}

void Clock::PowerOn() {
  for (Engine* engine : engines_) engine->PowerOn();
  time_ms_ = 0;
}

void Clock::PowerCycle() {
  const ir::Schedule& schedule = program_.schedule;
  for (Engine* engine : engines_) {
    if (!schedule.retention) continue;
    const ir::PlaceId asked = schedule.retain_at_power_off;
    if (!asked.valid() || engine->Read(program_.places[asked]) != 0) engine->StoreRetentive();
  }
  PowerOn();
}

uint64_t Clock::NextPeriod() const { return (time_ms_ + period_ms_ - 1) / period_ms_ * period_ms_; }

void Clock::RunPeriod(Part part) {
  const uint64_t begin = NextPeriod();
  const auto now = static_cast<uint32_t>(begin);  // a control's clock wraps, too
  time_ms_ = begin;                               // what the callbacks see is the time of their period
  if (before_period) before_period(now);
  for (Engine* engine : engines_) {
    switch (part) {
      case Part::kWholePeriod:
        engine->RunPeriod(now);
        break;
      case Part::kFastOnly:
        engine->RunFastOnly(now);
        break;
    }
  }
  if (after_period) after_period(now);
  time_ms_ = begin + period_ms_;
}

uint32_t Clock::SlowCycles() {
  return static_cast<uint32_t>(engines_.front()->Read(program_.places[program_.schedule.slow_done]));
}

Step Clock::RunSlow(uint32_t count) {
  for (uint32_t done = 0; done < count;) {
    if (!program_.schedule.slow_done.valid()) {  // a program that does not count them completes one in each period
      RunPeriod(Part::kWholePeriod);
      ++done;
      continue;
    }
    const uint32_t before = SlowCycles();
    uint32_t completed = 0;
    for (uint32_t periods = 0; completed == 0; ++periods) {
      if (periods == kLongestSlowCycle) return Step::kStuck;
      RunPeriod(Part::kWholePeriod);
      completed = SlowCycles() - before;  // by difference: the count wraps
    }
    done += std::min(completed, count - done);
  }
  return Step::kDone;
}

void Clock::RunMs(uint64_t ms) {
  const uint64_t end = time_ms_ + ms;
  while (NextPeriod() < end) RunPeriod(Part::kWholePeriod);
  time_ms_ = end;
}

void Clock::RunFast(uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) RunPeriod(Part::kFastOnly);
}

}  // namespace plcxx::sim
