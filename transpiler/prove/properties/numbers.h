// The numbers of a program: fields, and what places of whole bytes name.
#pragma once

#include <vector>

#include "transpiler/prove/properties/checked_program.h"

namespace plcxx::prove::properties {

/// Those in some cells, the nearest ones first; inputs are none.
std::vector<std::vector<execute::CellId>> NumbersAmong(const CheckedProgram& checked,
                                                       const std::vector<execute::CellId>& cells);

}  // namespace plcxx::prove::properties
