// Bits that the program sets and the control takes back when it has done what they ask for.
//
// In the program they are cleared because of what a polled host function answers, or the control clears them in State,
// as the zones say. In a scenario no request is done by
// itself: clearing the bit is a step of it. So runs that look for something clear them now and then, as they set
// inputs. In: a program. Not its job: what the control does.
#pragma once

#include <vector>

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::machine {

/// By CellId: whether the cell is a request.
std::vector<bool> RequestCells(const Version& version);

}  // namespace plcxx::prove::machine
