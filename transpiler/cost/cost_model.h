// The estimated cost of a program: what the compile report shows, budgets compare with, and slices are balanced by.
//
// In: structured IR and the price of each class of operations (prices.def). Out: times and sizes. Deterministic, and
// the same on every host: it never measures. The time is the longest path: of an If the dearer arm, of a loop its
// bound, of a call the routine that is called. What a host function does is not known and not counted.
// Not its job: measuring the object code (`plcxx build` does), wording the report.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::cost {

struct Cost {
  uint64_t time_ns = 0;     // longest path; saturates
  uint64_t code_bytes = 0;  // of all paths
};

/// One statement's own share, without the statements nested in it; an end of a block is a statement, too.
struct StatementCost {
  ir::StatementId statement;
  Cost own;     // one execution
  Cost nested;  // of the statements inside, on their longest path; zero for most
};

struct Estimate {
  Cost total;                             // prologue, body and epilogue
  std::vector<uint64_t> item_weights;     // time_ns of each of Items(program, body): what CutSlices takes
  std::vector<StatementCost> statements;  // in program order: for --cost-listing
  /// The time in µs, rounded up: the unit of the report.
  uint64_t time_us() const { return (total.time_ns + 999) / 1000; }
};

Estimate EstimateRoutine(const ir::Program& program, ir::RoutineId routine);

/// What one run of each routine takes, as far as somebody asked: by RoutineId.
using RoutineTimes = std::vector<std::optional<uint64_t>>;

/// The same for who asks of many routines: what they call is priced once for all of them. `known` is empty at first,
/// and good as long as the program is what it was.
Estimate EstimateRoutine(const ir::Program& program, ir::RoutineId routine, RoutineTimes& known);

constexpr uint8_t kMostSlices = 64;

/// max(1, ceil(slow_us / (slot_ms * 1000))), at most kMostSlices (nc110, section 4.2).
uint8_t SlicesFor(uint64_t slow_us, uint32_t slot_ms);

}  // namespace plcxx::cost
