// The program of a machine against what `plcxx emit` writes of the one that is here.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/link/linked_program.h"

namespace plcxx::driver {

/// `identity`: the 64 bytes that the machine has sent. Compared with what `plcxx emit` writes now: release and debug
/// flavour, for one's own host and for those of --host.
debug_link::LinkedProgram MatchProgram(const compilation::Compilation& compilation,
                                       const std::vector<uint8_t>& identity);

}  // namespace plcxx::driver
