// The project that a file belongs to, and what is outside of it.
//
// Scenarios of strangers are run for merge requests: what they name must not be any file of the machine, whose lines
// the messages would print.
#pragma once

#include <optional>
#include <string>

namespace plcxx::driver {

/// `named` is a path in `file`, relative to its folder. None when it is inside of the project of `file`, symbolic links
/// followed; else the project's folder.
std::optional<std::string> OutsideOfProject(const std::string& file, const std::string& named);

}  // namespace plcxx::driver
