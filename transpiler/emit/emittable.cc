#include "transpiler/emit/emittable.h"

#include <bit>
#include <cmath>

#include "transpiler/ir/builder.h"

namespace plcxx::emit {

bool IsPrinted(const ir::Routine& routine, const EmitOptions& options) {
  return !routine.simulation_only || options.simulated || options.flavour == Flavour::kDebug;
}

std::vector<ir::InstId> PrintedInsts(const ir::Program& program, const EmitOptions& options) {
  std::vector<ir::InstId> insts;
  for (const ir::Routine& routine : program.routines) {
    if (!IsPrinted(routine, options)) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) ir::ForEachInst(program, region, [&insts](ir::InstId id) { insts.push_back(id); });
    }
  }
  return insts;
}

bool IsEffect(const Emittable& emittable, ir::InstId id) {
  const ir::Inst& inst = (*emittable.program)[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
    case ir::Shape::kConst:
    case ir::Shape::kStatement:
      return false;
    case ir::Shape::kStep:
    case ir::Shape::kStore:
    case ir::Shape::kText:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return true;
  }
  return true;
}

bool HasLiteral(ir::Type type, uint64_t value) {
  if (type == ir::Type::kF32) return std::isfinite(std::bit_cast<float>(static_cast<uint32_t>(value)));
  return type != ir::Type::kF64 || std::isfinite(std::bit_cast<double>(value));
}

}  // namespace plcxx::emit
