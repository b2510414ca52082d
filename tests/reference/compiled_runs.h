// Random programs as generated C++: each compiler and level of optimization beside the simulator.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/reference/random_program.h"
#include "transpiler/driver/platform.h"

namespace plcxx::reference {

/// "g++ -O2": a compiler with its flags, as a platform of the scenarios.
std::shared_ptr<const driver::Platform> MakeCompiler(const std::string& command);

/// The disagreement of a program that RunRandom has written into `directory`; empty: none.
std::string RunCompiled(const std::string& directory,
                        const std::vector<std::shared_ptr<const driver::Platform>>& compilers);

}  // namespace plcxx::reference
