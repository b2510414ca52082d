// What a routine that the code only declares may give: as many bits as its own stores give.
//
// The program's passes know that (`get_axis_den` of hnc gives 0 or 1, and its widening to a long need not look at a
// sign), so an unknown function in its place may give no other number, on either side. In: a unit. Out: the range of
// its result; none where any number of its type may be given.
#pragma once

#include <optional>

#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/units.h"

namespace plcxx::prove::verify {

std::optional<NumberRange> RangeOfResult(const ir::Program& program, const Unit& unit);

}  // namespace plcxx::prove::verify
