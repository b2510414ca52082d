#include "transpiler/project/globs.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace plcxx::project {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kAnyFolders = "**";

class Expansion {
 public:
  bool Expand(const fs::path& opened, const std::string& relative, std::vector<std::string> parts) {
    if (parts.size() > 1 && parts.front() == kAnyFolders) {
      const std::vector<std::string> rest(parts.begin() + 1, parts.end());
      if (!Expand(opened, relative, rest)) return false;
      return ForEachName(opened, [&](const fs::directory_entry& entry, const std::string& name) {
        std::error_code error;
        if (name.starts_with('.') || entry.is_symlink(error) || !entry.is_directory(error)) return true;
        return Expand(entry.path(), relative + name + "/", parts);
      });
    }
    const std::string part = parts.front();
    parts.erase(parts.begin());
    if (!IsGlob(part)) {
      std::error_code error;
      const fs::path path = opened / part;
      if (parts.empty() && fs::is_regular_file(path, error)) found.push_back(relative + part);
      return parts.empty() || Expand(path, relative + part + "/", parts);
    }
    return ForEachName(opened, [&](const fs::directory_entry& entry, const std::string& name) {
      std::error_code error;
      if ((name.starts_with('.') && !part.starts_with('.')) || !MatchesName(name, part)) return true;
      if (parts.empty()) {
        if (entry.is_regular_file(error)) found.push_back(relative + name);
        return true;
      }
      return entry.is_symlink(error) || !entry.is_directory(error) ||
             Expand(entry.path(), relative + name + "/", parts);
    });
  }

  std::vector<std::string> found;

 private:
  template <class Function>
  bool ForEachName(const fs::path& folder, const Function& function) {
    std::error_code error;
    for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
         at.increment(error)) {
      if (++looked_at_ > kMaxNames) return false;
      if (!function(*at, at->path().filename().string())) return false;
    }
    return true;
  }

  size_t looked_at_ = 0;
};

}  // namespace

bool IsGlob(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

bool MatchesName(std::string_view name, std::string_view pattern) {
  size_t at = 0, in_pattern = 0, star = std::string_view::npos, after_star = 0;
  while (at < name.size()) {
    if (in_pattern < pattern.size() && pattern[in_pattern] == '*') {
      star = in_pattern++;
      after_star = at;
    } else if (in_pattern < pattern.size() && (pattern[in_pattern] == '?' || pattern[in_pattern] == name[at])) {
      ++in_pattern;
      ++at;
    } else if (star != std::string_view::npos) {
      in_pattern = star + 1;  // the star takes one more character
      at = ++after_star;
    } else {
      return false;
    }
  }
  while (in_pattern < pattern.size() && pattern[in_pattern] == '*') ++in_pattern;
  return in_pattern == pattern.size();
}

std::variant<std::vector<std::string>, std::string> ExpandGlob(const std::string& folder, const std::string& pattern) {
  std::vector<std::string> parts;
  size_t begin = 0;
  while (begin <= pattern.size()) {
    const size_t end = std::min(pattern.find('/', begin), pattern.size());
    const std::string part = pattern.substr(begin, end - begin);
    // Two such parts in a row mean what one does, and cost the square of it.
    const bool again = part == kAnyFolders && !parts.empty() && parts.back() == kAnyFolders;
    if (!part.empty() && part != "." && !again) parts.push_back(part);
    begin = end + 1;
  }
  if (pattern.starts_with('/')) return "a pattern is relative to the program's folder";
  if (parts.empty()) return "it names no file";
  Expansion expansion;
  if (!expansion.Expand(folder, "", parts)) {
    return "more than " + std::to_string(kMaxNames) + " names would have to be looked at";
  }
  std::ranges::sort(expansion.found);
  const auto [last, end] = std::ranges::unique(expansion.found);
  expansion.found.erase(last, end);
  return std::move(expansion.found);
}

}  // namespace plcxx::project
