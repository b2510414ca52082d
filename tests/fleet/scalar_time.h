// What a period of one machine costs in the generated C++, for comparison with a fleet.
//
// In: a program, and the bits that change now and then. The code is what users ship, compiled with -O2; calls of host
// functions are noted and answered with 0, as a fleet answers them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/compilation/compilation.h"

namespace plcxx::bench {

/// A bit of memory.
struct BitPlace {
  ir::SpaceId space;
  uint32_t offset = 0;
  uint8_t bit = 0;
};

/// Periods for which an input keeps its value.
inline constexpr uint32_t kPeriodsOfAnInput = 16;

/// Processor time of a period in ns, the least of several rounds of `periods`. `inputs` get random values in every
/// 16th period, `seen` get some before the first one. None: it cannot be compiled; standard error says why.
std::optional<double> ScalarNs(const compilation::Compilation& compilation, const std::vector<BitPlace>& seen,
                               const std::vector<BitPlace>& inputs, uint32_t periods);

}  // namespace plcxx::bench
