// A question to the solver as another solver reads it.
#pragma once

#include <span>
#include <string>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

/// SMT-LIB 2 (QF_UFBV): declarations of what the conditions depend on, an assertion for each, and (check-sat). The same
/// question gives the same bytes.
std::string SmtText(const terms::Terms& terms, std::span<const terms::TermId> conditions);

}  // namespace plcxx::solver
