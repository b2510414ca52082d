// Locations and values as scenarios and watch lists write them: operands, symbols, OPERATOR_TEXT (specification 4.4).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"

namespace plcxx::nc110 {

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);
/// A number of 2.5: 45, 45D, 55O, 2DH.
std::optional<uint64_t> ParseValue(std::string_view text);
/// Does a text without a telling file name look like this dialect?
bool Recognize(std::string_view text);

}  // namespace plcxx::nc110
