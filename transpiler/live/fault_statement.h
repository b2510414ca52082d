// The statement that a host call names among its arguments: that of a fault.
#pragma once

#include <optional>

#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"

namespace plcxx::live {

/// None: the call is no fault. An invalid one: it is, of a statement that the program does not have.
std::optional<ir::StatementId> FaultStatement(const ir::Program& program, const sim::HostEvent& event);

}  // namespace plcxx::live
