// Host functions that one version calls whenever power comes, and the other one never: that is certain without a run.
// In: two versions. Not its job: what follows from the calls.
#pragma once

#include <optional>

#include "transpiler/prove/diff/pairing.h"
#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::diff {

/// Which version alone calls the function, and does so each time power comes. `old_calls`, `new_calls`: the cell of its
/// calls in each version. None: neither, both, or nobody knows whether it comes to the call.
std::optional<Which> OnlyCaller(const machine::Version& old_version, execute::CellId old_calls,
                                const machine::Version& new_version, execute::CellId new_calls);

}  // namespace plcxx::prove::diff
