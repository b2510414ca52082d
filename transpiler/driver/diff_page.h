// A Diff as the report's page: both versions with what changed its behaviour marked.
#pragma once

#include <string>

#include "transpiler/review/diff/diff.h"

namespace plcxx::driver {

/// HTML, one file. Both sides have been compared without a refusal.
std::string DiffPage(const review::diff::Diff& diff, const review::diff::DiffSide& old_side,
                     const review::diff::DiffSide& new_side);

}  // namespace plcxx::driver
