// Terms with other terms in the place of some.
#pragma once

#include <map>

#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {

using Replacements = std::map<TermId, TermId>;

/// `term` with all that `replacements` names replaced, at once: what is put in is not looked into.
TermId Substitute(Terms& terms, TermId term, const Replacements& replacements);

}  // namespace plcxx::prove
