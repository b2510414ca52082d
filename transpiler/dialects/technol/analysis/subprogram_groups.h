// Which subprograms are one routine (specification 6.4).
//
// Subprograms that share instructions (one falls or jumps into another) are one routine with several entries, so that
// no instruction is generated twice. But a routine cannot call itself, and a subprogram may call the tail that it
// falls into ("do it twice"): in a circle of such calls only subprograms of equal level are joined. A call leads to a
// greater level, so that the circle is cut, and an instruction is generated at most once for each level.
#pragma once

#include <vector>

#include "transpiler/dialects/technol/analysis/flow.h"

namespace plcxx::technol {

struct SubprogramGroup {
  std::vector<uint32_t> subprograms;        // by Flow's numbers, in the order of their entries
  std::vector<InstructionId> instructions;  // in source order
  uint32_t level = 0;                       // greater than that of every group that calls this one
};

/// Of the subprograms that are reached.
std::vector<SubprogramGroup> GroupSubprograms(const Flow& flow);

}  // namespace plcxx::technol
