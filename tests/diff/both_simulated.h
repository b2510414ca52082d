// Judges what plcxx diff calls equal: simulations of both versions side by side, with inputs, pauses, power failures
// and a host that answers at random.
//
// In: two versions that were compared, and the result. Out: the first location that the result calls equal and a run
// shows to differ. Shares neither the search for runs nor the pictures of the comparison; names and pairs of locations
// are its own.
#pragma once

#include <optional>
#include <string>

#include "transpiler/review/diff/diff.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {

struct SimulatedRuns {
  int runs = 8;
  int steps = 50;
};

/// "U4A8 is 1 and 0 after 12 steps of run 3": it is called equal. None: nothing was seen.
std::optional<std::string> SeenToDiffer(const DiffSide& old_side, const DiffSide& new_side, const Diff& diff,
                                        const DiffOptions& options, SimulatedRuns runs, terms::Random& random);

}  // namespace plcxx::review::diff
