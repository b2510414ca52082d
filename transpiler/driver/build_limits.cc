#include "transpiler/driver/build_limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "transpiler/cost/cost_model.h"

namespace plcxx::driver {
namespace {

constexpr uint64_t kNsPerUs = 1000;
constexpr size_t kStatementsNamed = 3;

/// The statements that the cost model prices highest, dearest first: by time, or by code.
std::vector<cost::StatementCost> Costliest(const ir::Program& program, const std::vector<ir::RoutineId>& routines,
                                           uint64_t cost::Cost::* price) {
  std::vector<cost::StatementCost> all;
  for (const ir::RoutineId routine : routines) {
    const std::vector<cost::StatementCost> own = cost::EstimateRoutine(program, routine).statements;
    all.insert(all.end(), own.begin(), own.end());
  }
  std::ranges::stable_sort(all, std::greater(), [price](const cost::StatementCost& cost) { return cost.own.*price; });
  if (all.size() > kStatementsNamed) all.resize(kStatementsNamed);
  return all;
}

class LimitCheck {
 public:
  LimitCheck(const BuildFigures& figures, uint64_t clock_hz, Compilation& compilation)
      : figures_(figures), clock_hz_(clock_hz), compilation_(compilation) {}

  void Time(ir::RoutineKind kind, std::optional<uint64_t> limit) {
    if (!limit) return;
    // A limit that was not shown to hold is not kept.
    compilation_.diagnostics.MakeError(diag::NotMeasured.row);
    for (const PartitionFigures& partition : figures_.partitions) {
      if (compilation_.program.routines[partition.routine].kind != kind) continue;
      Doubt(partition);
      const uint64_t us = (Nanoseconds(partition.figures.longest.cycles, clock_hz_) + kNsPerUs - 1) / kNsPerUs;
      if (us <= *limit) continue;
      const auto statements = Costliest(compilation_.program, {partition.routine}, &cost::Cost::time_ns);
      Name(compilation_.diagnostics.Report(Range(statements), diag::OverTime, partition.name, us, *limit), statements);
    }
  }

  void Stack(std::optional<uint64_t> limit) {
    if (!limit) return;
    for (const PartitionFigures& partition : figures_.partitions) {
      Doubt(partition);
      if (partition.figures.stack_bytes <= *limit) continue;
      compilation_.diagnostics.Report({}, diag::OverBytes, "the stack of partition '" + partition.name + "'",
                                      partition.figures.stack_bytes, *limit);
    }
  }

  void Code(std::optional<uint64_t> limit) {
    if (!limit || figures_.code_bytes <= *limit) return;
    std::vector<ir::RoutineId> routines;
    for (const PartitionFigures& partition : figures_.partitions) routines.push_back(partition.routine);
    const auto statements = Costliest(compilation_.program, routines, &cost::Cost::code_bytes);
    Name(compilation_.diagnostics.Report(Range(statements), diag::OverBytes, "the code", figures_.code_bytes, *limit),
         statements);
  }

 private:
  source::Range Range(const std::vector<cost::StatementCost>& statements) const {
    return statements.empty() ? source::Range() : compilation_.program.statements[statements.front().statement].range;
  }
  void Name(diag::Diagnostic& reported, const std::vector<cost::StatementCost>& statements) const {
    for (size_t i = 1; i < statements.size(); ++i) {
      reported.notes.push_back({compilation_.program.statements[statements[i].statement].range, "costly, too"});
    }
  }
  void Doubt(const PartitionFigures& partition) {
    for (const std::string& missing : partition.figures.not_whole) {
      compilation_.diagnostics.Report({}, diag::NotMeasured, partition.name, missing);
    }
  }

  const BuildFigures& figures_;
  uint64_t clock_hz_;
  Compilation& compilation_;
};

}  // namespace

std::optional<uint64_t> ParseClock(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  std::string_view unit = text.substr(static_cast<size_t>(end - text.data()));
  if (unit.starts_with(' ')) unit.remove_prefix(1);
  struct Unit {
    std::string_view name;
    double hz;
  };
  constexpr Unit kUnits[] = {{"", 1}, {"Hz", 1}, {"kHz", 1e3}, {"MHz", 1e6}, {"GHz", 1e9}};
  const auto* known = std::ranges::find(kUnits, unit, &Unit::name);
  if (known == std::end(kUnits)) return std::nullopt;
  const double hz = number * known->hz;
  constexpr double kMostHz = 1e12;
  if (!(hz >= 1 && hz <= kMostHz)) return std::nullopt;
  return static_cast<uint64_t>(std::llround(hz));
}

void CheckLimits(const BuildFigures& figures, const BuildLimits& limits, uint64_t clock_hz, Compilation& compilation) {
  LimitCheck check(figures, clock_hz, compilation);
  check.Time(ir::RoutineKind::kFast, limits.fast_us);
  check.Time(ir::RoutineKind::kSlow, limits.slow_us);
  check.Stack(limits.stack_bytes);
  check.Code(limits.code_bytes);
}

}  // namespace plcxx::driver
