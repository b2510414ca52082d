// What a term is but for the names of its variables and unknown functions: two terms of one form are possible, or never
// hold, both alike.
#pragma once

#include <string>

#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {

/// Equal for two terms only when the one becomes the other by renaming variables and functions without `evaluate`, each
/// to one of its own of the same widths.
std::string FormOf(const Terms& terms, TermId root);

}  // namespace plcxx::prove
