// The run of a machine since it was switched on: what was done to it, how far it has come, and the way back.
//
// In: actions of the operator, and the wish to go on or back. Out: the machine at any of the last kMostBack periods. A
// moment of the past is reached from the checkpoint before it by doing again what was done: the same inputs at the same
// periods give the same machine. Whoever goes on from the past repeats what was recorded, until something else is done:
// then the rest is forgotten. Not its job: who wants to stop where (session.h).
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/live/machine.h"

namespace plcxx::live {

inline constexpr uint64_t kMostBack = 10'000;  // periods

enum class ActionKind : uint8_t {
  kSet,
  kForce,
  kRelease,
  kText,
  kSwitchOff,  // of a statement
  kSwitchOn,
  kPowerCycle,
  kExpect,         // changes nothing: what a scenario is to expect here
  kExpectMessages  // of those that became active since the last one
};

struct Action {
  ActionKind kind{};
  std::string name;  // the location, as it was written
  dialects::Location location;
  uint64_t value = 0;
  std::string text;                   // of kText
  ir::StatementId statement;          // of kSwitchOff, kSwitchOn
  std::vector<std::string> messages;  // of kExpectMessages
};

/// Done between two periods: before the one of this number, counted from 0.
struct Entry {
  uint64_t period = 0;
  Action action;
};

/// From this period on, so was run.
struct Stretch {
  uint64_t first = 0;
  Advance advance;
};

class Timeline {
 public:
  /// `compilation` outlives it. The machine is on.
  explicit Timeline(const compilation::Compilation& compilation);

  /// What moves around the program from the next Restart on; may be none.
  void Attach(std::shared_ptr<const scenarios::BoundPlant> plant) { plant_ = std::move(plant); }
  /// The machine as it is delivered, switched on: nothing is known of before.
  void Restart();
  void Do(Action action);

  /// Runs the period, or what is left of it. False: `stop` ended it before a statement, or it does not end: then the
  /// machine is at its beginning. `how` counts for a new period.
  bool Forward(const Advance& how, const Machine::StopAt& stop);
  void BackStatement();
  /// As far as it goes; from within a period the first step leads to its beginning.
  void Back(uint64_t periods) { GoTo(period_ - std::min(period_, is_between() ? periods : periods - 1)); }
  /// To the beginning of a period in [first(), end()].
  void GoTo(uint64_t period);

  Machine& machine() { return *machine_; }
  const std::shared_ptr<const scenarios::BoundPlant>& plant() const { return plant_; }
  uint64_t period() const { return period_; }  // that is next, or is half done
  uint64_t first() const { return checkpoints_.front().period; }
  uint64_t end() const { return end_; }
  bool is_between() const { return !at_; }
  /// Within a period: the statement that is next.
  ir::StatementId at() const { return at_ ? at_->statement : ir::StatementId(); }
  const std::deque<Entry>& entries() const { return entries_; }
  const std::vector<Stretch>& stretches() const { return stretches_; }
  Advance AdvanceOf(uint64_t period) const;

  /// Does to another machine of the program what was done to this one in so many periods at least, where there are so
  /// many.
  void RepeatOn(Machine& machine, uint64_t periods) const;

 private:
  struct Checkpoint {
    uint64_t period = 0;
    Machine::Saved saved;
  };
  /// Within a period: so many statements have begun, and which is next.
  struct Within {
    uint32_t begun = 0;
    ir::StatementId statement;
  };

  void ApplyEntriesOf(uint64_t period, Machine& machine) const;
  void Arrive(uint64_t period);
  void ForgetAhead();
  bool RunPeriod(const Advance& how, uint32_t skip, const Machine::StopAt& stop);

  const compilation::Compilation& compilation_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  std::unique_ptr<Machine> machine_;
  std::deque<Entry> entries_;       // ascending
  std::vector<Stretch> stretches_;  // ascending, each one different from the one before
  std::deque<Checkpoint> checkpoints_;
  std::optional<Machine::Saved> begin_;  // of the period that is half done
  std::optional<Within> at_;
  uint64_t period_ = 0, end_ = 0;
};

}  // namespace plcxx::live
