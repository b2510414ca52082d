#include "transpiler/dialects/prostep/source/numbers.h"

#include <algorithm>
#include <limits>
#include <string>

#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {
namespace {

bool IsHexDigit(char c) { return IsDigit(c) || (c >= 'A' && c <= 'F'); }
uint32_t DigitValue(char c) { return static_cast<uint32_t>(IsDigit(c) ? c - '0' : c - 'A' + 10); }

/// Digits of base 10 or 16; a value above 32 bits stays above all limits.
uint64_t ValueOf(std::string_view digits, uint32_t base) {
  constexpr uint64_t kLarge = uint64_t{1} << 40;
  uint64_t value = 0;
  for (const char c : digits) value = std::min(value * base + DigitValue(c), kLarge);
  return value;
}

ConstantNumber Hexadecimal(std::string_view digits, uint32_t bytes) {
  ConstantNumber constant{.form = NumberForm::kHexadecimal};
  if (digits.empty() || !IsDigit(digits.front()) || !std::ranges::all_of(digits, IsHexDigit)) {
    constant.fault = NumberFault::kMalformed;
    return constant;
  }
  const uint64_t value = ValueOf(digits, 16);
  if (value >> (8 * bytes) != 0) constant.fault = NumberFault::kRange;
  constant.value = static_cast<uint32_t>(value);
  return constant;
}

ConstantNumber Bcd(std::string_view digits, uint32_t bytes) {
  ConstantNumber constant{.form = NumberForm::kBcd};
  if (digits.empty() || !std::ranges::all_of(digits, IsDigit)) {
    constant.fault = NumberFault::kMalformed;
    return constant;
  }
  if (digits.size() > size_t{2} * bytes) constant.fault = NumberFault::kRange;
  constant.value = static_cast<uint32_t>(ValueOf(digits, 16));
  return constant;
}

ConstantNumber Decimal(std::string_view text, uint32_t bytes) {
  ConstantNumber constant;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.empty() || !std::ranges::all_of(text, IsDigit)) {
    constant.fault = NumberFault::kMalformed;
    return constant;
  }
  const uint64_t value = ValueOf(text, 10);
  const uint64_t limit = uint64_t{1} << (8 * bytes);
  if (negative ? value > limit / 2 : value >= limit) constant.fault = NumberFault::kRange;
  constant.value = static_cast<uint32_t>(negative ? limit - value : value) & static_cast<uint32_t>(limit - 1);
  return constant;
}

}  // namespace

ConstantNumber ReadConstant(std::string_view text, uint32_t bytes) {
  const std::string upper = Upper(text);
  const std::string_view view = upper;
  // 'H' before 'D': 12DH is hexadecimal.
  if (view.ends_with('H')) return Hexadecimal(view.substr(0, view.size() - 1), bytes);
  if (view.ends_with('D')) return Bcd(view.substr(0, view.size() - 1), bytes);
  return Decimal(view, bytes);
}

uint32_t ReadDigits(std::string_view digits) {
  constexpr uint32_t kMost = std::numeric_limits<uint32_t>::max();
  const uint64_t value = ValueOf(digits, 10);
  return value > kMost ? kMost : static_cast<uint32_t>(value);
}

AddressNumber ReadAddress(std::string_view text) {
  AddressNumber address;
  const size_t dot = text.find('.');
  const std::string_view number = text.substr(0, dot);
  address.malformed = number.empty() || !std::ranges::all_of(number, IsDigit);
  if (!address.malformed) address.number = ReadDigits(number);
  if (dot == std::string_view::npos) return address;
  const std::string_view bit = text.substr(dot + 1);
  address.has_bit = true;
  if (bit.empty() || !std::ranges::all_of(bit, IsDigit)) {
    address.malformed = true;
    return address;
  }
  address.bit = ReadDigits(bit);
  address.malformed |= bit.size() > 1 && address.bit <= 7;  // one digit, no leading zeros
  return address;
}

bool IsBcd(uint16_t bits, BcdUse use) {
  const uint32_t greatest_in_front = use == BcdUse::kTime ? 3 : 0;
  return (bits & 15u) <= 9 && (bits >> 4 & 15u) <= 9 && (bits >> 8 & 15u) <= 9 && bits >> 12 <= greatest_in_front;
}

}  // namespace plcxx::prostep
