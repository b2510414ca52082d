#include "transpiler/prove/machine/inputs.h"

#include <algorithm>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"

namespace plcxx::prove::machine {
namespace {

/// What some routines, and all that they call, store at fixed addresses and into arrays. An index that may reach all of
/// a space may reach signals of the host there, and says nothing about them.
class Stores {
 public:
  explicit Stores(const Version& version)
      : version_(version), program_(*version.program), seen_(program_.routines.size()), stored_(version.cells.count) {}

  void Routine(ir::RoutineId id) {
    if (!id.valid() || seen_[id.index]) return;
    seen_[id.index] = true;
    const ir::Routine& routine = program_.routines[id];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region);
  }
  /// What those have seen is left out: another way to call the program's own parts is no signal of the host.
  void LeaveOut(const Stores& others) { seen_ = others.seen_; }
  const std::vector<bool>& stored() const { return stored_; }

 private:
  void Place(ir::PlaceId id) {
    const ir::Place& place = program_.places[id];
    if (place.is_field()) return;
    const bool is_array = place.indexed && (place.low > 0 || place.high < program_.spaces[place.space].bytes);
    if (!is_array && !execute::IsInside(program_, place)) return;
    for (const execute::CellId cell : execute::TouchedCells(program_, version_.cells, place))
      stored_[cell.index] = true;
  }

  void Region(ir::RegionId region) {
    if (!region.valid()) return;
    for (const ir::InstId id : program_.regions[region].insts) Inst(program_[id]);
  }

  void Inst(const ir::Inst& inst) {
    ir::ForEachAccess(
        program_, inst,
        [this](ir::PlaceId place, ir::Access access) {
          if (access == ir::Access::kWrite) Place(place);
        },
        [](ir::StateId) {});
    if (ir::Info(inst.op).effect == ir::Effect::kControl) {
      for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Region(owned);
    }
    if (ir::Info(inst.op).shape == ir::Shape::kCall) Routine(program_.calls[ir::CallId(inst.payload)].routine);
  }

  const Version& version_;
  const ir::Program& program_;
  std::vector<bool> seen_, stored_;
};

/// What the program's own parts store, and what other routines that the host may call do.
struct StoresOfBoth {
  explicit StoresOfBoth(const Version& version) : own(version), of_host(version) {
    const ir::Program& program = *version.program;
    const ir::Schedule& schedule = program.schedule;
    for (const ir::RoutineId id : {schedule.init, schedule.period, schedule.fast_only, schedule.elapse})
      own.Routine(id);
    of_host.LeaveOut(own);
    for (uint32_t i = 0; i < program.routines.size(); ++i) {
      const ir::RoutineId id(i);
      if (program.routines[id].kind == ir::RoutineKind::kSchedule) of_host.Routine(id);
    }
  }
  Stores own, of_host;
};

}  // namespace

bool IsInbox(const Version& version, execute::CellId id) {
  const ir::StateId inbox = version.program->text_inbox;
  if (!inbox.valid()) return false;
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kField && cell.state == inbox;
}

std::vector<bool> SetByHost(const Version& version) {
  const ir::Program& program = *version.program;
  const StoresOfBoth stores(version);
  std::vector<bool> set = stores.of_host.stored();
  for (uint32_t i = 0; i < set.size(); ++i) {
    const execute::Cell cell = execute::CellAt(program, version.cells, execute::CellId(i));
    // Another way to call the program's parts keeps its place in memory that nobody else knows.
    set[i] = set[i] && cell.kind == execute::CellKind::kBit && program.spaces[cell.space].host_visible &&
             DirectionOf(version, execute::CellId(i)) != ir::Direction::kOutput;
  }
  return set;
}

std::vector<bool> InputsOf(const Version& version) {
  const ir::Program& program = *version.program;
  const StoresOfBoth stores(version);
  const std::vector<bool>& own = stores.own.stored();
  const std::vector<bool>& of_host = stores.of_host.stored();
  std::vector<bool> inputs(version.cells.count);
  for (uint32_t i = 0; i < version.cells.calls; ++i) {
    const execute::CellId id(i);
    const execute::Cell cell = execute::CellAt(program, version.cells, id);
    if (cell.kind != execute::CellKind::kBit || !IsState(version, id)) continue;
    const ir::Direction direction = DirectionOf(version, id);
    // What the program's side never writes anybody may set, an output, too.
    const bool is_free = !own[i] || (direction != ir::Direction::kOutput && of_host[i]);
    inputs[i] = direction == ir::Direction::kInput || (program.spaces[cell.space].host_visible && is_free);
  }
  return inputs;
}

}  // namespace plcxx::prove::machine
