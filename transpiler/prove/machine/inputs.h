// What comes from outside: cells that have new values before every part of a period.
#pragma once

#include <vector>

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::machine {

/// By cell: what the control writes (inputs of the machine, signals of an NC), whatever else writes it, and memory that
/// the host may write and nothing of the program does, or that the program only takes back (Uses::sets). What the
/// control only clears is none (requests.h).
std::vector<bool> InputsOf(const Version& version);
/// Whether a cell belongs to the text of the operator that has arrived last.
bool IsInbox(const Version& version, execute::CellId cell);

}  // namespace plcxx::prove::machine
