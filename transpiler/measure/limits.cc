#include "transpiler/measure/limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string>

#include "transpiler/cost/cost_model.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/slices.h"
#include "transpiler/ir/uses.h"
#include "transpiler/measure/figures.h"
#include "transpiler/measure/slices.h"

namespace plcxx::measure {
namespace {

constexpr size_t kStatementsNamed = 3;

using Price = uint64_t cost::Cost::*;

/// The statements that the cost model prices highest, dearest first: by time, or by code. Those of `regions` (by
/// RegionId) alone.
std::vector<ir::StatementId> Costliest(const ir::Program& program, const std::vector<bool>& regions, Price price) {
  std::set<uint32_t> inside;
  for (uint32_t i = 0; i < regions.size(); ++i) {
    if (!regions[i]) continue;
    for (const ir::InstId id : program.regions[ir::RegionId(i)].insts) {
      if (program[id].op == ir::OpKind::kStatement) inside.insert(program[id].payload);
    }
  }
  std::vector<cost::StatementCost> all;
  cost::RoutineTimes known_times;
  for (uint32_t i = 0; i < program.routines.size() && !inside.empty(); ++i) {
    for (const cost::StatementCost& row : cost::EstimateRoutine(program, ir::RoutineId(i), known_times).statements) {
      if (inside.contains(row.statement.index)) all.push_back(row);
    }
  }
  std::ranges::stable_sort(all, std::greater(), [price](const cost::StatementCost& row) { return row.own.*price; });
  std::vector<ir::StatementId> first;
  for (size_t i = 0; i < std::min(all.size(), kStatementsNamed); ++i) first.push_back(all[i].statement);
  return first;
}

ir::StatementId FirstStatement(const ir::Program& program, ir::RegionId region, uint32_t begin, uint32_t end) {
  ir::StatementId first;
  const auto take = [&](ir::InstId id) {
    if (!first.valid() && program[id].op == ir::OpKind::kStatement) first = ir::StatementId(program[id].payload);
  };
  for (uint32_t i = begin; i < end && !first.valid(); ++i) {
    const ir::InstId id = program.regions[region].insts[i];
    take(id);
    if (!ir::OwnsRegions(program[id])) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program, program[id])) ir::ForEachInst(program, owned, take);
  }
  return first;
}

/// Where the functions begin that take most of the deepest stack: the largest frame first.
std::vector<ir::StatementId> LargestFrames(const emit::Emittable& emittable, std::vector<compile::StackFrame> frames) {
  const ir::Program& program = *emittable.program;
  std::ranges::stable_sort(frames, std::greater(), &compile::StackFrame::bytes);
  std::vector<ir::StatementId> statements;
  for (const compile::StackFrame& frame : frames) {
    const std::string prefix = emittable.namespace_name + "::";
    const std::string name = frame.function.starts_with(prefix) ? frame.function.substr(prefix.size()) : "";
    ir::StatementId first;
    const auto chunk = std::ranges::find(emittable.chunks, name, &emit::Chunk::name);
    const auto routine = std::ranges::find(emittable.routine_names, name);
    if (chunk != emittable.chunks.end()) {
      first = FirstStatement(program, chunk->region, chunk->begin, chunk->end);
    } else if (routine != emittable.routine_names.end()) {
      const auto index = static_cast<uint32_t>(routine - emittable.routine_names.begin());
      const ir::RegionId body = program.routines[ir::RoutineId(index)].body;
      const auto size = static_cast<uint32_t>(program.regions[body].insts.size());
      first = FirstStatement(program, body, 0, size);
    }
    if (first.valid() && statements.size() < kStatementsNamed) statements.push_back(first);
  }
  return statements;
}

class LimitCheck {
 public:
  LimitCheck(const BuildFigures& figures, uint64_t clock_hz, const emit::Emittable& emittable,
             compilation::Compilation& compilation)
      : figures_(figures),
        clock_hz_(clock_hz),
        emittable_(emittable),
        program_(compilation.program),
        diagnostics_(compilation.diagnostics) {}

