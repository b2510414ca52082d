// Which handlers are the same in every run of a program: where every registration of a slot is executed whenever init()
// is, the last one decides, and the dispatcher calls its function without asking (specification 7.3).
//
// In: the tree and the registrations in it. Out: what is fixed. Not its job: wrong registrations (checks_calls.cc).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "transpiler/dialects/hnc/analysis/facts.h"

namespace plcxx::hnc {

/// By channel and kind. No value: it is known at run time only, or nothing registers there. No function: removed.
using FixedHandlers = std::array<std::array<std::optional<FunctionId>, kHandlerKinds.size()>, 4>;

FixedHandlers FindFixedHandlers(const Unit& unit, const Facts& facts);

}  // namespace plcxx::hnc
