// The values of chosen places over time, and the two forms in which people look at them: a waveform and a table.
//
// In: places of a program and an engine that executes it, or whoever else can read them. Out: samples; the text of a
// VCD file (value change dump, IEEE 1364) or of a table. The same samples give the same bytes: no date, no version. Not
// its job: when to sample (the caller's, or a Graph's).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::sim {

struct Watched {
  std::string name;   // as the user names it: "U4A8"
  std::string scope;  // what it belongs to, for the waveform's tree: "A", "on_delay_timer"
  ir::Place place;
  std::optional<uint32_t> cell;  // no memory: a number that means something to the reader; `place` has a type only
  Sign sign = Sign::kNone;
  std::vector<ir::Place> bits;  // not empty: the bits of a number that is a part of `place`, the lowest first
};

/// Gives the value of what is watched.
using ReadWatched = std::function<uint64_t(const Watched& watched)>;
/// What is in memory, read through an engine.
ReadWatched ReadsFrom(Engine& engine);

/// With the scope that the program suggests: the space's name, or the kind of the instance.
Watched Watch(const ir::Program& program, std::string name, const ir::Place& place);

struct Sample {
  uint64_t time_ms = 0;
  std::vector<uint64_t> values;  // one for each watched place
  bool operator==(const Sample&) const = default;
};

class Trace {
 public:
  explicit Trace(std::vector<Watched> watched) : watched_(std::move(watched)) {}

  const std::vector<Watched>& watched() const { return watched_; }
  const std::vector<Sample>& samples() const { return samples_; }

  /// Times ascend; a second sample at one time replaces the first.
  void Record(uint64_t time_ms, const ReadWatched& read);

 private:
  std::vector<Watched> watched_;
  std::vector<Sample> samples_;
};

/// A name as a VCD file can have it: there it ends at white space, and a bracket would be the range of a vector.
std::string VcdName(std::string_view name);
/// The text of a VCD file; `program` names its outermost scope.
std::string WriteVcd(const Trace& trace, std::string_view program);
/// One line for each sample: the time and the values in digits.
std::string WriteTable(const Trace& trace);

enum class Edge : uint8_t { kRising, kFalling };

/// A trace that an edge of a signal starts: the first sample `delay_ms` after the edge, then one every `sampling_ms`.
/// Periods are what a simulation can see, so a sample that is due between two of them is taken at the second.
class Graph {
 public:
  struct Options {
    Watched trigger;  // a bit
    Edge edge = Edge::kRising;
    uint32_t sampling_ms = 1;
    uint32_t delay_ms = 0;
    uint32_t samples = 0;  // complete after so many; 0: never
  };
  enum class Phase : uint8_t { kArmed, kStarted, kComplete };

  Graph(std::vector<Watched> watched, Options options) : trace_(std::move(watched)), options_(std::move(options)) {}

  /// After each period. What the trigger is at the first call is no edge.
  void Observe(uint64_t time_ms, const ReadWatched& read);

  Phase phase() const { return phase_; }
  const Trace& trace() const { return trace_; }

 private:
  enum class Level : uint8_t { kUnknown, kLow, kHigh };

  Trace trace_;
  Options options_;
  Level level_ = Level::kUnknown;
  Phase phase_ = Phase::kArmed;
  uint64_t due_ms_ = 0;
};

}  // namespace plcxx::sim
