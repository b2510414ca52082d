#include "transpiler/prove/diff/power_on_calls.h"

#include <algorithm>

#include "transpiler/ir/op.h"

namespace plcxx::prove::diff {
namespace {

bool Calls(const ir::Program& program, ir::RegionId region, ir::HostFunctionId host) {
  return region.valid() && std::ranges::any_of(program.regions[region].insts, [&](ir::InstId id) {
           const ir::Inst& inst = program[id];
           return ir::Info(inst.op).shape == ir::Shape::kHostCall &&
                  program.calls[ir::CallId(inst.payload)].host == host;
         });
}

/// Whether a function is called each time power comes: no instruction of init leaves what it is in.
bool IsCalledAtPowerOn(const machine::Version& version, execute::CellId calls) {
  const ir::Program& program = *version.program;
  const ir::HostFunctionId host = execute::CellAt(program, version.cells, calls).host;
  const ir::Routine& init = program.routines[program.schedule.init];
  return host.valid() && (Calls(program, init.prologue, host) || Calls(program, init.body, host));
}

bool IsCalledNowhere(const machine::Version& version, execute::CellId calls) {
  const ir::Program& program = *version.program;
  const ir::HostFunctionId host = execute::CellAt(program, version.cells, calls).host;
  if (!host.valid()) return false;
  for (uint32_t i = 0; i < program.regions.size(); ++i) {
    if (Calls(program, ir::RegionId(i), host)) return false;
  }
  return true;
}

}  // namespace

std::optional<Which> OnlyCaller(const machine::Version& old_version, execute::CellId old_calls,
                                const machine::Version& new_version, execute::CellId new_calls) {
  if (IsCalledAtPowerOn(old_version, old_calls) && IsCalledNowhere(new_version, new_calls)) return Which::kOld;
  if (IsCalledAtPowerOn(new_version, new_calls) && IsCalledNowhere(old_version, old_calls)) return Which::kNew;
  return std::nullopt;
}

}  // namespace plcxx::prove::diff
