#include "transpiler/source/near_file.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "transpiler/support/near_words.h"

namespace plcxx::source {

/// near.
std::string DidYouMeanFile(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr size_t kMostNames = 1000;
  const fs::path wanted(path);
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  std::vector<std::string> names, of_stem;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMostNames;
       at.increment(error)) {
    if (!at->is_regular_file(error)) continue;
    names.push_back(at->path().filename().string());
    if (at->path().stem() == wanted.stem()) of_stem.push_back(names.back());
  }
  const std::string name = wanted.filename().string();
  std::string near(support::NearestName(name, std::vector<std::string_view>(names.begin(), names.end())));
  if (near.empty() && of_stem.size() == 1) near = of_stem.front();
  if (near.empty()) return {};
  return ", did you mean '" + (wanted.parent_path() / near).generic_string() + "'";
}

}  // namespace plcxx::source
