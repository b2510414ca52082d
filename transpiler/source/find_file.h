// Files that sources name in whatever case, with either slash, as people did on systems that did not tell case.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plcxx::source {

/// The path of the file `name` below `directory` (empty: the current one; ignored where `name` is absolute). Each part
/// of `name` is taken as written when there is such an entry, else the first entry in the order of bytes that differs
/// in the case of ASCII letters only. '\' separates like '/'. None when there is no such file.
std::optional<std::string> FindFile(const std::string& directory, std::string_view name);

/// Does the name climb out of the directory that it is looked for in: by '..', or as an absolute one?
bool LeavesDirectory(std::string_view name);
/// Is the file below the directory (empty: the current one), whatever links and '..' the two paths have?
bool LiesBelow(const std::string& path, const std::string& directory);

/// The same text for every path to one file; the path itself when it cannot be told.
std::string FileIdentity(const std::string& path);

}  // namespace plcxx::source
