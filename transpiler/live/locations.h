// Locations and values as the user writes them, resolved against the program; what is wrong, in words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "transpiler/compilation/compilation.h"
#include "transpiler/ir/name_index.h"

namespace plcxx::live {

/// A location of the program of `names`, or why there is none. The caller keeps the index between questions.
std::variant<dialects::Location, std::string> FindLocation(const dialects::Dialect& dialect, const ir::NameIndex& names,
                                                           std::string_view name);

/// Why it cannot be forced; empty: it can.
std::string CannotBeForced(const compilation::Compilation& compilation, const dialects::Location& location);

/// The value that memory takes, or why the text is none for what is called `name`.
std::variant<uint64_t, std::string> FindValue(const compilation::Compilation& compilation, std::string_view name,
                                              const dialects::Location& location, std::string_view text);

}  // namespace plcxx::live
