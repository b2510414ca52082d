// Compilers with their flags as platforms of scenarios.
#pragma once

#include <memory>
#include <string>

#include "transpiler/engines/platform.h"

namespace plcxx::reference {

/// "g++ -O2": a compiler with its flags, as a platform of the scenarios.
std::shared_ptr<const engines::Platform> MakeCompiler(const std::string& command);

}  // namespace plcxx::reference
