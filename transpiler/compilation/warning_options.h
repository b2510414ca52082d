// -W<name>, -Wno-<name>, -Werror and -Werror=<name>, in the order of the command line.
#pragma once

#include <string>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::compilation {

/// Takes what stands after each -W. What names no warning of the catalogue goes to `unknown` as it was written.
diag::WarningOptions ReadWarningOptions(const std::vector<std::string>& arguments, std::vector<std::string>& unknown);

}  // namespace plcxx::compilation
