// "$1F": a hexadecimal number as some languages write it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace plcxx::dialects {

/// Up to 8 hexadecimal digits after the sign; none: the text is something else.
std::optional<uint64_t> DollarHex(std::string_view text);

}  // namespace plcxx::dialects
