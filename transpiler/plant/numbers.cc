#include "transpiler/plant/numbers.h"

#include <charconv>
#include <system_error>

namespace plcxx::plant {
namespace {

std::optional<int64_t> DigitsOf(std::string_view text, int base) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || text.front() == '-' || error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

}  // namespace

std::optional<int64_t> WholeNumber(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return DigitsOf(text.substr(2), 16);
  const bool is_negative = text.starts_with('-');
  const std::optional<int64_t> magnitude = DigitsOf(is_negative ? text.substr(1) : text, 10);
  if (!magnitude) return std::nullopt;
  return is_negative ? -*magnitude : *magnitude;
}

std::optional<int64_t> Thousandths(std::string_view text) {
  constexpr size_t kDecimals = 3;
  constexpr int64_t kMax = 1'000'000'000;
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  const size_t point = text.find('.');
  const std::optional<int64_t> whole = DigitsOf(text.substr(0, point), 10);
  if (!whole || *whole > kMax) return std::nullopt;
  int64_t value = *whole * 1000;
  if (point != std::string_view::npos) {
    const std::string_view decimals = text.substr(point + 1);
    std::optional<int64_t> part = DigitsOf(decimals, 10);
    if (!part || decimals.size() > kDecimals) return std::nullopt;
    for (size_t i = decimals.size(); i < kDecimals; ++i) *part *= 10;
    value += *part;
  }
  return is_negative ? -value : value;
}

std::optional<uint64_t> Milliseconds(std::string_view text) {
  uint64_t unit_ms = 1;
  for (const auto& [name, ms] : {std::pair<std::string_view, uint64_t>{"ms", 1}, {"min", 60'000}, {"s", 1000}}) {
    if (!text.ends_with(name)) continue;
    text.remove_suffix(name.size());
    unit_ms = ms;
    break;
  }
  while (text.ends_with(' ')) text.remove_suffix(1);
  const std::optional<int64_t> number = Thousandths(text);
  if (!number || *number < 0 || *number * static_cast<int64_t>(unit_ms) % 1000 != 0) return std::nullopt;
  const uint64_t ms = static_cast<uint64_t>(*number) * unit_ms / 1000;
  return ms > kMaxTimeMs ? std::nullopt : std::optional(ms);
}

}  // namespace plcxx::plant
