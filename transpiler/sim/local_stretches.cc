#include "transpiler/sim/local_stretches.h"

#include <algorithm>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"

namespace plcxx::sim {
namespace {

/// Where there are more spaces of locals, all routines have all of them: the lists would grow with the square.
constexpr size_t kMostSpaces = 64;

void Add(const LocalStretch& stretch, LocalStretches& stretches) {
  const auto at = std::ranges::lower_bound(stretches, stretch.space, {}, &LocalStretch::space);
  if (at == stretches.end() || at->space != stretch.space) {
    stretches.insert(at, stretch);
    return;
  }
  at->begin = std::min(at->begin, stretch.begin);
  at->end = std::max(at->end, stretch.end);
}

class Finder {
 public:
  Finder(const ir::Program& program, const std::vector<PlaceAccess>& places)
      : program_(program), places_(places), found_(program.routines.size()), is_done_(program.routines.size()) {}

  std::vector<LocalStretches> Find() {
    LocalStretches all;
    for (uint32_t i = 0; i < program_.places.size(); ++i) AddPlace(ir::PlaceId(i), all);
    if (all.size() > kMostSpaces) return std::vector<LocalStretches>(program_.routines.size(), all);
    for (uint32_t i = 0; i < program_.routines.size(); ++i) Look(ir::RoutineId(i));
    return std::move(found_);
  }

 private:
  void AddPlace(ir::PlaceId place, LocalStretches& stretches) const {
    if (!place.valid()) return;
    const PlaceAccess& access = places_[place.index];
    if (access.kind == AccessKind::kAbsent || access.kind == AccessKind::kField) return;
    const ir::Space& space = program_.spaces[ir::SpaceId(access.owner)];
    if (space.lifetime != ir::Lifetime::kRoutine) return;
    const LocalStretch stretch{.space = access.owner,
                               .begin = access.indexed ? access.low : access.offset,
                               .end = access.indexed ? access.high : access.offset + access.bytes};
    if (stretch.begin < stretch.end) Add(stretch, stretches);
  }

  /// No routine calls itself, not even through others.
  void Look(ir::RoutineId id) {
    if (is_done_[id.index]) return;
    is_done_[id.index] = true;
    const ir::Routine& routine = program_.routines[id];
    LocalStretches used;
    for (const ir::PlaceId place : routine.parameter_places) AddPlace(place, used);
    AddPlace(routine.result_place, used);
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program_, region, [&](ir::InstId inst_id) {
        const ir::Inst& inst = program_[inst_id];
        ir::ForEachAccess(
            program_, inst, [&](ir::PlaceId place, ir::Access) { AddPlace(place, used); }, [](ir::StateId) {});
        if (inst.op != ir::OpKind::kCall) return;
        const ir::RoutineId callee = program_.calls[ir::CallId(inst.payload)].routine;
        Look(callee);
        for (const LocalStretch& stretch : found_[callee.index]) Add(stretch, used);
      });
    }
    found_[id.index] = std::move(used);
  }

  const ir::Program& program_;
  const std::vector<PlaceAccess>& places_;
  std::vector<LocalStretches> found_;
  std::vector<bool> is_done_;
};

}  // namespace

std::vector<LocalStretches> FindLocalStretches(const ir::Program& program, const std::vector<PlaceAccess>& places) {
  return Finder(program, places).Find();
}

}  // namespace plcxx::sim
