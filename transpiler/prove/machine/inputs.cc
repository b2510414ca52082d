#include "transpiler/prove/machine/inputs.h"

#include "transpiler/ir/accesses.h"
#include "transpiler/prove/machine/sets.h"

namespace plcxx::prove::machine {
namespace {

/// What the schedule, and all that it calls, sets at fixed addresses and in arrays. An index that may reach all of a
/// space may reach signals of the host there, and says nothing about them.
class Stores {
 public:
  explicit Stores(const Version& version)
      : version_(version), program_(*version.program), set_(version.cells.count), stored_(version.cells.count) {
    const std::vector<bool> is_scheduled = ScheduledRegions(program_);
    for (uint32_t i = 0; i < is_scheduled.size(); ++i) {
      if (is_scheduled[i]) Region(program_.regions[ir::RegionId(i)]);
    }
  }

  /// As Uses::sets.
  bool Sets(execute::CellId cell) const {
    return set_[cell.index] || (stored_[cell.index] && !MayBeSetByOthers(version_, cell));
  }

 private:
  void Place(const ir::Inst& inst, ir::PlaceId id) {
    const ir::Place& place = program_.places[id];
    if (place.is_field()) return;
    const bool is_array = place.indexed && (place.low > 0 || place.high < program_.spaces[place.space].bytes);
    if (!is_array && !execute::IsInside(program_, place)) return;
    for (const execute::CellId cell : execute::TouchedCells(program_, version_.cells, place))
      stored_[cell.index] = true;
    for (const execute::CellId cell : CellsThatMayBeSet(version_, inst, id)) set_[cell.index] = true;
  }

  void Region(const ir::Region& region) {
    for (const ir::InstId id : region.insts) {
      const ir::Inst& inst = program_[id];
      ir::ForEachAccess(
          program_, inst,
          [&](ir::PlaceId place, ir::Access access) {
            if (access == ir::Access::kWrite) Place(inst, place);
          },
          [](ir::StateId) {});
    }
  }

  const Version& version_;
  const ir::Program& program_;
  std::vector<bool> set_, stored_;
};

}  // namespace

bool IsInbox(const Version& version, execute::CellId id) {
  const ir::StateId inbox = version.program->text_inbox;
  if (!inbox.valid()) return false;
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kField && cell.state == inbox;
}

std::vector<bool> InputsOf(const Version& version) {
  const ir::Program& program = *version.program;
  const Stores own(version);
  std::vector<bool> inputs(version.cells.count);
  for (uint32_t i = 0; i < version.cells.calls; ++i) {
    const execute::CellId id(i);
    const execute::Cell cell = execute::CellAt(program, version.cells, id);
    if (cell.kind != execute::CellKind::kBit || !IsState(version, id)) continue;
    // What the program's side never writes, or only takes back, anybody may set, an output, too.
    inputs[i] = WhatControlWrites(version, id) == execute::ControlWrite::kValues ||
                (MayBeSetByHost(version, id) && !own.Sets(id));
  }
  return inputs;
}

}  // namespace plcxx::prove::machine
