// Runs that begin with two versions at work: what has to be set now so that they differ soon.
//
// The state in which both were seen is taken as it is, and a few periods are executed over their inputs alone: most of
// a program is constant then, and a question about it is a small one, however large the program. The inputs are set
// once and held, so that what wants to see them twice is satisfied. In: two versions, a state of both. Out: what to
// set. Not its job: whether the control lets it be; that is seen when the run is repeated.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "transpiler/prove/diff/unrolled.h"

namespace plcxx::prove::diff {

struct SeenState {
  std::function<uint64_t(Which, execute::CellId)> value;  // of memory and instances
  uint64_t now_ms = 0;
};

struct AimLimits {
  uint32_t most_periods = 1;
  size_t most_questions = 12;  // of one state: what is not found here may be found from the next one
  uint32_t question_ms = 200;
  std::chrono::steady_clock::time_point end;
};

/// At most one run for each of `sought` (old cells), as short as they come, told to `found`; none for what `is_open` no
/// longer says then.
void RunsFrom(const UnrolledVersions& versions, const SeenState& state, const std::vector<execute::CellId>& sought,
              const AimLimits& limits, const std::function<bool(execute::CellId)>& is_open,
              const std::function<void(const Run&)>& found);

/// A number of the old version, as its cells from the lowest, and what it shall be.
struct WantedNumber {
  std::vector<execute::CellId> cells;
  std::vector<uint64_t> values;  // one of them, or none of them
  bool is_none = false;
};
/// The shortest run after which it is; none: it was not found.
std::optional<Run> RunTo(const UnrolledVersions& versions, const SeenState& state, const WantedNumber& wanted,
                         const AimLimits& limits);

}  // namespace plcxx::prove::diff
