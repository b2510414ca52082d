// A program in the simulator with the simulated control around it, at one moment of its time.
//
// In: a compiled program. Out: the machine after each stretch of time, what it told the operator and the host, and a
// copy of the moment to go back to. A stretch can be stopped before any statement; then the memory is that of a period
// half done, to be looked at, and the way on is back to the beginning of the period. Not its job: which stretches run
// and what is done between them (timeline.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::live {

/// What is run as one piece; one period at most, but for kMs off the grid of periods.
enum class AdvanceKind : uint8_t {
  kMs,          // `run: {ms: n}`
  kSlowPeriod,  // one period on the way of `run: {slow: n}`
  kFastPeriod   // one period on the way of `run: {fast: n}`
};
struct Advance {
  AdvanceKind kind = AdvanceKind::kMs;
  uint32_t ms = 0;  // of kMs
  bool operator==(const Advance&) const = default;
};

class Machine {
 public:
  /// `compilation` is without errors, optimized, and outlives the machine.
  explicit Machine(const compilation::Compilation& compilation);
  /// With a simulator of this program that looks at what happens.
  Machine(const compilation::Compilation& compilation, std::unique_ptr<sim::Simulator> simulator);
  /// Before power-on, or Restore: what moves around the program.
  void Attach(std::shared_ptr<const scenarios::BoundPlant> plant) { control_.Attach(std::move(plant)); }

  /// Asked before each statement of a stretch: true stops it there.
  using StopAt = std::function<bool(ir::StatementId statement)>;

  void PowerOn();
  void PowerCycle();
  /// False: `stop` ended it, or it took too long. Most periods have no `stop`.
  bool Run(const Advance& advance, const StopAt& stop);
  /// What has run to its end before, once more.
  void RunAgain(const Advance& advance);
  /// A whole period on the memory as it is, at this time of the program's clock; the machine around it stands still.
  /// Afterwards the memory is that of a period that nobody asked for.
  void ComputeAgain(uint32_t now_ms);

  void Set(const dialects::Location& location, uint64_t value) { control_.Set(location, value); }
  void Force(const dialects::Location& location, uint64_t value);
  void Release(const dialects::Location& location);
  void SendText(const std::string& text) { simulator_->SendText(text); }
  void EnableStatement(ir::StatementId statement, bool enabled);
  bool IsOff(ir::StatementId statement) const { return off_[statement.index]; }

  uint64_t Read(const dialects::Location& location);
  uint64_t time_ms() const { return clock_.time_ms(); }
  sim::Clock::Part last_part() const { return clock_.last_part(); }
  sim::Simulator& simulator() { return *simulator_; }
  scenarios::ScenarioControl& control() { return control_; }
  const std::vector<bool>& off() const { return off_; }
  /// By StatementId: the number of the stretch in which it began last, from 1; 0: never.
  const std::vector<uint32_t>& executed() const { return executed_; }
  uint32_t stretch() const { return stretch_; }

  struct Saved {
    sim::Simulator::Saved simulator;
    sim::Simulator::Noted noted;
    scenarios::ScenarioControl::Saved control;
    std::vector<uint32_t> messages;
    std::vector<bool> off;
    uint64_t time_ms = 0;
  };
  Saved Save() const;
  void Restore(const Saved& saved);

 private:
  /// The next stretch, which notes what is executed, and ends where `stop` or the clock on the wall says so.
  void BeginStretch(const StopAt& stop);

  const compilation::Compilation& compilation_;
  std::unique_ptr<sim::Simulator> simulator_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
  std::vector<bool> off_;
  std::vector<uint32_t> executed_;
  uint32_t stretch_ = 0;
};

}  // namespace plcxx::live
