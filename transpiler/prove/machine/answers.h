// What the host answers and writes in the middle of a period, and which of it is no more than an input of the machine.
//
// A refresh asks the host port by port and stores what it gives in the image of the inputs: what is asked for there is
// the input. An exchange in the middle of a period finds the inputs as they are in the whole of it; only bits that the
// program sets, too, may be taken back by the control (handshakes). In: a program. Not its job: executing.
#pragma once

#include <map>
#include <vector>

#include "transpiler/prove/machine/version.h"

namespace plcxx::prove::machine {

/// By call: the input of the machine that the regular exchange fills with what this call gives.
std::map<ir::InstId, ir::PlaceId> FetchedInputs(const Version& version);

/// By cell: inputs that the program stores to by itself, beside what it fetches.
std::vector<bool> HandshakeCells(const Version& version);

/// Whether answers of the host can change what the program does: a period calls functions whose results are no inputs
/// or that write in the middle of it, or texts of the operator arrive.
bool AnswersMatter(const Version& version);

}  // namespace plcxx::prove::machine
