// One scenario with many changes of its program, side by side: only where a change makes a difference its program is
// executed beside the original.
//
//   period          1  2  3  4  5  6  7  8
//   the original    -  -  -  -  -  -  -  -
//   change 17       .  .  -  -  .  .  -  x      different from 3 to 4, from 7 on, and in 8 an expectation does not hold
//
// In: a scenario that passes with the program as it is, and changes. Out: for each change whether it passes. Until a
// changed instruction gives something else than the original, its machine is the original; and it is the original again
// when after a piece of the program memory, control, plant and all that is kept for later expectations are the same.
// Not its job: changes whose time runs in another way; they are unclear, and have to be run alone (mutate.cc).
//
// Why no fleet (transpiler/fleet) with a lane for each change: compiling one takes 3 to 26 s for a sample before any
// change is in it, where all changes take 1 to 36 s here; and the control is asked lane by lane there, too, which is
// two fifths of what a scan of host50's sample takes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/changed_inst.h"

namespace plcxx::mutate {

enum class Ending : uint8_t { kPasses, kFails, kUnclear };

struct SideBySide {
  const compilation::Compilation& compilation;
  const scenarios::Scenario& scenario;
  const std::vector<sim::ChangedInst>& changes;
  uint64_t most = UINT64_MAX;                   // instructions; with more the scenario fails
  std::function<void(uint32_t change)> failed;  // at once, for who waits
};

/// By the number of the change.
std::vector<Ending> RunSideBySide(const SideBySide& request);

}  // namespace plcxx::mutate
