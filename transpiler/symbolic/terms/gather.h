// Bits that belong together as the one term that they come from.
//
// Memory is bits; words that were stored whole, or chosen whole, are words again when they are read, so that they look
// like those of a side that never took them apart.
#pragma once

#include <span>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// The same as Concat of all of them, `bits` from the least significant one on.
TermId Gather(Terms& terms, std::span<const TermId> bits);

}  // namespace plcxx::terms
