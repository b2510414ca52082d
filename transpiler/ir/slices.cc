#include "transpiler/ir/slices.h"

#include <algorithm>

namespace plcxx::ir {
namespace {

PlaceId SlicePlace(const Routine& routine) {
  for (size_t i = 0; i < routine.parameters.size(); ++i) {
    if (routine.parameters[i].name == "slice") return routine.parameter_places[i];
  }
  return {};
}

bool IsLoadOf(const Inst& inst, PlaceId place) {
  return Info(inst.op).shape == Shape::kLoad && inst.payload == place.index;
}

}  // namespace

bool TakesSlice(const Routine& routine) { return SlicePlace(routine).valid(); }

std::vector<SlicePiece> SlicePieces(const Program& program, RoutineId id) {
  const Routine& routine = program.routines[id];
  const PlaceId slice = SlicePlace(routine);
  std::vector<SlicePiece> pieces;
  if (!slice.valid() || !routine.body.valid()) return pieces;
  const std::vector<InstId>& insts = program.regions[routine.body].insts;
  const auto choice = std::ranges::find_if(insts, [&](InstId at) {
    const Inst& inst = program[at];
    return inst.op == OpKind::kSwitch && IsLoadOf(program[ValueId(inst.a)], slice);
  });
  if (choice == insts.end()) return pieces;
  for (const SwitchCase& arm : program.switches[SwitchId(program[*choice].payload)].cases) {
    if (arm.falls_through) return {};
    for (const uint64_t value : arm.values) pieces.push_back({value, arm.region});
  }
  std::ranges::sort(pieces, {}, &SlicePiece::slice);
  return pieces;
}

}  // namespace plcxx::ir
