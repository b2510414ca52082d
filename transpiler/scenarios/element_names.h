// Names of memory that the program reaches by a computed index only: no place of it is there alone.
#pragma once

#include <optional>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/name_index.h"
#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::scenarios {

/// The element of an array, structure or area that has the bit, with its name as a scenario writes it:
/// "table[3].speed", "F[163]"; none: there is no such name.
std::optional<ir::Place> NamedElement(const ir::NameIndex& index, const dialects::Dialect& dialect,
                                      const execute::Cell& cell);

}  // namespace plcxx::scenarios
