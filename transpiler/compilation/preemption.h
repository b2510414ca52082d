// --preemptive of `plcxx check` and `plcxx emit`: the program as it is stored by generated code, and the check on it.
//
// In: a compilation without errors. Out: its diagnostics; with errors when the fast part may not interrupt the slow
// part. Not its job: the rules (checks/preemption.h).
#pragma once

#include <vector>

#include "transpiler/checks/preemption.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/emit/layout/layout.h"

namespace plcxx::compilation {

/// Where generated code keeps a place, and how an access is made.
checks::StoredPlace StoredAs(const ir::Place& place, const emit::layout::PlaceStorage& storage);

/// By PlaceId: what both parts use (emit::EmitOptions::shared). Does nothing when the compilation has errors or holds
/// data only. `compilation` was made to Stage::kOptimized.
std::vector<bool> CheckPreemptive(Compilation& compilation);

}  // namespace plcxx::compilation
