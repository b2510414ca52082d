// Values of terms on samples: variables as programs have them, bits of every density, numbers that are small, large,
// anything, or near one of the constants that the terms are compared with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// By sample, then by root. The same terms give the same values.
std::vector<std::vector<uint64_t>> SampleValues(const Terms& terms, std::span<const TermId> roots, uint32_t samples);

}  // namespace plcxx::terms
