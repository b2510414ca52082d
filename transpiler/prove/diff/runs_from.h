// Runs that begin with two versions at work: what has to be set now so that they differ soon.
//
// The state in which both were seen is taken as it is, and a few periods are executed over their inputs alone: most of
// a program is constant then, and a question about it is a small one, however large the program. The inputs are set
// once and held, so that what wants to see them twice is satisfied. In: two versions, a state of both. Out: what to
// set. Not its job: whether the control lets it be; that is seen when the run is repeated.
#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "transpiler/prove/diff/unrolled.h"

namespace plcxx::prove::diff {

struct SeenState {
  std::function<uint64_t(Which, execute::CellId)> value;  // of memory and instances
  uint64_t now_ms = 0;
};

/// At most one run for each of `sought` (old cells), as short as they come.
std::vector<Run> RunsFrom(const UnrolledVersions& versions, const SeenState& state,
                          const std::vector<execute::CellId>& sought, uint32_t most_periods,
                          std::chrono::steady_clock::time_point end);

}  // namespace plcxx::prove::diff
