#include "transpiler/dialects/common/dollar_hex.h"

#include <charconv>

namespace plcxx::dialects {

std::optional<uint64_t> DollarHex(std::string_view text) {
  constexpr size_t kMostDigits = 8;
  if (!text.starts_with('$')) return std::nullopt;
  text.remove_prefix(1);
  uint64_t value = 0;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  const bool whole = last == text.data() + text.size();
  if (text.empty() || text.size() > kMostDigits || error != std::errc() || !whole) return std::nullopt;
  return value;
}

}  // namespace plcxx::dialects
