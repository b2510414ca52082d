// Which scenarios a command is about: those of the command line, or those of plcxx.yaml.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/driver/common_options.h"

namespace plcxx::driver {

struct ChosenScenarios {
  std::vector<std::string> paths;
  std::string host_compiler;  // of the project's target 'host'; empty: it names none
};

/// `named`: of the command line, files or folders. None when that cannot be, or a folder holds none; reported.
std::optional<ChosenScenarios> ChooseScenarios(CommonOptions& options, const std::vector<std::string>& named);

}  // namespace plcxx::driver
