// One executed part of a program, with all that decided what it did: what an explanation is made from.
//
// In: nothing. Out: the state before and after the part, its time, what the host answered meanwhile, and who had
// written what before. Not its job: executing (recorder.h), explaining (explain.h).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/last_writes.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::explanation {

enum class PartKind : uint8_t { kPeriod, kFast, kElapse };

/// The routine that is such a part; none: the program has no such part.
ir::RoutineId RoutineOf(const ir::Program& program, PartKind kind);

/// A call of the host, with what the host did.
struct RecordedCall {
  ir::HostFunctionId function;
  std::vector<uint64_t> arguments;
  sim::HostAnswer answer;
  /// By SpaceId: the memory after the call; empty: the host wrote none while it answered.
  std::vector<std::vector<uint8_t>> memory;
};

struct Frame {
  PartKind kind{};
  uint32_t now_ms = 0;
  sim::Simulator::Saved before, after;
  std::vector<RecordedCall> calls;  // in their order
  sim::LastWrites writes_before;
};

}  // namespace plcxx::explanation
