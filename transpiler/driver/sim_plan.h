// What `plcxx sim` was asked for, with its words resolved against one program.
//
// In: the texts of the command line. Out: places, values, times and statements, or what is wrong with the texts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/sim/trace.h"

namespace plcxx::driver {

/// The words of the command line.
struct SimWords {
  std::string duration;            // --for
  std::optional<uint32_t> cycles;  // --cycles
  std::vector<std::string> watch;  // --watch LOC,LOC
  std::vector<std::string> at;     // --at TIME:LOC=VALUE
  std::vector<std::string> force;  // --force LOC=VALUE
  std::string trigger;             // --trigger rising:LOC
  std::string delay, sampling;     // durations
  uint32_t samples = 0;
  std::vector<std::string> disconnect;  // --disconnect-lines
};

struct SimValue {
  uint64_t time_ms = 0;         // of --at
  dialects::Location location;  // not absent
  uint64_t value = 0;
  std::string text;     // for a text input
  std::string written;  // of --at, the whole
};

struct SimPlan {
  uint64_t periods = 0;  // 0: until `slow_cycles` have been completed
  uint32_t slow_cycles = 0;
  std::vector<sim::Watched> watched;
  std::vector<SimValue> at;  // by time
  std::vector<SimValue> forced;
  std::optional<sim::Graph::Options> graph;
  std::vector<ir::StatementId> disconnected;
};

/// A budget, so that no simulation hangs or fills the memory.
constexpr uint64_t kMostPeriods = 1'000'000;
constexpr size_t kMostWatched = 16;

/// The plan, or the first thing that is wrong.
std::variant<SimPlan, std::string> PlanSimulation(const SimWords& words, const compilation::Compilation& compilation);

/// "3s", "100ms", "2min" in ms; none for anything else.
std::optional<uint64_t> ParseDuration(std::string_view text);

}  // namespace plcxx::driver
