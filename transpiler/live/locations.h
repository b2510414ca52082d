// Locations and values as the user writes them, resolved against the program; what is wrong, in words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "transpiler/compilation/compilation.h"

namespace plcxx::live {

/// A location, or why there is none.
std::variant<dialects::Location, std::string> FindLocation(const compilation::Compilation& compilation,
                                                           std::string_view name);

/// Why it cannot be forced; empty: it can.
std::string CannotBeForced(const compilation::Compilation& compilation, const dialects::Location& location);

/// The value that memory takes, or why the text is none.
std::variant<uint64_t, std::string> FindValue(const compilation::Compilation& compilation,
                                              const dialects::Location& location, std::string_view text);

}  // namespace plcxx::live
