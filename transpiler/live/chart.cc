#include "transpiler/live/chart.h"

#include <algorithm>
#include <utility>

#include "transpiler/live/timeline.h"

namespace plcxx::live {

bool Chart::Watch(sim::Watched watched) {
  if (watched_.size() == kMostWatched) return false;
  watched_.push_back(std::move(watched));
  Clear();
  return true;
}

void Chart::Unwatch(size_t number) {
  if (number >= watched_.size()) return;
  const auto at = static_cast<std::ptrdiff_t>(number);
  watched_.erase(watched_.begin() + at);
  for (ChartSample& sample : samples_) sample.values.erase(sample.values.begin() + at);
  if (trigger_) {
    for (ChartSample& sample : trigger_->kept) sample.values.erase(sample.values.begin() + at);
  }
  ++version_;
}

void Chart::Clear() {
  samples_.clear();
  if (trigger_) Arm(std::move(trigger_->request));
  ++version_;
}

void Chart::GoBack(uint64_t period) {
  while (!samples_.empty() && samples_.back().period >= period) samples_.pop_back();
  if (trigger_ && trigger_->state != TriggerState::kComplete) Arm(std::move(trigger_->request));
  ++version_;
}

void Chart::Arm(TriggerRequest request) {
  if (request.condition) request.condition->Forget();
  trigger_ = Trigger{.request = std::move(request), .kept = {}, .level = {}};
  ++version_;
}

void Chart::Prime(const sim::ReadWatched& read, sim::Engine& engine, sim::Clock::Part part) {
  if (trigger_->request.bit) trigger_->level = read(*trigger_->request.bit) != 0;
  if (trigger_->request.condition) trigger_->request.condition->Comes(engine, part);
}

void Chart::Record(uint64_t period, uint64_t time_ms, const sim::ReadWatched& read, sim::Engine& engine,
                   sim::Clock::Part part) {
  ChartSample sample{.period = period, .time_ms = time_ms, .values = {}};
  for (const sim::Watched& watched : watched_) sample.values.push_back(read(watched));
  samples_.push_back(std::move(sample));
  if (samples_.size() > kMostBack) samples_.pop_front();
  if (trigger_) ObserveTrigger(samples_.back(), read, engine, part);
}

void Chart::Start(Trigger& trigger, uint64_t time_ms) {
  const TriggerRequest& request = trigger.request;
  trigger.state = TriggerState::kStarted;
  trigger.at_ms = time_ms;
  const uint64_t before = uint64_t{request.samples} * std::min(request.before_percent, 100U) / 100;
  const uint64_t begin = time_ms + request.delay_ms;
  trigger.due_ms = begin - std::min(begin, before * request.base_ms);
  // What lies before it has been recorded already.
  for (const ChartSample& sample : samples_) {
    if (sample.time_ms >= trigger.due_ms && sample.time_ms < time_ms && trigger.kept.size() < request.samples) {
      trigger.kept.push_back(sample);
      trigger.due_ms += ((sample.time_ms - trigger.due_ms) / request.base_ms + 1) * request.base_ms;
    }
  }
}

void Chart::ObserveTrigger(const ChartSample& sample, const sim::ReadWatched& read, sim::Engine& engine,
                           sim::Clock::Part part) {
  Trigger& trigger = *trigger_;
  TriggerRequest& request = trigger.request;
  if (trigger.state == TriggerState::kArmed) {
    bool comes = false;
    if (request.bit) {
      const bool level = read(*request.bit) != 0;
      const bool wanted = request.edge == TriggerEdge::kRising;
      comes = trigger.level && *trigger.level != level && level == wanted;
      trigger.level = level;
    } else if (request.condition) {
      comes = request.condition->Comes(engine, part);
    }
    if (!comes) return;
    Start(trigger, sample.time_ms);
  }
  if (trigger.state != TriggerState::kStarted) return;
  if (sample.time_ms >= trigger.due_ms && trigger.kept.size() < request.samples) {
    trigger.kept.push_back(sample);
    trigger.due_ms += ((sample.time_ms - trigger.due_ms) / request.base_ms + 1) * request.base_ms;
  }
  if (trigger.kept.size() >= request.samples) {
    trigger.state = TriggerState::kComplete;
    ++version_;
  }
}

}  // namespace plcxx::live
