// The numbers that stand in a program: what its words are compared with, counted to and set to.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// Of each constant of the program's regions that is no bit, as often as it stands there, by region: `visit(value)`.
template <class Visit>
void ForEachNumber(const Program& program, Visit&& visit) {
  for (const Region& region : program.regions) {
    for (const InstId id : region.insts) {
      const Inst& inst = program[id];
      if (inst.op == OpKind::kConst && inst.type != Type::kBit) visit(ConstantValue(inst));
    }
  }
}

}  // namespace plcxx::ir