  void Time(ir::RoutineKind kind, std::optional<uint64_t> limit) {
    if (!limit) return;
    // A limit that was not shown to hold is not kept.
    diagnostics_.MakeError(diag::NotMeasured.row);
    for (const PartitionFigures& partition : figures_.partitions) {
      const ir::Routine& routine = program_.routines[partition.routine];
      if (!IsMeant(routine, kind)) continue;
      Doubt(partition);
      if (partition.slices.empty()) Time(partition.name, partition.figures, routine.body, *limit);
      for (const SliceFigures& slice : partition.slices)
        Time(partition.name + ", slice " + std::to_string(slice.slice), slice.figures, slice.piece, *limit);
    }
  }

  void Stack(std::optional<uint64_t> limit) {
    if (!limit) return;
    for (const PartitionFigures& partition : figures_.partitions) {
      Doubt(partition);
      const compile::Figures& own = partition.figures;
      if (own.stack_bytes <= *limit) continue;
      const auto statements = LargestFrames(emittable_, own.deepest);
      Name(diagnostics_.Report(Range(statements), diag::OverBytes, "the stack of partition '" + partition.name + "'",
                               own.stack_bytes, *limit),
           statements);
    }
  }

  void Code(std::optional<uint64_t> limit) {
    if (!limit || figures_.code_bytes <= *limit) return;
    const auto statements =
        Costliest(program_, std::vector<bool>(program_.regions.size(), true), &cost::Cost::code_bytes);
    Name(diagnostics_.Report(Range(statements), diag::OverBytes, "the code", figures_.code_bytes, *limit), statements);
  }

 private:
  /// Where a routine takes a slice, it is the slow part, with all that it calls.
  bool IsMeant(const ir::Routine& routine, ir::RoutineKind kind) const {
    const bool sliced = std::ranges::any_of(figures_.partitions, [this](const PartitionFigures& other) {
      return ir::TakesSlice(program_.routines[other.routine]);
    });
    return kind == ir::RoutineKind::kSlow && sliced ? ir::TakesSlice(routine) : routine.kind == kind;
  }
  void Time(const std::string& name, const compile::Figures& own, ir::RegionId from, uint64_t limit) {
    const uint64_t us =
        (Nanoseconds(own.longest.cycles, clock_hz_) + compilation::kNsPerUs - 1) / compilation::kNsPerUs;
    if (us <= limit) return;
    const auto statements = Costliest(program_, RegionsFrom(program_, from), &cost::Cost::time_ns);
    Name(diagnostics_.Report(Range(statements), diag::OverTime, name, us, limit), statements);
  }
  source::Range Range(const std::vector<ir::StatementId>& statements) const {
    return statements.empty() ? source::Range() : program_.statements[statements.front()].range;
  }
  void Name(diag::Diagnostic& reported, const std::vector<ir::StatementId>& statements) const {
    for (size_t i = 1; i < statements.size(); ++i) {
      reported.notes.push_back({program_.statements[statements[i]].range, "costly, too"});
    }
  }
  void Doubt(const PartitionFigures& partition) {
    for (const std::string& missing : partition.figures.not_whole) {
      diagnostics_.Report({}, diag::NotMeasured, partition.name, missing);
    }
  }

  const BuildFigures& figures_;
  uint64_t clock_hz_;
  const emit::Emittable& emittable_;
  const ir::Program& program_;
  diag::Engine& diagnostics_;
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

void CheckLimits(const BuildFigures& figures, const BuildLimits& limits, uint64_t clock_hz,
                 const emit::Emittable& emittable, compilation::Compilation& compilation) {
  LimitCheck check(figures, clock_hz, emittable, compilation);
  check.Time(ir::RoutineKind::kFast, limits.fast_us);
  check.Time(ir::RoutineKind::kSlow, limits.slow_us);
  check.Stack(limits.stack_bytes);
  check.Code(limits.code_bytes);
}

}  // namespace plcxx::measure
