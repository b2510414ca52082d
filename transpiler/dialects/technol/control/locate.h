// Locations as scenarios name them (specification 5.7): names of bits, cells and mechanisms, BYTE., WORD. and DWRD.
// with an address of section 3, without index registers.
#pragma once

#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"

namespace plcxx::technol {

std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);
/// A number of 2.4: 62, 0FFh, 1010b, 17q, 'T'.
std::optional<uint64_t> ParseValue(std::string_view text);

}  // namespace plcxx::technol
