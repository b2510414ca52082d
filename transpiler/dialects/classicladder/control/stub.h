// A simulated control for dialect classicladder.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "transpiler/dialects/dialect.h"

namespace plcxx::classicladder {

std::unique_ptr<dialects::ControlStub> MakeStub(const ir::Program& program,
                                                const std::map<std::string, std::string>& options);

}  // namespace plcxx::classicladder
