// plcxx verify, run on a program of a test.
#pragma once

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {

/// Its exit status, 0 where all is proved, and what it said. Not by Run: solver and LLVM together take more address
/// space than that leaves.
inline std::string Verify(const std::string& file, const std::string& program, const std::string& options) {
  const Workplace workplace;
  workplace.Write(file, program);
  const std::string command =
      "cd '" + workplace.Path("") + "' && " PLCXX_BINARY " verify --time 60s " + file + " " + options + " >said 2>&1";
  return std::to_string(std::system(command.c_str())) + " " + workplace.Read("said");
}

}  // namespace plcxx::driver
