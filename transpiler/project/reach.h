// The project that a file belongs to, and what is outside of it.
//
// Scenarios and projects of strangers are looked at for merge requests: what they name must not be any file of the
// machine, whose lines the messages would print.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace plcxx::project {

/// Which files a file may name: its project is the folder tree below the nearest folder that a version control system
/// manages, else below the working directory or, when the file is not there, below its own folder.
enum class Reach : uint8_t { kProject, kAnywhere };

/// Whether a version control system manages this very folder.
bool IsVersioned(const std::string& folder);

/// Is a path the folder or in it? Both without symbolic links, "." and "..".
bool IsBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

/// `named` is a path in `file`, relative to its folder. None when it is inside of the project of `file`, symbolic links
/// followed; else the project's folder.
std::optional<std::string> OutsideOfProject(const std::string& file, const std::string& named);

/// A comment for a scenario that the tool writes into `directory`: how to run it when `sources`, relative to that
/// folder, are in another project. Else nothing.
std::string ReplayComment(const std::string& directory, std::span<const std::string> sources);

}  // namespace plcxx::project
