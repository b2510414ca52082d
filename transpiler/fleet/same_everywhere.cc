#include "transpiler/fleet/same_everywhere.h"

#include <algorithm>

#include "transpiler/ir/builder.h"
#include "transpiler/sim/place_access.h"

namespace plcxx::fleet {
namespace {

constexpr uint64_t kLongestPreset = 1u << 30;  // longer ones are rare, and their sums would not fit

}  // namespace

bool IsWhole(ir::Type type) { return type != ir::Type::kF32 && type != ir::Type::kF64 && type != ir::Type::kNone; }

SameEverywhere::SameEverywhere(const ir::Program& program)
    : program_(program),
      values_(program.insts.size(), true),
      diverging_routines_(program.routines.size(), false),
      clocks_(program.states.size(), false) {
  FindCandidates();
  const LocalBytes locals(program);
  locals_ = &locals;
  // Everything is the same until something shows that it is not: what is left is the same by induction over the steps.
  do {
    changed_ = false;
    for (uint32_t r = 0; r < program.routines.size(); ++r) {
      const ir::Routine& routine = program.routines[ir::RoutineId(r)];
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue})
        WalkRegion(region, diverging_routines_[r]);
    }
    for (uint32_t p = 0; p < program.places.size(); ++p) {
      if (!Place(ir::PlaceId(p))) Differs(ir::PlaceId(p));
    }
  } while (changed_);
  locals_ = nullptr;
  FindClocks();
}

/// The host writes what it sees for each machine, and retentive memory comes from a store for each.
void SameEverywhere::FindCandidates() {
  for (const ir::Space& space : program_.spaces)
    bytes_.emplace_back(space.bytes, !space.host_visible && space.lifetime != ir::Lifetime::kRetentive);
  for (const ir::Place& place : program_.places) {
    const sim::PlaceAccess access = sim::AccessTo(program_, place);
    if (!access.indexed || access.kind == sim::AccessKind::kField || access.kind == sim::AccessKind::kAbsent) continue;
    for (uint32_t at = access.low; at < access.high; ++at) bytes_[access.owner][at] = false;
  }
  for (const ir::Routine& routine : program_.routines) {
    if (routine.result_place.valid()) Differs(routine.result_place);
  }
}

bool SameEverywhere::Place(ir::PlaceId id) const {
  const ir::Place& place = program_.places[id];
  const sim::PlaceAccess access = sim::AccessTo(program_, place);
  if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField || access.indexed) return false;
  if (!IsWhole(place.type)) return false;
  for (uint32_t i = 0; i < access.bytes; ++i) {
    if (!bytes_[access.owner][access.offset + i]) return false;
  }
  return true;
}

void SameEverywhere::Differs(ir::PlaceId id) {
  const sim::PlaceAccess access = sim::AccessTo(program_, program_.places[id]);
  if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField) return;
  const uint32_t begin = access.indexed ? access.low : access.offset;
  const uint32_t end = access.indexed ? access.high : access.offset + access.bytes;
  for (uint32_t at = begin; at < end; ++at) {
    changed_ = changed_ || bytes_[access.owner][at];
    bytes_[access.owner][at] = false;
  }
}

bool SameEverywhere::ComputesSame(const ir::Inst& inst) const {
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kConst:
      return IsWhole(inst.type);
    case ir::Shape::kLoad:
      return Place(ir::PlaceId(inst.payload));
    case ir::Shape::kPure: {
      const std::vector<ir::ValueId> used = ir::UsedValues(program_, inst);
      return IsWhole(inst.type) && std::ranges::all_of(used, [&](ir::ValueId id) { return values_[id.index]; });
    }
    case ir::Shape::kHostCall:
      return program_.calls[ir::CallId(inst.payload)].host == program_.schedule.now;
    case ir::Shape::kStep:
    case ir::Shape::kStore:
    case ir::Shape::kText:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kCall:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return false;
  }
  return false;
}

void SameEverywhere::WalkRegion(ir::RegionId region, bool diverges) {
  if (!region.valid()) return;
  for (const ir::InstId id : program_.regions[region].insts) WalkInst(id, diverges);
}

