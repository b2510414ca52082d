// What terms depend on.
#pragma once

#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// All that the roots are made of, themselves included; ascending, which is operands first.
std::vector<TermId> ConeOf(const Terms& terms, std::span<const TermId> roots);
/// The same without what only applications of functions are made of.
std::vector<TermId> ConeAboveFunctions(const Terms& terms, std::span<const TermId> roots);

}  // namespace plcxx::terms
