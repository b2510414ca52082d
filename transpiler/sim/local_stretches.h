// Which locals a routine uses, so that a call of a partition, which begins with its named locals 0 and leaves those of
// its caller as they were, has to touch no others.
//
// In: a program. Out: for each routine stretches of bytes of spaces of lifetime kRoutine. Not its job: their values.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/place_access.h"

namespace plcxx::sim {

/// Bytes [begin, end) of a space.
struct LocalStretch {
  uint32_t space = 0, begin = 0, end = 0;
};
using LocalStretches = std::vector<LocalStretch>;  // ascending by space, one of each at most

/// By RoutineId: what the routine and all that it calls use. `places`: those of the program, by PlaceId.
std::vector<LocalStretches> FindLocalStretches(const ir::Program& program, const std::vector<PlaceAccess>& places);

}  // namespace plcxx::sim
