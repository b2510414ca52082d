#include "transpiler/passes/cut_slices.h"

#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/items.h"

namespace plcxx::passes {
namespace {

/// floor(slices * before / all) without overflow: weights are far below 2^58 ns, which are nine years.
uint64_t SliceOf(uint64_t before, uint64_t all, uint64_t slices) {
  if (all == 0) return 0;
  const uint64_t slice = slices * before / all;
  return slice < slices ? slice : slices - 1;  // items of weight 0 after the last one that has some
}

ir::PlaceId SlicePlace(const ir::Routine& routine) {
  for (size_t i = 0; i < routine.parameters.size(); ++i) {
    if (routine.parameters[i].name == "slice") return routine.parameter_places[i];
  }
  PLCXX_UNREACHABLE();  // the verifier refuses such a routine
}

ir::ValueId IsSlice(ir::Builder& builder, ir::PlaceId place, uint64_t slice) {
  const ir::Type type = builder.program().places[place].type;
  PLCXX_CHECK(type == ir::Type::kI8 || type == ir::Type::kI32);
  const ir::OpKind equal = type == ir::Type::kI8 ? ir::OpKind::kEqual8 : ir::OpKind::kEqual32;
  const ir::ValueId value = builder.Load(place);
  return builder.Pure(equal, {value, builder.Constant(type, slice)});
}

}  // namespace

void CutSlices(ir::Program& program, ir::RoutineId id, std::span<const uint64_t> weights) {
  const ir::Routine routine = program.routines[id];
  if (routine.slices <= 1) return;
  const std::vector<ir::Item> items = ir::Items(program, routine.body);
  PLCXX_CHECK(items.size() == weights.size());
  const ir::PlaceId place = SlicePlace(routine);

  // The items' instructions, distributed.
  std::vector<ir::Region> pieces(routine.slices);
  if (routine.prologue.valid()) pieces.front() = std::move(program.regions[routine.prologue]);
  uint64_t all = 0, before = 0;
  for (const uint64_t weight : weights) all += weight;
  const std::vector<ir::InstId>& insts = program.regions[routine.body].insts;
  for (size_t i = 0; i < items.size(); ++i) {
    std::vector<ir::InstId>& piece = pieces[SliceOf(before, all, routine.slices)].insts;
    piece.insert(piece.end(), insts.begin() + items[i].begin, insts.begin() + items[i].end);
    before += weights[i];
  }
  program.regions[routine.body].insts.clear();

  ir::Builder builder(program);
  ir::Switch cases;
  for (uint64_t slice = 0; slice < pieces.size(); ++slice) {
    const ir::RegionId region = program.regions.Add(std::move(pieces[slice]));
    cases.cases.push_back({.values = {slice}, .region = region});
  }
  builder.SetRegion(routine.body);
  const ir::ValueId selector = builder.Load(place);
  builder.SwitchOn(selector, std::move(cases));

  ir::RegionId guarded;
  if (routine.epilogue.valid()) {
    guarded = builder.NewRegion();
    builder.SetRegion(guarded);
    const ir::ValueId last = IsSlice(builder, place, routine.slices - 1u);
    builder.If(last, routine.epilogue);
  }
  program.routines[id].prologue = {};
  program.routines[id].epilogue = guarded;
}

}  // namespace plcxx::passes
