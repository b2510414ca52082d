// One id for one statement of the source.
//
// A lowering may generate a statement more than once (shared tails of technol's subprograms), and each copy is told by
// an id of its own. A reference knows the statement only: here all copies get the id of the first one.
#pragma once

#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::reference {

/// In the statements and in the host calls that name one.
void UniteStatementIds(ir::Program& program, const source::SourceManager& sources);

}  // namespace plcxx::reference
