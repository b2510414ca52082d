// A file that the command line names and that is no source: read, or told why not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plcxx::driver {

/// None: told as a usage error, with the cause, a file of a like name where there is one, and what was meant.
std::optional<std::string> ReadNamedFile(const std::string& path, std::string_view what_is_meant);

}  // namespace plcxx::driver
