// What one host function may write.
#pragma once

#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::execute {

/// As HostWrites; but inputs of the machine come with the regular exchange alone: a function that the program calls for
/// something else writes what the control and the program share.
bool MayWrite(const ir::Program& program, const ir::HostFunction& host, ir::SpaceId space, uint32_t offset);

}  // namespace plcxx::execute
