// Digits of base 16, and back.
//
// In: values. Out: digits without a prefix, the most significant one first. Not its job: "0x", signs, other bases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plcxx::support {

inline constexpr std::string_view kHexDigits = "0123456789abcdef";

enum class HexLetters : uint8_t { kSmall, kCapital };

/// The digits of a value, at least `least` of them: HexDigits(0x1F, 4) is "001f". `least` is 1 to 16.
std::string HexDigits(uint64_t value, size_t least = 1, HexLetters letters = HexLetters::kSmall);

/// The value of one digit, 0 to 15; letters are small ones only, as HexDigits writes them.
std::optional<uint8_t> HexValue(char digit);

}  // namespace plcxx::support
