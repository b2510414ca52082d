#include "transpiler/source/find_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace plcxx::source {
namespace {

namespace fs = std::filesystem;

char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool SameLetters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return LowerCase(x) == LowerCase(y); });
}

/// The entry of `directory` that `part` means; empty when there is none.
std::string EntryOf(const fs::path& directory, const std::string& part) {
  std::error_code error;
  if (fs::exists(directory / part, error)) return part;
  std::string found;
  for (fs::directory_iterator entry(directory.empty() ? fs::path(".") : directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (SameLetters(name, part) && (found.empty() || name < found)) found = name;
  }
  return found;
}

}  // namespace

std::optional<std::string> FindFile(const std::string& directory, std::string_view name) {
  std::string slashes(name);
  std::ranges::replace(slashes, '\\', '/');
  const fs::path wanted(slashes);
  fs::path path = wanted.is_absolute() ? wanted.root_path() : fs::path(directory);
  for (const fs::path& part : wanted.relative_path()) {
    const std::string entry = part.empty() ? std::string() : EntryOf(path, part.string());
    if (entry.empty()) return std::nullopt;
    path /= entry;
  }
  std::error_code error;
  if (slashes.empty() || !fs::is_regular_file(path, error)) return std::nullopt;
  return path.string();
}

bool LeavesDirectory(std::string_view name) {
  std::string slashes(name);
  std::ranges::replace(slashes, '\\', '/');
  const fs::path path(slashes);
  return path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
}

bool LiesBelow(const std::string& path, const std::string& directory) {
  const fs::path file = FileIdentity(path), above = FileIdentity(directory.empty() ? "." : directory);
  const auto [in_above, in_file] = std::ranges::mismatch(above, file);
  return in_above == above.end() || in_above->empty();  // a '/' at its end is an empty part
}

std::string FileIdentity(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

}  // namespace plcxx::source
