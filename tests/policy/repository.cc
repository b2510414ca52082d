#include "tests/policy/repository.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace plcxx::policy {
namespace {

bool IsLeftOut(const std::filesystem::path& relative) {
  const std::string name = relative.filename().string();
  if (name == ".git" || name.starts_with(".cache") || name == "__pycache__") return true;
  if (name == "node_modules" || relative == std::filesystem::path("editors/vscode/dist")) return true;  // npm's
  if (relative.parent_path().empty() && name.starts_with("build")) return true;
  return relative == std::filesystem::path("tests/policy/fixtures");
}

bool HasEnding(const std::string& path, const std::vector<std::string>& endings) {
  return endings.empty() ||
         std::ranges::any_of(endings, [&path](const std::string& ending) { return path.ends_with(ending); });
}

}  // namespace

const std::string& Root() {
  static const std::string root = [] {
    const char* copy = std::getenv("PLCXX_POLICY_ROOT");
    return std::string(copy != nullptr ? copy : PLCXX_ROOT);
  }();
  return root;
}

std::string Fixture(std::string_view name) { return Root() + "/tests/policy/fixtures/" + std::string(name); }

std::vector<std::string> FilesBelow(const std::string& root, std::string_view folder,
                                    const std::vector<std::string>& endings) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  const fs::path start = folder.empty() ? fs::path(root) : fs::path(root) / folder;
  if (!fs::exists(start)) return files;
  for (auto entry = fs::recursive_directory_iterator(start); entry != fs::recursive_directory_iterator(); ++entry) {
    const fs::path relative = entry->path().lexically_relative(root);
    if (IsLeftOut(relative)) {
      if (entry->is_directory()) entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && HasEnding(relative.string(), endings)) {
      files.push_back(relative.string());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::string> Lines(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> Words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

std::string Place(std::string_view file, size_t line) { return std::string(file) + ":" + std::to_string(line) + ": "; }

std::string Joined(const Findings& findings) {
  std::string text;
  for (const std::string& finding : findings) text += finding + "\n";
  return text;
}

}  // namespace plcxx::policy
