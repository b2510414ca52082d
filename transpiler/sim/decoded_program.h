// A program made ready for execution: its places, its locals, its instructions, region by region.
//
// In: a structured program. Out: what an execution reads, and nothing that it changes. Not its job: what an instruction
// does (instructions.h).
#pragma once

#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/decoded.h"
#include "transpiler/sim/instances.h"
#include "transpiler/sim/local_stretches.h"
#include "transpiler/sim/place_access.h"
#include "transpiler/sim/rungs.h"

namespace plcxx::sim {

struct DecodedProgram {
  /// `instances`: those of the program, whose fields are at the same places in every copy.
  DecodedProgram(const ir::Program& program, const Instances& instances);

  const Decoded& Of(ir::InstId id) const { return decoded[decoded_at[id.index]]; }
  const DecodedRegion& Of(ir::RegionId region) const { return regions[region.index]; }

  std::vector<PlaceAccess> places;     // by PlaceId
  std::vector<LocalStretches> locals;  // by RoutineId
  std::vector<Decoded> decoded;
  std::vector<uint32_t> decoded_at;    // by InstId: in decoded
  std::vector<DecodedRegion> regions;  // by RegionId
  std::vector<Decoded> ready;          // what is executed; see DecodedRegion
  std::vector<LogicStep> logic;
};

}  // namespace plcxx::sim
