// Numbers that were widened with their sign.
#pragma once

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// What Sext has made `id` of; none: it is something else.
TermId SignExtended(Terms& terms, TermId id);

}  // namespace plcxx::terms
