// What is shown once more where it counts: as generated code, compiled here.
#pragma once

#include <chrono>

#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

/// Runs the scenario of each counterexample on the generated code of both versions, with the simulator beside it. One
/// that does not pass on the old version and fail on the new one there is taken back: its item is undecided. When
/// nothing could be run until `end`, Diff::not_compiled says why.
void ConfirmCompiled(DiffSide& old_side, DiffSide& new_side, const DiffOptions& options,
                     std::chrono::steady_clock::time_point end, Diff& diff);

}  // namespace plcxx::review::diff
