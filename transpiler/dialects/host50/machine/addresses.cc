#include "transpiler/dialects/host50/machine/addresses.h"

namespace plcxx::host50 {

Attribute AttributeByName(std::string_view name) {
  if (name.size() != 1) return Attribute::kNone;
  switch (Upper(name.front())) {
    case 'Q':
      return Attribute::kQ;
    case 'V':
      return Attribute::kV;
    case 'P':
      return Attribute::kP;
    default:
      return Attribute::kNone;
  }
}

AddressText ReadAddressText(std::string_view text, uint32_t channels) {
  size_t letters = 1;
  while (letters < text.size() && IsLetter(text[letters])) ++letters;
  const auto area = AreaByName(text.substr(1, letters - 1));
  if (!area) return {.fault = AddressFault::kArea};
  size_t digits = letters;
  uint32_t number = 0;
  while (digits < text.size() && IsDigit(text[digits]) && digits - letters <= kMostAddressDigits) {
    number = number * 10 + static_cast<uint32_t>(text[digits++] - '0');
  }
  if (digits == letters || digits - letters > kMostAddressDigits) return {.fault = AddressFault::kNumber};
  AddressText result{.address = {.area = *area, .number = static_cast<uint16_t>(number)}, .area = *area};
  const std::string_view rest = text.substr(digits);
  if (!rest.empty()) {
    const Type type = Info(*area).type;
    const bool has_attributes = type == Type::kTimer || type == Type::kCounter;
    if (rest.front() != '.') return {.fault = AddressFault::kNumber};
    result.address.attribute = AttributeByName(rest.substr(1));
    if (!has_attributes || result.address.attribute == Attribute::kNone) return {.fault = AddressFault::kAttribute};
  }
  if (!Exists(*area, number, channels)) result.fault = AddressFault::kRange;
  return result;
}

std::string RangesOf(Area area, uint32_t channels) {
  const AreaInfo& info = Info(area);
  uint32_t last = info.common_last;
  std::string text = "0 to ";
  for (uint32_t k = 0; k < channels && info.channel_step != 0; ++k) {
    const uint32_t first = info.channel_first + info.channel_step * k;
    if (first > last + 1) text += std::to_string(last) + ", " + std::to_string(first) + " to ";
    last = info.channel_last + info.channel_step * k;
  }
  return text + std::to_string(last);
}

}  // namespace plcxx::host50
