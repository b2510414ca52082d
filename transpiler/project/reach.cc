#include "transpiler/project/reach.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

namespace plcxx::project {
namespace {

namespace fs = std::filesystem;

fs::path ProjectOf(const fs::path& folder) {
  for (fs::path at = folder;; at = at.parent_path()) {
    if (IsVersioned(at.string())) return at;
    if (at == at.parent_path()) break;
  }
  std::error_code error;
  const fs::path working = fs::weakly_canonical(fs::current_path(error), error);
  return !working.empty() && IsBelow(folder, working) ? working : folder;
}

}  // namespace

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool IsVersioned(const std::string& folder) {
  std::error_code error;
  return std::ranges::any_of(std::array{".git", ".hg", ".svn"},
                             [&](const char* mark) { return fs::exists(fs::path(folder) / mark, error); });
}

std::optional<std::string> OutsideOfProject(const std::string& file, const std::string& named) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(fs::path(file), error).parent_path(), error);
  const fs::path meant = fs::weakly_canonical(folder / named, error);
  if (error || named.find('\0') != std::string::npos) return folder.string();
  const fs::path project = ProjectOf(folder);
  if (IsBelow(meant, project)) return std::nullopt;
  return project.string();
}

std::string ReplayComment(const std::string& directory, std::span<const std::string> sources) {
  const std::string scenario = (fs::path(directory) / "scenario.yaml").string();
  const bool outside = std::any_of(sources.begin(), sources.end(), [&](const std::string& source) {
    return OutsideOfProject(scenario, source).has_value();
  });
  return outside ? "# The sources are in another project: plcxx test --allow-outside\n" : "";
}

}  // namespace plcxx::project
