#include "transpiler/support/hex.h"

#include <algorithm>

#include "transpiler/support/check.h"

namespace plcxx::support {

std::string HexDigits(uint64_t value, size_t least, HexLetters letters) {
  constexpr std::string_view kCapitals = "0123456789ABCDEF";
  PLCXX_CHECK(least >= 1 && least <= 16);
  const std::string_view alphabet = letters == HexLetters::kSmall ? kHexDigits : kCapitals;
  std::string digits;
  for (; value != 0 || digits.size() < least; value >>= 4) digits += alphabet[value & 15];
  std::ranges::reverse(digits);
  return digits;
}

std::optional<uint8_t> HexValue(char digit) {
  const size_t value = kHexDigits.find(digit);
  if (value == std::string_view::npos) return std::nullopt;
  return static_cast<uint8_t>(value);
}

}  // namespace plcxx::support
