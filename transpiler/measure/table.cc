// The figures of plcxx build as JSON and as a table.
#include <nlohmann/json.hpp>
#include <set>

#include "transpiler/compile/audit_rules.h"
#include "transpiler/measure/figures.h"
#include "transpiler/source/columns.h"
#include "transpiler/support/listed.h"

namespace plcxx::measure {
namespace {

constexpr uint64_t kNsPerSecond = 1'000'000'000;
constexpr uint64_t kHzPerMhz = 1'000'000;

std::string MicrosecondsText(uint64_t ns) {
  const std::string tenths = std::to_string((ns + compilation::kNsPerUs / 10 - 1) / (compilation::kNsPerUs / 10));
  return (tenths.size() == 1 ? "0" : tenths.substr(0, tenths.size() - 1)) + "." + tenths.back();
}

/// All that is called and has no figures, and all that is missing.
struct Exclusions {
  std::set<std::string> host, support, not_whole;
};

Exclusions ExclusionsOf(const BuildFigures& figures) {
  Exclusions all;
  for (const PartitionFigures& partition : figures.partitions) {
    for (const std::string& name : partition.figures.host) {
      (compile::UseOfSymbol(name) == compile::RoutineUse::kUnknown ? all.host : all.support).insert(name);
    }
    all.not_whole.insert(partition.figures.not_whole.begin(), partition.figures.not_whole.end());
  }
  return all;
}

/// "slow 262144, init 65536": why a longest path may be so much longer than the program looks.
std::string SharedRounds(const BuildFigures& figures) {
  std::string text;
  for (const PartitionFigures& partition : figures.partitions) {
    const uint64_t rounds = partition.figures.shared_rounds;
    if (rounds != 0) text += (text.empty() ? "" : ", ") + partition.name + " " + std::to_string(rounds);
  }
  return text;
}

/// "us" rounded up to tenths, where the clock is known.
std::string TableRow(const std::string& name, size_t width, const compile::Figures& own, const StateBytes& state,
                     uint64_t clock_hz) {
  std::string text = "  " + source::LeftAligned(name, width) +
                     source::RightAligned(std::to_string(own.longest.instructions), 16) +
                     source::RightAligned(std::to_string(own.longest.cycles), 10);
  if (clock_hz != 0) text += source::RightAligned(MicrosecondsText(Nanoseconds(own.longest.cycles, clock_hz)), 10);
  for (const uint64_t bytes :
       {own.stack_bytes, own.code_bytes, own.constant_bytes, state.retentive, state.volatile_bytes})
    text += source::RightAligned(std::to_string(bytes), 10);
  return text + "\n";
}

void AddFigures(nlohmann::ordered_json& row, const compile::Figures& own, const StateBytes& state, uint64_t clock_hz) {
  row["instructions"] = own.longest.instructions;
  row["cycles"] = own.longest.cycles;
  row["stack_bytes"] = own.stack_bytes;
  row["code_bytes"] = own.code_bytes;
  row["constant_bytes"] = own.constant_bytes;
  row["retentive_bytes"] = state.retentive;
  row["volatile_bytes"] = state.volatile_bytes;
  row["not_counted"] = own.host;
  row["not_whole"] = own.not_whole;
  if (own.shared_rounds != 0) row["shared_rounds"] = own.shared_rounds;
  if (clock_hz != 0) row["time_ns"] = Nanoseconds(own.longest.cycles, clock_hz);
}

std::string SliceName(const SliceFigures& slice) { return "  slice " + std::to_string(slice.slice); }

}  // namespace

uint64_t Nanoseconds(uint64_t cycles, uint64_t clock_hz) {
  constexpr uint64_t kMostCycles = ~uint64_t{0} / kNsPerSecond;
  if (cycles > kMostCycles) return cycles / clock_hz * kNsPerSecond;
  return (cycles * kNsPerSecond + clock_hz - 1) / clock_hz;
}

nlohmann::ordered_json BuildJson(const BuildFigures& figures, const BuildWay& way) {
  nlohmann::ordered_json build;
  build["target"] = way.target->name;
  build["compiler"] = way.toolchain->is_clang ? "clang" : "gcc";
  build["optimization"] = way.level;
  if (way.clock_hz != 0) build["clock_hz"] = way.clock_hz;
  build["timing"] = figures.timing;
  build["partitions"] = nlohmann::ordered_json::array();
  for (const PartitionFigures& partition : figures.partitions) {
    nlohmann::ordered_json row = {{"name", partition.name}};
    AddFigures(row, partition.figures, partition.state, way.clock_hz);
    for (const SliceFigures& slice : partition.slices) {
      nlohmann::ordered_json piece = {{"slice", slice.slice}};
      AddFigures(piece, slice.figures, slice.state, way.clock_hz);
      row["slices"].push_back(std::move(piece));
    }
    build["partitions"].push_back(std::move(row));
  }
  build["code_bytes"] = figures.code_bytes;
  build["constant_bytes"] = figures.constant_bytes;
  build["retentive_bytes"] = figures.retentive_bytes;
  build["volatile_bytes"] = figures.volatile_bytes;
  return build;
}

std::string BuildTable(const BuildFigures& figures, const BuildWay& way, const std::string& program) {
  const bool timed = way.clock_hz != 0;
  size_t width = 10;
  for (const PartitionFigures& partition : figures.partitions) {
    width = std::max(width, partition.name.size() + 1);
    for (const SliceFigures& slice : partition.slices) width = std::max(width, SliceName(slice).size() + 1);
  }
  std::string text = program + " for " + std::string(way.target->name) + ", " + way.toolchain->version + ", -O" +
                     way.level + "\n  " + source::LeftAligned("longest path", width + 4) + "instructions    cycles" +
                     (timed ? "        us" : "") + "     stack      code constants retentive  volatile\n";
  for (const PartitionFigures& partition : figures.partitions) {
    text += TableRow(partition.name, width, partition.figures, partition.state, way.clock_hz);
    for (const SliceFigures& slice : partition.slices)
      text += TableRow(SliceName(slice), width, slice.figures, slice.state, way.clock_hz);
  }
  text += "  code " + std::to_string(figures.code_bytes) + ", constants " + std::to_string(figures.constant_bytes) +
          ", retentive " + std::to_string(figures.retentive_bytes) + ", volatile " +
          std::to_string(figures.volatile_bytes) + " bytes\n";
  text += "  cycles: " + figures.timing;
  if (timed) text += "; " + std::to_string(way.clock_hz / kHzPerMhz) + " MHz";
  text += "\n";
  for (const PartitionFigures& partition : figures.partitions) {
    if (partition.slices_join)
      text += "  " + partition.name + ": jumps lead from slice to slice, each may take as long as its row says\n";
  }
  const Exclusions excluded = ExclusionsOf(figures);
  if (!excluded.host.empty()) text += "  not counted, host functions: " + support::CommaSeparated(excluded.host) + "\n";
  if (!excluded.support.empty())
    text += "  not counted, support routines: " + support::CommaSeparated(excluded.support) + "\n";
  const std::string shared = SharedRounds(figures);
  if (!shared.empty()) text += "  rounds that loops share, all of them counted: " + shared + "\n";
  for (const std::string& missing : excluded.not_whole) text += "  not whole: " + missing + "\n";
  return text;
}

}  // namespace plcxx::measure
