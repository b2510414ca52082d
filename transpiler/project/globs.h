// Patterns of file names: '*' and '?' within a name, '**' for any folders.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plcxx::project {

bool IsGlob(std::string_view text);

bool MatchesName(std::string_view name, std::string_view pattern);

/// The files below `folder` (empty: the current one) that match, sorted, relative to it; or why they cannot be found:
/// no pattern looks at more than so many names, and links to folders are not followed.
inline constexpr size_t kMaxNames = 20'000;
std::variant<std::vector<std::string>, std::string> ExpandGlob(const std::string& folder, const std::string& pattern);

}  // namespace plcxx::project
