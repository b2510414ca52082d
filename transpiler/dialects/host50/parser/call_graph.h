// Who calls whom (specification 4.7): recursion and depth of calls.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

/// E307 for every CALL that closes a cycle; without any, E308 for the first CALL that is nested too deep.
void CheckCalls(Program& program, diag::Engine& diagnostics);

}  // namespace plcxx::host50
