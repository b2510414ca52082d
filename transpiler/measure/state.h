// How many bytes of State a part of the program uses.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/emit/emittable.h"

namespace plcxx::measure {

struct StateBytes {
  uint64_t retentive = 0, volatile_bytes = 0;
};

/// Of the statements in these regions (by RegionId): each byte once, timers and counters whole. What host functions do
/// with State is not in it.
StateBytes StateUsed(const emit::Emittable& emittable, const std::vector<bool>& regions);

}  // namespace plcxx::measure
