// The operations that are the IR's own: memory, statements, control flow, calls.
#pragma once

#include "transpiler/ir/program.h"
#include "transpiler/sim/decoded.h"

namespace plcxx::sim::core {

// One for each, by its name in ops.def.
#define PLCXX_PURE(...)
#define PLCXX_STEP(...)
#define PLCXX_CORE(Kind, ...) Flow Kind(Execution& execution, ir::InstId id, const ir::Inst& inst);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE

}  // namespace plcxx::sim::core
