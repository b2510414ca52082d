#include "transpiler/dialects/technol/source/technology_items.h"

#include <algorithm>

#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {
namespace {

constexpr size_t kIntegerDigits = 5;
constexpr size_t kDecimals = 3;
constexpr uint32_t kSign = 0x80000000;

bool IsSign(char c) { return c == '+' || c == '-'; }

std::string_view WithoutSign(std::string_view text) {
  if (!text.empty() && IsSign(text.front())) text.remove_prefix(1);
  return text;
}

struct Parts {
  std::string_view integer, decimals;
};
Parts SplitDecimals(std::string_view digits) {
  const size_t point = digits.find('.');
  if (point == std::string_view::npos) return {digits, {}};
  return {digits.substr(0, point), digits.substr(point + 1)};
}

}  // namespace

bool IsItem(std::string_view text) {
  const auto [integer, decimals] = SplitDecimals(WithoutSign(text));
  return !(integer.empty() && decimals.empty()) && std::ranges::all_of(integer, IsDigit) &&
         std::ranges::all_of(decimals, IsDigit);
}

Item ReadItem(std::string_view text) {
  if (!IsItem(text)) {
    const auto sign = std::find_if(text.begin() + (text.empty() ? 0 : 1), text.end(), IsSign);
    const bool glued = sign != text.end() && IsItem({text.begin(), sign});
    return {.fault = glued ? ItemFault::kNotSeparated : ItemFault::kMalformed};
  }
  const auto [integer, decimals] = SplitDecimals(WithoutSign(text));
  if (integer.size() > kIntegerDigits || decimals.size() > kDecimals) return {.fault = ItemFault::kRange};
  uint32_t value = 0;
  for (const char digit : integer) value = value << 4 | static_cast<uint32_t>(digit - '0');
  for (size_t i = 0; i < kDecimals; ++i) {
    value = value << 4 | (i < decimals.size() ? static_cast<uint32_t>(decimals[i] - '0') : 0);
  }
  if ((value & kSign) != 0) return {.fault = ItemFault::kRange};  // the eighth digit is 8 or 9
  return {.value = text.front() == '-' && value != 0 ? value | kSign : value};
}

std::vector<std::string_view> SplitGlued(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!IsItem(text)) {
    const auto sign = std::find_if(text.begin() + (text.empty() ? 0 : 1), text.end(), IsSign);
    if (sign == text.end() || !IsItem({text.begin(), sign})) break;
    parts.emplace_back(text.begin(), sign);
    text.remove_prefix(static_cast<size_t>(sign - text.begin()));
  }
  parts.push_back(text);
  return parts;
}

}  // namespace plcxx::technol
