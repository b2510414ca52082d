#include "transpiler/sim/execution.h"

#include <utility>

#include "transpiler/ir/uses.h"
#include "transpiler/sim/changed_execution.h"
#include "transpiler/sim/core_operations.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {

using ir::Inst;
using ir::InstId;
using ir::RegionId;

namespace {

/// Counts what may repeat, and asks `stop` for each so many.
bool Stops(Execution& execution) {
  constexpr uint32_t kRegionsBetween = 4096;
  if (!execution.stopped && execution.stop && ++execution.regions == kRegionsBetween) {
    execution.regions = 0;
    if (execution.stop()) Stop(execution);
  }
  return execution.stopped;
}

/// All instructions of a region, where none is switched off and nobody is asked at statements.
template <bool kNotes>
Flow ExecuteAll(Execution& execution, const DecodedRegion& region) {
  const uint32_t count = region.end - region.begin;
  execution.executed += count;
  uint32_t done = count;
  Flow flow = Flow::kOn;
  const Decoded* const ready_end = execution.code.ready.data() + region.ready_end;
  for (const Decoded* inst = execution.code.ready.data() + region.ready_begin; inst != ready_end; ++inst) {
    flow = inst->execute(execution, *inst);
    if constexpr (kNotes) execution.NoteGiven(inst->id);
    if (flow == Flow::kOn) continue;
    done = inst->order + 1;
    break;
  }
  execution.executed -= count - done;
  if constexpr (kNotes) {
    for (const Decoded* inst = execution.code.decoded.data() + region.constants;
         inst != execution.code.decoded.data() + region.end; ++inst) {
      if (inst->order < done) execution.NoteGiven(inst->id);
    }
  }
  return flow;
}

/// Of a statement that is switched off: regions that jumps made, with the other statements in them.
Flow ExecuteOthers(Execution& execution, InstId id, const Inst& inst) {
  if (inst.op == ir::OpKind::kBlock) return core::Block(execution, id, inst);
  if (inst.op == ir::OpKind::kLoop) {
    const bool of_jumps = execution.program.loops[ir::LoopId(inst.payload)].kind == ir::LoopBound::kBudget;
    return of_jumps ? core::Loop(execution, id, inst) : Flow::kOn;
  }
  if (inst.op != ir::OpKind::kIf) return Flow::kOn;
  switch (static_cast<ir::IfOrigin>(inst.payload)) {
    case ir::IfOrigin::kSource:
      return Flow::kOn;
    case ir::IfOrigin::kJumps:
      return Execute(execution, RegionId(inst.c));
    case ir::IfOrigin::kStays:
      return Execute(execution, RegionId(inst.b));
  }
  PLCXX_UNREACHABLE();
}

Flow ExecuteWithCare(Execution& execution, RegionId region) {
  Flow flow = Flow::kOn;
  for (const InstId id : execution.program.regions[region].insts) {
    const Inst& inst = execution.program[id];
    if (execution.current.skipped && inst.op != ir::OpKind::kStatement) {
      // The statement is switched off; what a jump of it made may hold others.
      if (ir::OwnsRegions(inst)) flow = ExecuteOthers(execution, id, inst);
      if (flow == Flow::kLeaving) break;
      continue;
    }
    ++execution.executed;
    const Decoded& decoded = execution.code.Of(id);
    flow = execution.changes.looks_for_differences() ? ExecuteLookingForDifferences(execution, decoded)
                                                     : decoded.execute(execution, decoded);
    if (!execution.given.empty()) execution.NoteGiven(id.index);
    if (flow == Flow::kLeaving) break;
  }
  return flow;
}

}  // namespace

void SwitchedOff::Set(ir::StatementId statement, bool off) {
  PLCXX_CHECK(statement.index < off_.size());
  if (off_[statement.index] == off) return;
  off_[statement.index] = off;
  count_ += off ? 1 : size_t{0} - 1;
}

Execution::Execution(const ir::Program& structured)
    : program(structured), values(structured.insts.size() + Changes::kValues) {
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    const Inst& inst = program[InstId(i)];
    if (inst.op == ir::OpKind::kConst) values[i] = ir::ConstantValue(inst);
  }
  FindBases(*this);
}

void FindBases(Execution& execution) {
  execution.bases.clear();
  execution.bases.push_back(reinterpret_cast<const unsigned char*>(execution.values.data()));
  execution.bases.push_back(execution.memory.instances().bytes());
  for (const ForcedBytes& space : execution.memory.spaces()) execution.bases.push_back(space.bytes().data());
}

void Stop(Execution& execution) {
  execution.stopped = true;
  execution.leaving = InstId();
}

void RunPartition(Execution& execution, ir::RoutineId routine) {
  if (!routine.valid()) return;
  execution.locals.Begin(execution.memory, execution.code.locals[routine.index]);
  Run(execution, routine);
}

void Run(Execution& execution, ir::RoutineId id) {
  if (!id.valid()) return;
  const ir::Routine& routine = execution.program.routines[id];
  // A switched-off head in the caller says nothing about the conditions of the called routine.
  const CurrentStatement caller = std::exchange(execution.current, {.statement = execution.current.statement});
  for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    const Flow flow = Execute(execution, region);
    if (execution.stopped) break;
    PLCXX_CHECK(flow == Flow::kOn);
  }
  execution.current = caller;
}

Flow Execute(Execution& execution, RegionId region) {
  if (!region.valid()) return Flow::kOn;
  if (Stops(execution)) return Flow::kLeaving;
  const CurrentStatement outer = execution.current;
  const Flow flow = IsCareful(execution)                   ? ExecuteWithCare(execution, region)
                    : region == execution.changes.region() ? ExecuteChangedRegion(execution, execution.code.Of(region))
                    : execution.given.empty()              ? ExecuteAll<false>(execution, execution.code.Of(region))
                                                           : ExecuteAll<true>(execution, execution.code.Of(region));
  execution.current = outer;
  return flow;
}

LastWrite WriteBy(const Execution& execution, Writer writer) {
  const uint64_t now = execution.time.whole_ms;
  return {.writer = writer,
          .statement = writer == Writer::kProgram ? execution.current.statement : ir::StatementId(),
          .first_ms = now,
          .last_ms = now};
}

void Assign(Execution& execution, const PlaceAccess& access, uint64_t index, uint64_t value) {
  execution.memory.Set(access, index, value);
  if (!execution.recorder.is_on()) return;
  execution.recorder.Note(execution.memory, access, index, WriteBy(execution, Writer::kProgram));
}

void Stepped(Execution& execution, uint32_t instance) {
  execution.memory.instances().Reforce(instance);
  if (!execution.recorder.is_on()) return;
  execution.recorder.NoteFields(execution.memory, instance, WriteBy(execution, Writer::kProgram));
}

}  // namespace plcxx::sim
