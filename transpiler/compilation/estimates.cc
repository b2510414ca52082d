#include "transpiler/compilation/estimates.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "transpiler/cost/cost_model.h"
#include "transpiler/passes/cut_slices.h"

namespace plcxx::compilation {
namespace {

constexpr uint64_t kNsPerMs = 1'000'000;
constexpr uint64_t kBytesPerKb = 1024;

bool IsPartition(ir::RoutineKind kind) {
  return kind == ir::RoutineKind::kFast || kind == ir::RoutineKind::kSlow || kind == ir::RoutineKind::kInterrupt;
}

uint64_t RoundedUp(uint64_t value, uint64_t unit) { return value / unit + (value % unit != 0 ? 1 : 0); }

/// The limit among the options; none when it is not given or 0.
std::optional<uint64_t> LimitOf(const Compilation& compilation, std::string_view key) {
  const auto option = compilation.options.find(std::string(key));
  if (option == compilation.options.end()) return std::nullopt;
  uint64_t limit = 0;
  const std::string& text = option->second;
  std::from_chars(text.data(), text.data() + text.size(), limit);  // check_options has seen to its form
  return limit == 0 ? std::nullopt : std::optional<uint64_t>(limit);
}

void CheckBudget(Compilation& compilation, dialects::Budget budget, std::string_view key, uint64_t needed) {
  const std::optional<uint64_t> limit = LimitOf(compilation, key);
  if (!limit || needed <= *limit || compilation.files.empty()) return;
  compilation.dialect->report_over_budget(budget, needed, *limit, compilation.files.front(), *compilation.sources,
                                          compilation.diagnostics);
}

}  // namespace

void TakeCosts(Compilation& compilation, const Compilation& shipped) {
  compilation.estimates = shipped.estimates;
  for (uint32_t i = 0; i < compilation.program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    compilation.program.routines[id].slices = shipped.program.routines[id].slices;
  }
}

void EstimateCosts(Compilation& compilation) {
  ir::Program& program = compilation.program;
  Estimates& estimates = compilation.estimates;
  cost::RoutineTimes known_times;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    if (!IsPartition(program.routines[id].kind)) continue;
    const cost::Estimate estimate = cost::EstimateRoutine(program, id, known_times);
    ir::Routine& routine = program.routines[id];
    estimates.partitions.push_back({routine.name, routine.kind, estimate.total.time_ns, estimate.total.code_bytes});
    if (routine.kind != ir::RoutineKind::kSlow) continue;
    if (routine.sliced && program.schedule.slices_by_cost) {
      routine.slices = cost::SlicesFor(estimate.time_us(), program.schedule.slot_ms);
    }
    estimates.slices = routine.slices;
    // Elsewhere the program decides when its slow part comes (hnc, prostep), or counts periods for it (host50).
    const bool is_period = routine.sliced || program.schedule.fast_ms != 0;
    estimates.slow_period_ms = is_period ? routine.slices * program.schedule.period_ms : 0;
  }
}

namespace {

void CheckPeriod(Compilation& compilation, std::string_view what, uint64_t needed_ns, uint64_t period_ms) {
  if (period_ms == 0 || needed_ns <= period_ms * kNsPerMs) return;
  constexpr uint64_t kUsPerMs = kNsPerMs / kNsPerUs;
  compilation.diagnostics.Report({}, diag::PeriodExceeded, what,
                                 static_cast<diag::Number>(RoundedUp(needed_ns, kNsPerUs)),
                                 static_cast<diag::Number>(period_ms * kUsPerMs));
}

/// In a period run the fast part and a slice of the slow one, or each of them in a period of its own.
void CheckPeriods(Compilation& compilation, uint64_t fast_ns, uint64_t slow_ns) {
  const ir::Schedule& schedule = compilation.program.schedule;
  const uint64_t slice_ns = slow_ns / std::max(1u, compilation.estimates.slices);
  if (schedule.fast_done.valid()) {  // each part comes at times of its own, which the program sets
    CheckPeriod(compilation, "the fast part", fast_ns, schedule.fast_every_ms);
    CheckPeriod(compilation, "the slow part", slow_ns, schedule.slow_every_ms);
  } else if (schedule.fast_ms != 0) {
    CheckPeriod(compilation, "the fast part", fast_ns, schedule.fast_ms);
    CheckPeriod(compilation, "the slow part", slow_ns, schedule.period_ms);
  } else if (slow_ns == 0) {
    CheckPeriod(compilation, "the fast part", fast_ns, schedule.period_ms);
  } else if (fast_ns == 0) {
    CheckPeriod(compilation, "the slow part", slice_ns, schedule.period_ms);
  } else {
    CheckPeriod(compilation, "the fast part with a slice of the slow one", fast_ns + slice_ns, schedule.period_ms);
  }
}

}  // namespace

void CheckBudgets(Compilation& compilation) {
  uint64_t fast_ns = 0, slow_ns = 0, bytes = 0;
  for (const PartitionEstimate& partition : compilation.estimates.partitions) {
    if (partition.kind == ir::RoutineKind::kFast) fast_ns += partition.time_ns;
    if (partition.kind == ir::RoutineKind::kSlow) slow_ns += partition.time_ns;
    bytes += partition.code_bytes;
  }
  CheckPeriods(compilation, fast_ns, slow_ns);
  CheckBudget(compilation, dialects::Budget::kFastUs, "fast-budget-us", RoundedUp(fast_ns, kNsPerUs));
  CheckBudget(compilation, dialects::Budget::kSlowMs, "slow-budget-ms", RoundedUp(slow_ns, kNsPerMs));
  CheckBudget(compilation, dialects::Budget::kCodeKb, "code-budget-kb", RoundedUp(bytes, kBytesPerKb));
}

void CutSlices(Compilation& compilation) {
  ir::Program& program = compilation.program;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    if (!program.routines[id].sliced || program.routines[id].slices <= 1) continue;
    passes::CutSlices(program, id, cost::EstimateRoutine(program, id).item_weights);
  }
}

}  // namespace plcxx::compilation
