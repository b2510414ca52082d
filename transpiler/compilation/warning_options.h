// -W<name>, -Wno-<name>, -Werror and -Werror=<name>, in the order of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::compilation {

/// Takes what stands after each -W. What names no warning of the catalogue goes to `unknown` as it was written.
diag::WarningOptions ReadWarningOptions(const std::vector<std::string>& arguments, std::vector<std::string>& unknown);

/// What to do about a name of `unknown`, with "-W", "no-" and "error=" before it or without them: the warning that it
/// may have been meant to be, that it is an error, or where all are listed.
std::string RemedyOfUnknownWarning(std::string_view name);

}  // namespace plcxx::compilation
