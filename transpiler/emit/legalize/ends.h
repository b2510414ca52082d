// Whether control gets to the end of the text of a list.
#pragma once

#include <vector>

#include "transpiler/emit/function_insts.h"

namespace plcxx::emit::legalize {

/// False where every way through the pieces leaves them before: by return, break, continue or goto.
bool EndIsReached(const Emittable& emittable, const std::vector<Piece>& pieces);
bool EndIsReached(const Emittable& emittable, ir::RegionId region);

}  // namespace plcxx::emit::legalize
