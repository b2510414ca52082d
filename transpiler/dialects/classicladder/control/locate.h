// The locations that scenarios and watch lists name, and the values that they write.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"

namespace plcxx::classicladder {

/// None for what is no location.
std::optional<dialects::Location> Locate(const ir::NameIndex& names, std::string_view text);
/// A value in the dialect's own spelling; none when it is none.
std::optional<uint64_t> ParseValue(std::string_view text);

}  // namespace plcxx::classicladder
