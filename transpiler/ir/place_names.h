// What a reader of the source knows a place by.
#pragma once

#include <string>

#include "transpiler/ir/memory.h"

namespace plcxx::ir {

/// The address that the source writes; the name of what has none.
inline const std::string& SourceName(const Place& place) { return place.address.empty() ? place.name : place.address; }

}  // namespace plcxx::ir
