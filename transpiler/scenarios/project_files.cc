#include "transpiler/scenarios/project_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace plcxx::scenarios {
namespace {

namespace fs = std::filesystem;

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

fs::path ProjectOf(const fs::path& folder) {
  std::error_code error;
  for (fs::path at = folder;; at = at.parent_path()) {
    for (const char* mark : {".git", ".hg", ".svn"}) {
      if (fs::exists(at / mark, error)) return at;
    }
    if (at == at.parent_path()) break;
  }
  const fs::path working = fs::weakly_canonical(fs::current_path(error), error);
  return !working.empty() && IsBelow(folder, working) ? working : folder;
}

}  // namespace

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

}  // namespace plcxx::scenarios
