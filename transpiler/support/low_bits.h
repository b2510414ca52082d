// Masks of words.
#pragma once

#include <cstdint>

namespace plcxx::support {

/// All bits of a width, from bit 0 on: 0xFF of 8, everything of 64 and more.
constexpr uint64_t LowBits(uint32_t width) { return width >= 64 ? ~uint64_t{0} : (uint64_t{1} << width) - 1; }

}  // namespace plcxx::support
