// Whether two calls of one host function are the same, as values in memory are: any two NaNs of a float are, for which
// sign and payload an operation gives is the processor's matter.
#pragma once

#include <cstdint>
#include <span>

#include "transpiler/ir/program.h"

namespace plcxx::sim {

bool SameArguments(const ir::HostFunction& function, std::span<const uint64_t> a, std::span<const uint64_t> b);

}  // namespace plcxx::sim
