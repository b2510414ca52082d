// The simulated control and its machine: inputs as a scenario has set them last (specification 4.3).
//
// It delivers them at every read_inputs, also over a power cycle; what the program has written into %IW or %IF ends
// there. Not its job: answers to the signals of the NC, which a scenario gives itself.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::host50 {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

}  // namespace plcxx::host50
