// A whole file as one text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace plcxx::support {

/// By its name a descriptor of this process, as a shell gives one for <(...): a pipe there has a writer, whereas to
/// open one by a name of its own may last for ever.
bool IsOpened(const std::filesystem::path& path);

/// Its bytes, as they are; none: there is no such file, or it cannot be read.
std::optional<std::string> ReadFile(const std::filesystem::path& path);

}  // namespace plcxx::support
