#include "transpiler/prove/machine/sets.h"

#include <algorithm>
#include <span>
#include <utility>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/op.h"
#include "transpiler/ir/zones.h"
#include "transpiler/prove/machine/transition.h"

namespace plcxx::prove::machine {
namespace {

constexpr uint64_t kAll = ~uint64_t{0};
constexpr ir::OpKind kAnds[] = {ir::OpKind::kBitAnd, ir::OpKind::kAnd8, ir::OpKind::kAnd16, ir::OpKind::kAnd32};
constexpr ir::OpKind kOrs[] = {ir::OpKind::kBitOr, ir::OpKind::kOr8, ir::OpKind::kOr16, ir::OpKind::kOr32};
constexpr ir::OpKind kXors[] = {ir::OpKind::kBitXor, ir::OpKind::kXor8, ir::OpKind::kXor16, ir::OpKind::kXor32};
constexpr ir::OpKind kNots[] = {ir::OpKind::kBitNot, ir::OpKind::kNot8, ir::OpKind::kNot16, ir::OpKind::kNot32};
constexpr ir::OpKind kSelects[] = {ir::OpKind::kSelect1, ir::OpKind::kSelect8, ir::OpKind::kSelect16,
                                   ir::OpKind::kSelect32};
bool IsOneOf(std::span<const ir::OpKind> ops, ir::OpKind op) { return std::ranges::find(ops, op) != ops.end(); }

constexpr int kMaxDepth = 16;  // of operations within the value

bool IsSameMemory(const ir::Place& one, const ir::Place& other) {
  return !one.is_field() && !other.is_field() && !one.indexed && !other.indexed && one.space == other.space &&
         one.offset == other.offset && one.bit == other.bit && one.type == other.type;
}

/// What a value that is stored in a place has to do with what the place had.
struct Stored {
  // Bits that it may have, and that it may lack, where the place has none.
  uint64_t ones = kAll, zeros = kAll;
  bool is_of_place = false;  // it is what the place had, with bits put in or taken out (`W |= 4`, `W &= ~4`)
};

/// A value of the place that was loaded earlier has no more bits than it had when its last setter was through.
Stored WhatIsStored(const ir::Program& program, const ir::Place& place, ir::InstId value, int depth = 0) {
  const ir::Inst& inst = program[value];
  if (depth > kMaxDepth) return {};
  const auto operand = [&](uint32_t id) { return WhatIsStored(program, place, ir::InstId(id), depth + 1); };
  if (ir::Info(inst.op).shape == ir::Shape::kConst)
    return {.ones = ir::ConstantValue(inst), .zeros = ~ir::ConstantValue(inst)};
  if (ir::Info(inst.op).shape == ir::Shape::kLoad) {
    return IsSameMemory(program.places[ir::PlaceId(inst.payload)], place) ? Stored{.ones = 0, .is_of_place = true}
                                                                          : Stored();
  }
  if (IsOneOf(kNots, inst.op)) {
    const Stored a = operand(inst.a);
    return {.ones = a.zeros, .zeros = a.ones, .is_of_place = a.is_of_place};
  }
  if (IsOneOf(kAnds, inst.op)) {
    const Stored a = operand(inst.a), b = operand(inst.b);
    return {.ones = a.ones & b.ones, .zeros = a.zeros | b.zeros, .is_of_place = a.is_of_place || b.is_of_place};
  }
  if (IsOneOf(kOrs, inst.op)) {
    const Stored a = operand(inst.a), b = operand(inst.b);
    return {.ones = a.ones | b.ones, .zeros = a.zeros & b.zeros, .is_of_place = a.is_of_place || b.is_of_place};
  }
  if (IsOneOf(kXors, inst.op)) {
    const Stored a = operand(inst.a), b = operand(inst.b);
    return {.ones = (a.ones & b.zeros) | (a.zeros & b.ones), .zeros = (a.ones & b.ones) | (a.zeros & b.zeros)};
  }
  if (IsOneOf(kSelects, inst.op)) {
    const Stored a = operand(inst.b), b = operand(inst.c);
    return {.ones = a.ones | b.ones, .zeros = a.zeros | b.zeros, .is_of_place = a.is_of_place && b.is_of_place};
  }
  return {};
}

/// A part of a word that stands anywhere in the space begins or ends a byte beside its end.
constexpr uint32_t kBesideEnd = 1;

/// From one end to the other, if not each byte: who indexes so says nothing of where it writes.
bool ReachesWholeSpace(const ir::Program& program, const ir::Place& place) {
  return !place.is_field() && place.indexed && place.low <= kBesideEnd &&
         place.high + kBesideEnd >= program.spaces[place.space].bytes;
}

class ScheduleWalk {
 public:
  explicit ScheduleWalk(const ir::Program& program) : program_(program), regions_(program.regions.size()) {}

