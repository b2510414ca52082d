// The limits of plcxx build: what a machine's builder allows a partition.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/measure/figures.h"

namespace plcxx::measure {

struct BuildLimits {
  std::optional<uint64_t> fast_us, slow_us;  // of one call
  std::optional<uint64_t> stack_bytes;       // of every partition
  std::optional<uint64_t> code_bytes;        // of all code
};

/// "168MHz", "1.5 GHz", "32768": Hz; none when it is no frequency above 0.
std::optional<uint64_t> ParseClock(std::string_view text);

/// Reports what is above a limit, at the costliest statements; and what a limit was compared with but is not whole.
void CheckLimits(const BuildFigures& figures, const BuildLimits& limits, uint64_t clock_hz,
                 const emit::Emittable& emittable, compilation::Compilation& compilation);

}  // namespace plcxx::measure
