// Where a location is in the State of a running machine.
#pragma once

#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/link/cells.h"

namespace plcxx::live {

/// Empty: the program does not keep it. `location` is memory.
std::vector<debug_link::Cell> CellsOf(const ir::Program& program, const emit::layout::Layout& layout,
                                      const dialects::Location& location);

}  // namespace plcxx::live
