// What a reader of the source knows a place by.
#pragma once

#include <string>

#include "transpiler/ir/memory.h"

namespace plcxx::driver {

/// The address that the source writes; the name of what has none.
inline const std::string& SourceName(const ir::Place& place) {
  return place.address.empty() ? place.name : place.address;
}

}  // namespace plcxx::driver
