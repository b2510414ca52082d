// Terms with other terms in the place of some.
#pragma once

#include <map>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

using Replacements = std::map<terms::TermId, terms::TermId>;

/// `term` with all that `replacements` names replaced, at once: what is put in is not looked into.
terms::TermId Substitute(terms::Terms& terms, terms::TermId term, const Replacements& replacements);

}  // namespace plcxx::prove::verify
