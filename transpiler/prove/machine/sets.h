// Which cells a statement may make 1 that were 0 before.
//
// A flag that the program only takes back (`R F 100.0`, `M = M & !RESET`), and that is 0 when power comes, would never
// be 1: somebody else sets it (a part program, a record of the control, a panel). In: an instruction that writes. Out:
// the cells that it may set. Not its job: who sets the others (inputs.h, diff/match.h).
#pragma once

#include <vector>

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::machine {

/// By RegionId: what the schedule executes, with all that is called there. A routine that only the host calls is the
/// host's: what it sets, somebody else sets.
std::vector<bool> ScheduledRegions(const ir::Program& program);
/// Of a store: the bits that its value may have where the place had none; all of a number that is given a value (the
/// step of a sequence is the program's own, although it never sets the high bits); of any other write all that it
/// touches.
std::vector<execute::CellId> CellsThatMayBeSet(const Version& version, const ir::Inst& inst, ir::PlaceId written);
/// Whether somebody else may set a cell that the program only takes back: internal memory that is 0 when power comes.
/// Outputs and signals to the control are the program's, as the control's manual says who else writes them.
bool MayBeSetByOthers(const Version& version, execute::CellId cell);

/// By cell: what the schedule, and all that it calls, sets; what it only takes back is set where nobody else may set
/// it. An index that may reach all of a space may reach signals of the host there, and says nothing about them.
std::vector<bool> SetCells(const Version& version);

/// Whether a cell is memory that the host may write, no matter what the program does with it.
bool MayBeSetByHost(const Version& version, execute::CellId cell);

}  // namespace plcxx::prove::machine
