// Addresses as they are written: "%I7", "%tm03.V" (specification 2.4, 2.6).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "transpiler/dialects/host50/machine/machine.h"

namespace plcxx::host50 {

enum class AddressFault : uint8_t { kNone, kArea, kNumber, kAttribute, kRange };

struct AddressText {
  AddressFault fault = AddressFault::kNone;
  Address address;  // meaningful without a fault
  Area area{};      // meaningful with kRange, too
};

/// `text` begins with '%'.
AddressText ReadAddressText(std::string_view text, uint32_t channels);

/// "Q", "v": kNone for anything else.
Attribute AttributeByName(std::string_view name);

/// "0 to 2000, 2500 to 4000".
std::string RangesOf(Area area, uint32_t channels);

}  // namespace plcxx::host50
