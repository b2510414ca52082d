// Names of locations in scenarios (specification 4.4): bits, bytes and words of areas, elements of views, variables
// with their elements and members, what the runtime keeps.
#pragma once

#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"

namespace plcxx::hnc {

/// The cell of FAULT.line, which the simulated control answers: the map knows the statement's line, memory does not.
inline constexpr uint32_t kFaultLineCell = 0;

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);

}  // namespace plcxx::hnc
