// Comparison of unsigned words.
//
// Implements NC110 6.5: [a<b] [a=b] [a>b] compare bytes as 0..255, whatever the program means by them (D4).
// Generated code spells these == < and >; the functions are for the simulator, which calls meanings by name.
#pragma once

#include <stdint.h>

namespace plcxx {

[[gnu::const]] constexpr bool Equal8(uint8_t a, uint8_t b) noexcept { return a == b; }
[[gnu::const]] constexpr bool Equal16(uint16_t a, uint16_t b) noexcept { return a == b; }
[[gnu::const]] constexpr bool Equal32(uint32_t a, uint32_t b) noexcept { return a == b; }
[[gnu::const]] constexpr bool Equal64(uint64_t a, uint64_t b) noexcept { return a == b; }

[[gnu::const]] constexpr bool Less8(uint8_t a, uint8_t b) noexcept { return a < b; }
[[gnu::const]] constexpr bool Less16(uint16_t a, uint16_t b) noexcept { return a < b; }
[[gnu::const]] constexpr bool Less32(uint32_t a, uint32_t b) noexcept { return a < b; }
[[gnu::const]] constexpr bool Less64(uint64_t a, uint64_t b) noexcept { return a < b; }

[[gnu::const]] constexpr bool Greater8(uint8_t a, uint8_t b) noexcept { return a > b; }
[[gnu::const]] constexpr bool Greater16(uint16_t a, uint16_t b) noexcept { return a > b; }
[[gnu::const]] constexpr bool Greater32(uint32_t a, uint32_t b) noexcept { return a > b; }
[[gnu::const]] constexpr bool Greater64(uint64_t a, uint64_t b) noexcept { return a > b; }

}  // namespace plcxx
