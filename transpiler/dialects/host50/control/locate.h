// Locations and values as scenarios and watch lists write them: addresses with or without '%', symbols (section 5).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"

namespace plcxx::host50 {

/// "I0", "%q12", "TM3.V", "C1" (its .Q), "PUMP", "T_RUN.V", "'axis4-'". An address goes before a symbol of that name.
std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);
/// "$FF".
std::optional<uint64_t> ParseValue(std::string_view text);
/// Of an alarm, number 0 to 99; one without a text is called by its address.
std::string MessageText(const ir::Program& program, uint32_t number, const dialects::ImagePort& image);

}  // namespace plcxx::host50
