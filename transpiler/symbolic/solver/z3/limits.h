// A question's limit in Z3's own parameters.
#pragma once

#include <z3++.h>

#include <algorithm>
#include <cstdint>

#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::solver {

/// What Z3 counts ("rlimit") in a millisecond of an idle core, asked about bits: 4,000 to 9,500, seen with the samples.
inline constexpr uint32_t kStepsOfMs = 8000;

inline z3::params Parameters(z3::context& context, const Limit& limit) {
  z3::params parameters(context);
  const bool counts = limit.effort_ms < Limit::kNone / kStepsOfMs;
  // To Z3 0 is no limit at all, in both; kNone is its own word for no time-out.
  parameters.set("rlimit", counts ? std::max(1U, limit.effort_ms * kStepsOfMs) : 0U);
  parameters.set("timeout", std::max(1U, limit.clock_ms));
  return parameters;
}

}  // namespace plcxx::solver
