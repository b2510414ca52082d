#include "transpiler/sim/decoded_program.h"

#include <optional>

#include "transpiler/sim/instructions.h"

namespace plcxx::sim {
namespace {

Decoded DecodedOf(const ir::Program& program, const Instances& instances, const std::vector<PlaceAccess>& places,
                  ir::InstId id) {
  const ir::Inst& inst = program[id];
  Decoded decoded{
      .execute = FunctionOf(inst.op), .id = id.index, .a = inst.a, .b = inst.b, .c = inst.c, .payload = inst.payload};
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape != ir::Shape::kLoad && shape != ir::Shape::kStore) return decoded;
  const PlaceAccess& access = places[inst.payload];
  const Function fast =
      shape == ir::Shape::kLoad ? LoadOf(access, program.places[ir::PlaceId(inst.payload)].type) : StoreOf(access);
  if (fast == decoded.execute) return decoded;
  decoded.execute = fast;
  decoded.b = access.kind == AccessKind::kField ? instances.PlaceOf(access.owner, access.field) : access.offset;
  decoded.c = access.owner;
  decoded.payload = access.bit;
  return decoded;
}

/// What is executed of a region: rungs where there are some.
void FindRungs(const ir::Program& program, DecodedRegion& region, DecodedProgram& code) {
  constexpr uint32_t kLeast = 6;  // instructions; with fewer a rung is no faster than they are
  region.ready_begin = static_cast<uint32_t>(code.ready.size());
  for (uint32_t at = region.begin; at < region.constants;) {
    const auto first_step = static_cast<uint32_t>(code.logic.size());
    uint32_t end = at, flags = 0;
    if (program[ir::InstId(code.decoded[end].id)].op == ir::OpKind::kStatement) {
      flags |= Decoded::kHasStatement;
      ++end;
    }
    while (end < region.constants) {
      const Decoded& decoded = code.decoded[end];
      const std::optional<LogicStep> step = StepOf(program[ir::InstId(decoded.id)], decoded);
      if (!step) break;
      code.logic.push_back(*step);
      ++end;
    }
    const uint32_t step_count = static_cast<uint32_t>(code.logic.size()) - first_step;
    if (end < region.constants && WritesBit(code.decoded[end])) {
      flags |= Decoded::kHasCoil;
      ++end;
    }
    if (end - at < kLeast) {
      code.logic.resize(first_step);
      code.ready.push_back(code.decoded[at]);
      ++at;
      continue;
    }
    const Decoded& last = code.decoded[end - 1];
    code.ready.push_back({.execute = ExecuteRung,
                          .id = last.id,
                          .order = last.order,
                          .a = at,
                          .b = first_step,
                          .c = step_count,
                          .payload = flags});
    at = end;
  }
  region.ready_end = static_cast<uint32_t>(code.ready.size());
}

}  // namespace

DecodedProgram::DecodedProgram(const ir::Program& program, const Instances& instances) {
  for (const ir::Place& place : program.places) places.push_back(AccessTo(program, place));
  locals = FindLocalStretches(program, places);
  const auto gives_itself = [](const ir::Inst& inst) { return ir::Info(inst.op).shape == ir::Shape::kConst; };
  decoded_at.resize(program.insts.size());
  regions.resize(program.regions.size());
  decoded.reserve(program.insts.size());
  for (uint32_t i = 0; i < program.regions.size(); ++i) {
    DecodedRegion& region = regions[i];
    region.begin = static_cast<uint32_t>(decoded.size());
    for (const bool constants : {false, true}) {
      if (constants) region.constants = static_cast<uint32_t>(decoded.size());
      uint32_t order = 0;
      for (const ir::InstId id : program.regions[ir::RegionId(i)].insts) {
        const uint32_t here = order++;
        if (gives_itself(program[id]) != constants) continue;
        decoded_at[id.index] = static_cast<uint32_t>(decoded.size());
        decoded.push_back(DecodedOf(program, instances, places, id));
        decoded.back().order = here;
      }
    }
    region.end = static_cast<uint32_t>(decoded.size());
  }
  for (DecodedRegion& region : regions) FindRungs(program, region, *this);
}

}  // namespace plcxx::sim
