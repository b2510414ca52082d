// Up to 16 watched locations over time, and a trigger that keeps a stretch of it.
//
// In: the values after each period. Out: the samples of the last kMostBack periods, and of the stretch around the
// trigger. Not its job: drawing, and what the values mean.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/live/condition.h"
#include "transpiler/sim/trace.h"

namespace plcxx::live {

inline constexpr size_t kMostWatched = 16;

struct ChartSample {
  uint64_t period = 0, time_ms = 0;
  std::vector<uint64_t> values;  // one for each watched location
};

enum class TriggerEdge : uint8_t { kRising, kFalling };
enum class TriggerState : uint8_t { kArmed, kStarted, kComplete };

/// Waits for an edge of a bit, or for a condition; then keeps `samples` samples, one every `base_ms`, of which
/// `before` lie before it, after a delay of `delay_ms`.
struct TriggerRequest {
  std::optional<sim::Watched> bit;
  TriggerEdge edge = TriggerEdge::kRising;
  std::optional<Condition> condition;
  std::string text;  // as it was asked for
  uint32_t base_ms = 10, delay_ms = 0;
  uint32_t samples = 500;
  uint32_t before_percent = 20;
};

/// What an operator asks for, unchecked.
struct TriggerWish {
  std::string edge;  // "rising", "falling", "condition"
  std::string text;  // the bit, or the condition
  uint32_t base_ms = 0, delay_ms = 0, samples = 0, before_percent = 0;
};

class Chart {
 public:
  /// False: there are kMostWatched already.
  bool Watch(sim::Watched watched);
  void Unwatch(size_t number);
  const std::vector<sim::Watched>& watched() const { return watched_; }

  /// After each period.
  void Record(uint64_t period, uint64_t time_ms, const sim::ReadWatched& read, sim::Engine& engine,
              sim::Clock::Part part);
  /// The machine went back to the beginning of this period.
  void GoBack(uint64_t period);
  void Clear();

  const std::deque<ChartSample>& samples() const { return samples_; }
  /// Changes with each change that is not one more sample.
  uint32_t version() const { return version_; }

  void Arm(TriggerRequest request);
  /// What is so when it is armed is no edge.
  void Prime(const sim::ReadWatched& read, sim::Engine& engine, sim::Clock::Part part);
  void Disarm() { trigger_.reset(); }
  struct Trigger {
    TriggerRequest request;
    TriggerState state = TriggerState::kArmed;
    uint64_t at_ms = 0;             // when it came
    std::vector<ChartSample> kept;  // ascending
    std::optional<bool> level;      // of the bit
    uint64_t due_ms = 0;            // of the next sample
  };
  const std::optional<Trigger>& trigger() const { return trigger_; }

 private:
  void ObserveTrigger(const ChartSample& sample, const sim::ReadWatched& read, sim::Engine& engine,
                      sim::Clock::Part part);
  void Start(Trigger& trigger, uint64_t time_ms);

  std::vector<sim::Watched> watched_;
  std::deque<ChartSample> samples_;
  std::optional<Trigger> trigger_;
  uint32_t version_ = 0;
};

}  // namespace plcxx::live
