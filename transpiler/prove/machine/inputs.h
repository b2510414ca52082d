// What comes from outside: cells that have new values before every part of a period.
#pragma once

#include <vector>

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::machine {

/// By cell: inputs of the machine; memory that the host may write and that nothing of the period writes; memory that
/// routines write which the host calls when it likes (signals of an NC), whatever else writes it. What goes out and
/// nobody writes stays as it is.
std::vector<bool> InputsOf(const Version& version);
/// By cell: memory, but for what goes out, that routines write which the host calls when it likes; whatever else writes
/// it, it may have any value before a part.
std::vector<bool> SetByHost(const Version& version);
/// Whether a cell belongs to the text of the operator that has arrived last.
bool IsInbox(const Version& version, execute::CellId cell);

}  // namespace plcxx::prove::machine
