// One instruction that does something else than the program says.
//
// In: where it stands, and what it does instead. A simulator executes it so, or says in the program as it is where that
// would make a difference (changes.h). Not its job: which changes are worth
// trying (transpiler/mutate).
#pragma once

#include <cstdint>

#include "transpiler/ir/program.h"

namespace plcxx::sim {

enum class ChangedHow : uint8_t { kOperand, kOperation, kLeftOut };

struct ChangedInst {
  ir::InstId id;
  ir::RegionId region;  // that lists it
  ChangedHow how{};
  uint32_t use = 0;        // kOperand: this use, in the order of ir::ForEachUse,
  uint64_t number = 0;     // is this number, raw bits
  ir::OpKind operation{};  // kOperation: one of the same operands, result and instance
};

}  // namespace plcxx::sim
