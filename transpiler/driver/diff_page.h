// A Diff as the report's page: both versions with what changed its behaviour marked.
#pragma once

#include <string>

#include "transpiler/driver/diff.h"

namespace plcxx::driver {

/// HTML, one file. Both sides have been compared without a refusal.
std::string DiffPage(const Diff& diff, const DiffSide& old_side, const DiffSide& new_side);

}  // namespace plcxx::driver
