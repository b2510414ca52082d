// Which operations are logic of bits alone: their result says nothing that their operands do not.
#pragma once

#include <algorithm>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// From bits to a bit, by a function without effects.
inline bool IsBitLogic(const Inst& inst) {
  const OpInfo& info = Info(inst.op);
  if (info.shape != Shape::kPure || info.operand_count == 0 || info.result != Type::kBit) return false;
  return std::all_of(info.operands, info.operands + info.operand_count, [](Type type) { return type == Type::kBit; });
}

}  // namespace plcxx::ir
