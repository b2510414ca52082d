// Which constants a function is called with, so that it is proved for these alone: a channel or an axis that indexes
// tables makes one small proof for each number instead of one about all elements at once.
//
// In: a unit. Out: its cases. Sound because the calls of the typed IR are all that there are: that the code passes the
// same values is part of each caller's proof. Not its job: parameters that some call computes; they stay unknown.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/prove/verify/units.h"

namespace plcxx::prove::verify {

/// One value for each of Unit::values; none: any.
using ArgumentCase = std::vector<std::optional<uint64_t>>;

/// At least one case, in the order of the calls; one of unknowns alone where the cases would be many.
std::vector<ArgumentCase> ArgumentCases(const ir::Program& program, const Unit& unit);

}  // namespace plcxx::prove::verify
