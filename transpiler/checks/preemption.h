// May the fast part interrupt the slow part at any instruction? The check behind --preemptive.
//
// The contract of that use: the fast part (and every interrupt routine) runs from an interrupt, is not interrupted by
// the slow part, and all else of a period (time, images, retentive memory) runs in the background with the interrupt
// off. Then a place that both parts use is safe when one of them alone writes it, no write of the one changes a byte
// that the other writes, each access of the slow part is one aligned load or store of at most 32 bits, and the slow
// part reads or writes it at most once in a pass: what is read again could have changed, and what is overwritten could
// have been seen. A state instance belongs to one part; the slow part may read a field of one that the fast part runs,
// under these rules. Guaranteed is each value, not that two values read one after the other are of the same execution
// of the fast part. In: a structured program, and where its places are stored. Out: an error for each place that is not
// safe, at the slow part's statement, with the fast part's as a note. Not its job: the layout, host functions that both
// parts call.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/ir/program.h"

namespace plcxx::checks {

/// How generated code keeps one place.
struct StoredPlace {
  uint32_t offset = 0;  // first byte of State
  uint32_t bytes = 0;   // that a write writes, a bit's neighbours with it; 0: not in State
  uint32_t pieces = 1;  // loads or stores of one access
};

/// `stored` by PlaceId. By PlaceId, too: whether both parts use the place, and one of them writes it. The program is
/// safe when nothing was reported.
std::vector<bool> CheckPreemption(const ir::Program& program, const std::vector<StoredPlace>& stored,
                                  diag::Engine& diagnostics);

}  // namespace plcxx::checks
