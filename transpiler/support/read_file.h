// A whole file as one text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace plcxx::support {

/// Its bytes, as they are; none: there is no such file, or it cannot be read.
std::optional<std::string> ReadFile(const std::filesystem::path& path);

}  // namespace plcxx::support
