#include "transpiler/prove/diff/power_on_calls.h"

#include <algorithm>

#include "transpiler/ir/op.h"

namespace plcxx::prove::diff {

bool IsCalledAtPowerOn(const machine::Version& version, execute::CellId calls) {
  const ir::Program& program = *version.program;
  const ir::HostFunctionId host = execute::CellAt(program, version.cells, calls).host;
  if (!host.valid()) return false;
  const auto calls_it = [&](ir::InstId id) {
    const ir::Inst& inst = program[id];
    return ir::Info(inst.op).shape == ir::Shape::kHostCall && program.calls[ir::CallId(inst.payload)].host == host;
  };
  // No instruction of init leaves what these instructions stand in.
  const ir::Routine& init = program.routines[program.schedule.init];
  for (const ir::RegionId region : {init.prologue, init.body}) {
    if (region.valid() && std::ranges::any_of(program.regions[region].insts, calls_it)) return true;
  }
  return false;
}

}  // namespace plcxx::prove::diff
