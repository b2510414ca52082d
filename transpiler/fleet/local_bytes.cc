#include "transpiler/fleet/local_bytes.h"

#include <algorithm>
#include <iterator>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/sim/place_access.h"

namespace plcxx::fleet {
namespace {

void AddPlace(const ir::Program& program, ir::PlaceId id, std::set<LocalByte>& bytes) {
  const ir::Place& place = program.places[id];
  if (place.is_field() || !place.space.valid()) return;
  const ir::Space& space = program.spaces[place.space];
  if (space.lifetime != ir::Lifetime::kRoutine || space.own) return;
  const sim::PlaceAccess access = sim::AccessTo(program, place);
  if (access.kind == sim::AccessKind::kAbsent) return;
  const uint32_t begin = access.indexed ? access.low : access.offset;
  const uint32_t end = access.indexed ? access.high : access.offset + access.bytes;
  for (uint32_t at = begin; at < end; ++at) bytes.emplace(access.owner, at);
}

/// Adds to each routine what those have to which an edge leads, until nothing changes.
void Close(const std::vector<std::set<uint32_t>>& edges, std::vector<std::set<LocalByte>>& bytes) {
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < edges.size(); ++i) {
      const size_t before = bytes[i].size();
      for (const uint32_t other : edges[i]) bytes[i].insert(bytes[other].begin(), bytes[other].end());
      changed = changed || bytes[i].size() != before;
    }
  }
}

}  // namespace

LocalBytes::LocalBytes(const ir::Program& program) : from_(program.routines.size()) {
  std::vector<std::set<uint32_t>> callees(program.routines.size()), callers(program.routines.size()),
      subroutines(program.routines.size());
  for (uint32_t r = 0; r < program.routines.size(); ++r) {
    const ir::Routine& routine = program.routines[ir::RoutineId(r)];
    for (const ir::PlaceId place : routine.parameter_places) AddPlace(program, place, from_[r]);
    if (routine.result_place.valid()) AddPlace(program, routine.result_place, from_[r]);
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program, region, [&](ir::InstId id) {
        const ir::Inst& inst = program[id];
        ir::ForEachAccess(
            program, inst, [&](ir::PlaceId place, ir::Access) { AddPlace(program, place, from_[r]); },
            [](ir::StateId) {});
        if (inst.op != ir::OpKind::kCall) return;
        const ir::RoutineId callee = program.calls[ir::CallId(inst.payload)].routine;
        callees[r].insert(callee.index);
        callers[callee.index].insert(r);
        if (program.routines[callee].kind == ir::RoutineKind::kSubroutine) subroutines[r].insert(callee.index);
      });
    }
  }
  waiting_ = from_;
  // A subroutine shares its caller's locals; a partition has its own, which are gone when it has ended.
  Close(subroutines, waiting_);
  Close(callers, waiting_);
  Close(callees, from_);
}

std::set<LocalByte> LocalBytes::Kept(ir::RoutineId caller, ir::RoutineId callee) const {
  std::set<LocalByte> kept;
  std::ranges::set_intersection(waiting_[caller.index], from_[callee.index], std::inserter(kept, kept.end()));
  return kept;
}

}  // namespace plcxx::fleet
