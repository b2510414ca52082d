// The rule of Make that names every file a program was made from; Ninja and CMake read it too.
#pragma once

#include <string>
#include <vector>

namespace plcxx::driver {

/// "a.hpp a.cpp: turret.sym turret.plc\n", with blanks, '#', '$' and others escaped as Make wants them.
std::string DependencyRule(const std::vector<std::string>& targets, const std::vector<std::string>& dependencies);

}  // namespace plcxx::driver
