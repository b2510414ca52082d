#include "transpiler/sim/clock.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::sim {

uint32_t UnitMs(const ir::Schedule& schedule) {
  return std::max(1u, schedule.fast_ms != 0 ? schedule.fast_ms : schedule.period_ms);
}

Clock::Clock(const ir::Program& program, std::vector<Clocked*> engines)
    : program_(program), engines_(std::move(engines)), period_ms_(std::max(1u, program.schedule.period_ms)) {
  PLCXX_CHECK(!engines_.empty());
}

void Clock::PowerOn() {
  for (Clocked* engine : engines_) engine->PowerOn();
  time_ms_ = 0;
}

void Clock::PowerOff(const ir::Program& program, Clocked& engine) {
  if (!program.schedule.retention) return;
  const ir::PlaceId asked = program.schedule.retain_at_power_off;
  if (!asked.valid() || engine.Read(program.places[asked]) != 0) engine.StoreRetentive();
}

void Clock::PowerCycle() {
  for (Clocked* engine : engines_) PowerOff(program_, *engine);
  PowerOn();
}

uint64_t Clock::NextPeriod() const {
  if (program_.schedule.period_ends_its_time) return (time_ms_ / period_ms_ + 1) * period_ms_;
  return (time_ms_ + period_ms_ - 1) / period_ms_ * period_ms_;
}

Step Clock::RunPart(Part part) {
  const auto now = static_cast<uint32_t>(time_ms_);  // a control's clock wraps, too
  last_part_ = part;
  if (before_period) before_period(now);
  for (Clocked* engine : engines_) {
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
  return interrupted && interrupted() ? Step::kInterrupted : Step::kDone;
}

Step Clock::RunPeriod(Part part) {
  const uint64_t at = NextPeriod();
  ElapseEachMsBefore(at);
  time_ms_ = at;  // what the callbacks see is the time of their period
  const Step step = RunPart(part);
  if (!program_.schedule.period_ends_its_time) time_ms_ = at + period_ms_;
  return step;
}

Step Clock::RunParts(Part part, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (RunPart(part) == Step::kInterrupted) return Step::kInterrupted;
  }
  return Step::kDone;
}

/// Time passes in these runs only, so that it counts their periods.
Step Clock::RunMsByParts(uint64_t ms) {
  const uint32_t fast_ms = program_.schedule.fast_ms;
  for (const uint64_t end = time_ms_ + ms; time_ms_ < end;) {
    const uint64_t fast = (time_ms_ / fast_ms + 1) * fast_ms, slow = (time_ms_ / period_ms_ + 1) * period_ms_;
    time_ms_ = std::min({end, fast, slow});
    if (time_ms_ == fast && RunPart(Part::kFastOnly) == Step::kInterrupted) return Step::kInterrupted;
    if (time_ms_ == slow && RunPart(Part::kWholePeriod) == Step::kInterrupted) return Step::kInterrupted;
  }
  return Step::kDone;
}

void Clock::ElapseEachMsBefore(uint64_t end) {
  if (!program_.schedule.elapses_every_ms) return;
  while (time_ms_ + 1 < end) Elapse(time_ms_ + 1);
}

void Clock::Elapse(uint64_t end) {
  ElapseEachMsBefore(end);
  time_ms_ = end;
  for (Clocked* engine : engines_) engine->RunElapse(static_cast<uint32_t>(end));
}

Step Clock::RunFor(uint32_t slow, uint32_t fast, uint64_t ms) {
  if (slow != 0) return RunSlow(slow);
  if (fast != 0) return RunFast(fast);
  return ms != 0 ? RunMs(ms) : Step::kDone;
}

Step Clock::RunSlow(uint32_t count) {
  if (program_.schedule.fast_ms != 0) return RunParts(Part::kWholePeriod, count);
  return RunUntil(program_.schedule.slow_done, count);
}

Step Clock::RunUntil(ir::PlaceId counter, uint32_t count) {
  const auto completed_so_far = [this, counter] {
    return static_cast<uint32_t>(engines_.front()->Read(program_.places[counter]));
  };
  for (uint32_t done = 0; done < count;) {
    if (!counter.valid()) {  // a program that does not count them completes one in each period
      if (RunPeriod(Part::kWholePeriod) == Step::kInterrupted) return Step::kInterrupted;
      ++done;
      continue;
    }
    const uint32_t before = completed_so_far();
    uint32_t completed = 0;
    for (uint32_t periods = 0; completed == 0; ++periods) {
      if (periods == program_.schedule.most_periods) return Step::kStuck;
      if (RunPeriod(Part::kWholePeriod) == Step::kInterrupted) return Step::kInterrupted;
      completed = completed_so_far() - before;  // by difference: the count wraps
    }
    done += std::min(completed, count - done);
  }
  return Step::kDone;
}

Step Clock::RunMs(uint64_t ms) {
  const ir::Schedule& schedule = program_.schedule;
  if (schedule.fast_ms != 0) return RunMsByParts(ms);
  const uint64_t end = time_ms_ + ms;
  const uint64_t behind = schedule.period_ends_its_time ? end + 1 : end;  // periods before it are executed
  while (NextPeriod() < behind) {
    if (RunPeriod(Part::kWholePeriod) == Step::kInterrupted) return Step::kInterrupted;
  }
  if (time_ms_ < end && schedule.elapse.valid()) Elapse(end);
  time_ms_ = end;
  return Step::kDone;
}

Step Clock::RunFast(uint32_t count) {
  if (program_.schedule.fast_ms != 0) return RunParts(Part::kFastOnly, count);
  if (program_.schedule.fast_done.valid()) return RunUntil(program_.schedule.fast_done, count);
  for (uint32_t i = 0; i < count; ++i) {
    if (RunPeriod(Part::kFastOnly) == Step::kInterrupted) return Step::kInterrupted;
  }
  return Step::kDone;
}

}  // namespace plcxx::sim
