#include "transpiler/live/timeline.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/check.h"

namespace plcxx::live {
namespace {

/// Going back costs at most so many periods of simulation, and each checkpoint memory.
constexpr uint64_t kBetweenCheckpoints = 250;

void Apply(const Action& action, Machine& machine) {
  switch (action.kind) {
    case ActionKind::kSet:
      machine.Set(action.location, action.value);
      return;
    case ActionKind::kForce:
      machine.Force(action.location, action.value);
      return;
    case ActionKind::kRelease:
      machine.Release(action.location);
      return;
    case ActionKind::kText:
      machine.SendText(action.text);
      return;
    case ActionKind::kSwitchOff:
    case ActionKind::kSwitchOn:
      machine.EnableStatement(action.statement, action.kind == ActionKind::kSwitchOn);
      return;
    case ActionKind::kPowerCycle:
      machine.PowerCycle();
      return;
    case ActionKind::kExpect:
    case ActionKind::kExpectMessages:
      return;
  }
}

}  // namespace

Timeline::Timeline(const compilation::Compilation& compilation) : compilation_(compilation) { Restart(); }

void Timeline::Restart() {
  machine_ = std::make_unique<Machine>(compilation_);
  if (plant_) machine_->Attach(plant_);
  entries_.clear();
  stretches_.clear();
  checkpoints_.clear();
  at_.reset();
  period_ = end_ = 0;
  machine_->PowerOn();
  checkpoints_.push_back({.period = 0, .saved = machine_->Save()});
}

void Timeline::ApplyEntriesOf(uint64_t period, Machine& machine) const {
  const auto first = std::ranges::lower_bound(entries_, period, {}, &Entry::period);
  for (auto entry = first; entry != entries_.end() && entry->period == period; ++entry) {
    Apply(entry->action, machine);
  }
}

void Timeline::Do(Action action) {
  if (!is_between()) Forward({}, nullptr);
  ForgetAhead();
  Apply(action, *machine_);
  entries_.push_back({.period = period_, .action = std::move(action)});
}

void Timeline::ForgetAhead() {
  while (!entries_.empty() && entries_.back().period > period_) entries_.pop_back();
  while (!stretches_.empty() && stretches_.back().first >= period_) stretches_.pop_back();
  while (checkpoints_.back().period > period_) checkpoints_.pop_back();
  end_ = period_;
}

Advance Timeline::AdvanceOf(uint64_t period) const {
  const auto behind = std::ranges::upper_bound(stretches_, period, {}, &Stretch::first);
  PLCXX_CHECK(behind != stretches_.begin());
  return std::prev(behind)->advance;
}

bool Timeline::RunPeriod(const Advance& how, uint32_t skip, const Machine::StopAt& stop) {
  at_.reset();
  if (!stop) return machine_->Run(how, nullptr);
  uint32_t begun = 0;
  return machine_->Run(how, [&](ir::StatementId statement) {
    if (begun < skip || !stop(statement)) {
      ++begun;
      return false;
    }
    at_ = Within{.begun = begun, .statement = statement};
    return true;
  });
}

bool Timeline::Forward(const Advance& how, const Machine::StopAt& stop) {
  if (period_ == end_ && is_between() && (stretches_.empty() || stretches_.back().advance != how)) {
    stretches_.push_back({.first = period_, .advance = how});
  }
  uint32_t skip = 0;
  if (at_) {
    skip = at_->begun + 1;  // not to stop at the same one again
    machine_->Restore(*begin_);
  } else if (stop) {
    begin_ = machine_->Save();
  }
  if (period_ == end_) ++end_;
  if (!RunPeriod(AdvanceOf(period_), skip, stop)) {
    if (!at_) GoTo(period_);
    return false;
  }
  Arrive(period_ + 1);
  return true;
}

void Timeline::Arrive(uint64_t period) {
  period_ = period;
  if (period_ % kBetweenCheckpoints == 0 && checkpoints_.back().period < period_) {
    checkpoints_.push_back({.period = period_, .saved = machine_->Save()});
    while (checkpoints_[1].period + kMostBack <= period_) checkpoints_.pop_front();
  }
  ApplyEntriesOf(period_, *machine_);
}

void Timeline::BackStatement() {
  if (is_between()) {
    uint32_t count = 0;
    // Not each period has a part that is due.
    while (count == 0 && period_ != first()) {
      GoTo(period_ - 1);
      begin_ = machine_->Save();
      machine_->Run(AdvanceOf(period_), [&count](ir::StatementId) {
        ++count;
        return false;
      });
      machine_->Restore(*begin_);
    }
    if (count != 0) RunPeriod(AdvanceOf(period_), count - 1, [](ir::StatementId) { return true; });
    return;
  }
  const uint32_t begun = at_->begun;
  machine_->Restore(*begin_);
  at_.reset();
  if (begun != 0) RunPeriod(AdvanceOf(period_), begun - 1, [](ir::StatementId) { return true; });
}

void Timeline::GoTo(uint64_t period) {
  period = std::clamp(period, first(), end_);
  at_.reset();
  const auto behind = std::ranges::upper_bound(checkpoints_, period, {}, &Checkpoint::period);
  const Checkpoint& from = *std::prev(behind);
  machine_->Restore(from.saved);
  period_ = from.period;
  ApplyEntriesOf(period_, *machine_);
  while (period_ < period) {
    RunPeriod(AdvanceOf(period_), 0, nullptr);
    ++period_;
    ApplyEntriesOf(period_, *machine_);
  }
  machine_->simulator().TakeEvents();
  machine_->control().TakeMessages();
}

void Timeline::RepeatOn(Machine& machine, uint64_t periods) const {
  const uint64_t wanted = period_ - std::min(period_, periods);
  const auto behind = std::ranges::upper_bound(checkpoints_, wanted, {}, &Checkpoint::period);
  const Checkpoint& from = behind == checkpoints_.begin() ? checkpoints_.front() : *std::prev(behind);
  if (plant_) machine.Attach(plant_);
  machine.Restore(from.saved);
  for (uint64_t period = from.period; period < period_; ++period) {
    ApplyEntriesOf(period, machine);
    machine.RunAgain(AdvanceOf(period));
  }
  ApplyEntriesOf(period_, machine);
}

}  // namespace plcxx::live
