// Comparison of words, unsigned and as two's complement.
//
// Implements NC110 6.5: [a<b] [a=b] [a>b] compare bytes as 0..255, whatever the program means by them (D4); PROSTEP
// 6.3 and FM 80-88; HOST50 6.5.
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

/// A word of 8 bits read as two's complement.
[[gnu::const]] constexpr int8_t S8(uint8_t value) noexcept { return static_cast<int8_t>(value); }
/// A word of 16 bits read as two's complement.
[[gnu::const]] constexpr int16_t S16(uint16_t value) noexcept { return static_cast<int16_t>(value); }
/// A word of 32 bits read as two's complement.
[[gnu::const]] constexpr int32_t S32(uint32_t value) noexcept { return static_cast<int32_t>(value); }

[[gnu::const]] constexpr bool NotEqual8(uint8_t a, uint8_t b) noexcept { return a != b; }
[[gnu::const]] constexpr bool LessEqual8(uint8_t a, uint8_t b) noexcept { return a <= b; }
[[gnu::const]] constexpr bool GreaterEqual8(uint8_t a, uint8_t b) noexcept { return a >= b; }
[[gnu::const]] constexpr bool SignedLess8(uint8_t a, uint8_t b) noexcept { return S8(a) < S8(b); }
[[gnu::const]] constexpr bool SignedLessEqual8(uint8_t a, uint8_t b) noexcept { return S8(a) <= S8(b); }
[[gnu::const]] constexpr bool SignedGreater8(uint8_t a, uint8_t b) noexcept { return S8(a) > S8(b); }
[[gnu::const]] constexpr bool SignedGreaterEqual8(uint8_t a, uint8_t b) noexcept { return S8(a) >= S8(b); }

[[gnu::const]] constexpr bool NotEqual16(uint16_t a, uint16_t b) noexcept { return a != b; }
[[gnu::const]] constexpr bool LessEqual16(uint16_t a, uint16_t b) noexcept { return a <= b; }
[[gnu::const]] constexpr bool GreaterEqual16(uint16_t a, uint16_t b) noexcept { return a >= b; }
[[gnu::const]] constexpr bool SignedLess16(uint16_t a, uint16_t b) noexcept { return S16(a) < S16(b); }
[[gnu::const]] constexpr bool SignedLessEqual16(uint16_t a, uint16_t b) noexcept { return S16(a) <= S16(b); }
[[gnu::const]] constexpr bool SignedGreater16(uint16_t a, uint16_t b) noexcept { return S16(a) > S16(b); }
[[gnu::const]] constexpr bool SignedGreaterEqual16(uint16_t a, uint16_t b) noexcept { return S16(a) >= S16(b); }

[[gnu::const]] constexpr bool NotEqual32(uint32_t a, uint32_t b) noexcept { return a != b; }
[[gnu::const]] constexpr bool LessEqual32(uint32_t a, uint32_t b) noexcept { return a <= b; }
[[gnu::const]] constexpr bool GreaterEqual32(uint32_t a, uint32_t b) noexcept { return a >= b; }
[[gnu::const]] constexpr bool SignedLess32(uint32_t a, uint32_t b) noexcept { return S32(a) < S32(b); }
[[gnu::const]] constexpr bool SignedLessEqual32(uint32_t a, uint32_t b) noexcept { return S32(a) <= S32(b); }
[[gnu::const]] constexpr bool SignedGreater32(uint32_t a, uint32_t b) noexcept { return S32(a) > S32(b); }
[[gnu::const]] constexpr bool SignedGreaterEqual32(uint32_t a, uint32_t b) noexcept { return S32(a) >= S32(b); }

[[gnu::const]] constexpr bool IsZero64(uint64_t value) noexcept { return value == 0; }

}  // namespace plcxx
