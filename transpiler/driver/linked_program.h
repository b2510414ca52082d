// Whether the program of a machine is the one that is here, and how its State is laid out then.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/emit/layout/layout.h"
#include "transpiler/link/target.h"

namespace plcxx::driver {

struct LinkedProgram {
  std::string difference;  // empty: it is this program
  emit::layout::Layout layout;
  debug_link::Target::Length length{};
};

/// `identity`: the 64 bytes that the machine has sent. Compared with what `plcxx emit` writes now: release and debug
/// flavour, for one's own host and for those of --host.
LinkedProgram MatchProgram(const compilation::Compilation& compilation, const std::vector<uint8_t>& identity);

}  // namespace plcxx::driver