  void Routine(ir::RoutineId id) {
    if (!id.valid()) return;
    const ir::Routine& routine = program_.routines[id];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region);
  }
  std::vector<bool> Take() { return std::move(regions_); }

 private:
  void Region(ir::RegionId id) {
    if (!id.valid() || regions_[id.index]) return;
    regions_[id.index] = true;
    for (const ir::InstId inst_id : program_.regions[id].insts) {
      const ir::Inst& inst = program_[inst_id];
      if (ir::Info(inst.op).effect == ir::Effect::kControl) {
        for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Region(owned);
      }
      if (ir::Info(inst.op).shape == ir::Shape::kCall) Routine(program_.calls[ir::CallId(inst.payload)].routine);
    }
  }

  const ir::Program& program_;
  std::vector<bool> regions_;
};

}  // namespace

std::vector<bool> ScheduledRegions(const ir::Program& program) {
  ScheduleWalk walk(program);
  const ir::Schedule& schedule = program.schedule;
  for (const ir::RoutineId id : {schedule.init, schedule.period, schedule.fast_only, schedule.elapse}) walk.Routine(id);
  return walk.Take();
}

std::vector<execute::CellId> CellsThatMayBeSet(const Version& version, const ir::Inst& inst, ir::PlaceId written) {
  const ir::Program& program = *version.program;
  const ir::Place& place = program.places[written];
  if (ir::Info(inst.op).shape != ir::Shape::kStore) return execute::TouchedCells(program, version.cells, place);
  const Stored stored = WhatIsStored(program, place, ir::InstId(inst.a));
  if (place.is_field() || place.indexed || !execute::IsInside(program, place))
    return stored.ones == 0 ? std::vector<execute::CellId>() : execute::TouchedCells(program, version.cells, place);
  const std::vector<execute::CellId> cells = execute::CellsOf(program, version.cells, place);
  if (cells.size() > 1 && stored.ones != 0 && !stored.is_of_place) return cells;
  std::vector<execute::CellId> set;
  for (size_t i = 0; i < cells.size(); ++i) {
    if ((stored.ones >> i & 1) != 0) set.push_back(cells[i]);
  }
  return set;
}

bool MayBeSetByOthers(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  if (cell.kind != execute::CellKind::kBit || DirectionOf(version, id) != ir::Direction::kInternal) return false;
  return !PowerOnBit(version.program->spaces[cell.space], cell.offset, cell.bit);
}

std::vector<bool> SetCells(const Version& version) {
  const ir::Program& program = *version.program;
  std::vector<bool> set(version.cells.count), stored(version.cells.count);
  const std::vector<bool> is_scheduled = ScheduledRegions(program);
  for (uint32_t i = 0; i < is_scheduled.size(); ++i) {
    if (!is_scheduled[i]) continue;
    for (const ir::InstId id : program.regions[ir::RegionId(i)].insts) {
      const ir::Inst& inst = program[id];
      const auto on_place = [&](ir::PlaceId written, ir::Access access) {
        const ir::Place& place = program.places[written];
        if (access == ir::Access::kRead || ReachesWholeSpace(program, place)) return;
        for (const execute::CellId cell : execute::TouchedCells(program, version.cells, place))
          stored[cell.index] = true;
        for (const execute::CellId cell : CellsThatMayBeSet(version, inst, written)) set[cell.index] = true;
      };
      ir::ForEachAccess(program, inst, on_place, [](ir::StateId) {});
    }
  }
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    if (stored[i] && !set[i]) set[i] = !MayBeSetByOthers(version, execute::CellId(i));
  }
  return set;
}

bool MayBeSetByHost(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  if (cell.kind != execute::CellKind::kBit) return false;
  const ir::Space& space = version.program->spaces[cell.space];
  return space.host_visible && !ir::IsConstant(space, cell.offset);
}

}  // namespace plcxx::prove::machine
