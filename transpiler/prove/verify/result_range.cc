#include "transpiler/prove/verify/result_range.h"

#include <algorithm>

#include "transpiler/ir/builder.h"

namespace plcxx::prove::verify {
namespace {

/// How many numbers a value can be, from 0 on; 0: any of its type.
uint64_t CountOf(const ir::Program& program, ir::ValueId value) {
  const ir::Inst& inst = program[value];
  if (inst.op == ir::OpKind::kConst) return ir::ConstantValue(inst) + 1;
  if (inst.op == ir::OpKind::kWiden1To16 || inst.op == ir::OpKind::kWiden1To32) return 2;
  if (inst.op == ir::OpKind::kWiden8To16 || inst.op == ir::OpKind::kWiden8To32) return 256;
  if (inst.op == ir::OpKind::kWiden16To32) return 65536;
  return 0;
}

}  // namespace

std::optional<NumberRange> RangeOfResult(const ir::Program& program, const Unit& unit) {
  if (!unit.result.valid()) return std::nullopt;
  const ir::Routine& routine = program.routines[unit.part.routine];
  uint64_t most = 0;
  bool is_any = false;
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid()) continue;
    ir::ForEachInst(program, region, [&](ir::InstId id) {
      const ir::Inst& inst = program[id];
      if (inst.op != ir::OpKind::kStore || ir::PlaceId(inst.payload) != unit.result) return;
      const uint64_t count = CountOf(program, ir::ValueId(inst.a));
      is_any = is_any || count == 0;
      most = std::max(most, count);
    });
  }
  if (is_any || most == 0) return std::nullopt;
  return NumberRange{.low = 0, .count = most};
}

}  // namespace plcxx::prove::verify