void SameEverywhere::WalkInst(ir::InstId id, bool diverges) {
  const ir::Inst& inst = program_[id];
  const bool same = ComputesSame(inst);
  changed_ = changed_ || values_[id.index] != same;
  values_[id.index] = same;
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape == ir::Shape::kStore) {
    const bool stored_same = !diverges && values_[inst.a] && IsWhole(program_.places[ir::PlaceId(inst.payload)].type);
    if (!stored_same) Differs(ir::PlaceId(inst.payload));
    return;
  }
  if (shape == ir::Shape::kCall) {
    const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
    const ir::Routine& callee = program_.routines[call.routine];
    for (size_t i = 0; i < call.arguments.size() && i < callee.parameter_places.size(); ++i) {
      if (diverges || !values_[call.arguments[i].index]) Differs(callee.parameter_places[i]);
    }
    if (!diverges) return;
    changed_ = changed_ || !diverging_routines_[call.routine.index];
    diverging_routines_[call.routine.index] = true;
    for (const auto& [space, offset] : locals_->UsedFrom(call.routine)) {  // which become 0 in the lanes that call
      changed_ = changed_ || bytes_[space][offset];
      bytes_[space][offset] = false;
    }
    return;
  }
  // The second result of a host function, the rounds that a loop has left.
  ir::ForEachAccess(
      program_, inst,
      [&](ir::PlaceId place, ir::Access access) {
        if (access != ir::Access::kRead) Differs(place);
      },
      [](ir::StateId) {});
  if (ir::Info(inst.op).effect != ir::Effect::kControl) return;
  // Lanes leave loops and blocks one by one.
  const bool branches = shape == ir::Shape::kIf || shape == ir::Shape::kSwitch;
  const bool inside = diverges || !branches || !values_[inst.a];
  for (const ir::RegionId region : ir::OwnedRegions(program_, inst)) WalkRegion(region, inside);
}

void SameEverywhere::LookAtStep(const ir::Inst& inst, std::vector<const ir::Inst*>& steps) {
  const uint32_t state = inst.payload;
  const ir::StateKind kind = program_.states[ir::StateId(state)].kind;
  if (kind == ir::StateKind::kOnDelayTimer) {
    const ir::Inst& preset = program_[ir::ValueId(inst.b)];
    const bool is_short = preset.op == ir::OpKind::kConst && ir::ConstantValue(preset) <= kLongestPreset;
    if (inst.op == ir::OpKind::kOnDelay && (!is_short || !values_[inst.c])) clocks_[state] = false;
  } else if (kind == ir::StateKind::kUnitTimer) {
    if (!values_[inst.c] || (steps[state] != nullptr && steps[state]->op != inst.op)) clocks_[state] = false;
    steps[state] = &inst;
  }
}

void SameEverywhere::LookAtField(const ir::Place& place, ir::Access access) {
  const ir::StateKind kind = program_.states[place.state].kind;
  const bool allowed = kind == ir::StateKind::kOnDelayTimer
                           ? access == ir::Access::kRead || place.field == ir::FieldIndex(kind, "hold")
                           : access == ir::Access::kRead && place.field != ir::FieldIndex(kind, "value");
  if (!allowed) clocks_[place.state.index] = false;
}

void SameEverywhere::FindClocks() {
  for (uint32_t s = 0; s < program_.states.size(); ++s) {
    const ir::StateKind kind = program_.states[ir::StateId(s)].kind;
    clocks_[s] = kind == ir::StateKind::kOnDelayTimer || kind == ir::StateKind::kUnitTimer;
  }
  std::vector<const ir::Inst*> steps(program_.states.size(), nullptr);
  for (const ir::Routine& routine : program_.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program_, region, [&](ir::InstId id) {
        const ir::Inst& inst = program_[id];
        if (ir::Info(inst.op).shape == ir::Shape::kStep) LookAtStep(inst, steps);
        ir::ForEachAccess(
            program_, inst,
            [&](ir::PlaceId place, ir::Access access) {
              const ir::Place& named = program_.places[place];
              if (named.is_field() && clocks_[named.state.index]) LookAtField(named, access);
            },
            [](ir::StateId) {});
      });
    }
  }
}

}  // namespace plcxx::fleet
