// What follows from the times of a schedule.
#pragma once

#include <algorithm>
#include <cstdint>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// How often a fast part with a time of its own runs in a period of the slow one, at least once; 0: it has none.
inline uint32_t FastPartsOfPeriod(const Schedule& schedule) {
  return schedule.fast_ms == 0 ? 0 : std::max(1U, schedule.period_ms / schedule.fast_ms);
}

}  // namespace plcxx::ir
