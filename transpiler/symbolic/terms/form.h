// What a term is but for the names of its variables and unknown functions: two terms of one form are possible, or never
// hold, both alike.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Equal for two terms only when the one becomes the other by renaming variables and functions without `evaluate`, each
/// to one of its own of the same widths. The two may be of different Terms. None: it has more than so many terms.
std::optional<std::string> FormOf(const Terms& terms, TermId root, size_t most_terms);

}  // namespace plcxx::terms
