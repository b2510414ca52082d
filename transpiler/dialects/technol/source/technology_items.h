// The numbers of a technology table (specification 9.8.1, 9.8.2). Shared by the files of technology tables only.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace plcxx::technol {

/// Does `text` fit the grammar of an item, whatever its number of digits?
bool IsItem(std::string_view text);

enum class ItemFault : uint8_t { kNone, kMalformed, kNotSeparated, kRange };
struct Item {
  uint32_t value = 0;  // packed BCD with the sign in bit 31
  ItemFault fault = ItemFault::kNone;
};
Item ReadItem(std::string_view text);

/// "180.520-5.1" to its two items: before each sign that stands after a well-formed item. Anything else is one part.
std::vector<std::string_view> SplitGlued(std::string_view text);

}  // namespace plcxx::technol
