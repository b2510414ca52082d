// Simulated time: which periods a step of a scenario executes, and when.
//
// Several engines of one program run in lockstep: each period is executed by all of them, with the same time. Periods
// are executed at multiples of the schedule's period P only: as a rule at the beginning of their time (0, P, 2P ...),
// with Schedule::period_ends_its_time at its end (P, 2P ...). With Schedule::fast_ms slow and fast part have periods of
// their own. Not its job: what a period does (the program's own routine), what the machine around it does (the
// callbacks).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::sim {

/// Whether a step ended by itself, or was interrupted; kStuck: a part was not completed within
/// Schedule::most_periods periods.
enum class Step : uint8_t { kDone, kInterrupted, kStuck };

/// The shortest time that runs a part of the program: a period, or the fast part where that has a time of its own.
uint32_t UnitMs(const ir::Schedule& schedule);

class Clock {
 public:
  /// `engines`: at least one, all of `program`, which must outlive the clock as they must.
  Clock(const ir::Program& program, std::vector<Clocked*> engines);

  /// Called with the time of a period right before and right after all engines have executed it.
  std::function<void(uint32_t now_ms)> before_period, after_period;
  /// Asked after each period: true ends the step there.
  std::function<bool()> interrupted;

  enum class Part : uint8_t { kWholePeriod, kFastOnly };  // with Schedule::fast_ms a whole period is the slow part
  /// What was executed last.
  Part last_part() const { return last_part_; }

  /// The time t of the simulation: during a period that of the period, between two what has passed since power-on.
  uint64_t time_ms() const { return time_ms_; }
  /// Goes back to a moment, as the engines do.
  void GoTo(uint64_t time_ms) { time_ms_ = time_ms; }

  /// Every engine initializes itself; t = 0.
  void PowerOn();
  /// The host stores the retentive memory where the program asks for it, then PowerOn.
  void PowerCycle();
  /// The first half of PowerCycle, of one engine.
  static void PowerOff(const ir::Program& program, Clocked& engine);
  /// Whole periods until `count` slow cycles have been completed.
  Step RunSlow(uint32_t count);
  /// Every period whose time lies in [t, t + ms), or in (t, t + ms] when periods end their time; then t + ms. When that
  /// is not a period's, the schedule's `elapse` runs at t + ms, and with `elapses_every_ms` at every other millisecond,
  /// too.
  Step RunMs(uint64_t ms);
  /// The one of the three that is not 0, the first of them; none: nothing.
  Step RunFor(uint32_t slow, uint32_t fast, uint64_t ms);
  /// `count` times the fast part alone; with Schedule::fast_done whole periods until it has run so often.
  Step RunFast(uint32_t count);

 private:
  /// The part at the time t as it is, t stays.
  Step RunPart(Part part);
  Step RunParts(Part part, uint32_t count);
  Step RunMsByParts(uint64_t ms);

  /// One period at its next time; then t is the end of its time. Never kStuck.
  Step RunPeriod(Part part);
  uint64_t NextPeriod() const;
  /// `elapse` at those of the milliseconds (t, end] for which it is meant, none of which is a period's; then t = end.
  void Elapse(uint64_t end);
  void ElapseEachMsBefore(uint64_t end);
  /// Whole periods until the place `counter` has counted `count` more.
  Step RunUntil(ir::PlaceId counter, uint32_t count);

  const ir::Program& program_;
  std::vector<Clocked*> engines_;
  uint64_t period_ms_;
  uint64_t time_ms_ = 0;
  Part last_part_ = Part::kWholePeriod;
};

}  // namespace plcxx::sim
