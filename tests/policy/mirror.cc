#include "tests/policy/mirror.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace plcxx::policy {
namespace {

namespace fs = std::filesystem;

std::string ParentOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

bool IsIn(const std::string& path, const std::string& folder) { return path.starts_with(folder + "/"); }

/// "tests/emit/print" is about "transpiler/emit/print", "tests/runtime_support" about "runtime_support".
std::optional<std::string> TestedBy(const std::string& root, const std::string& folder) {
  const std::string name = folder.substr(folder.find('/') + 1);
  const std::string tested = name.starts_with("runtime_support") ? name : "transpiler/" + name;
  return fs::is_directory(root + "/" + tested) ? std::optional(tested) : std::nullopt;
}

bool HasTests(const std::string& cmake_lists) {
  return cmake_lists.find("plcxx_test(") != std::string::npos || cmake_lists.find("add_test(") != std::string::npos;
}

/// The headers of the product that a test includes, itself or in headers of the tests.
void CollectIncludes(const std::string& root, const std::string& file, std::set<std::string>& seen,
                     std::set<std::string>& included) {
  if (!seen.insert(file).second || !fs::exists(root + "/" + file)) return;
  constexpr std::string_view kInclude = "#include \"";
  for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
    if (!line.starts_with(kInclude)) continue;
    const std::string name = line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size());
    if (name.starts_with("transpiler/")) {
      included.insert(name);
    } else if (name.starts_with("plcxx/") || name.starts_with("plcxx_host/")) {
      included.insert("runtime_support/" + name);
    } else if (name.starts_with("tests/")) {
      CollectIncludes(root, name, seen, included);
    }
  }
}

/// Whoever includes nothing of the product runs the tool, and may do so for any folder.
bool IsAbout(const std::string& root, const std::string& file, const std::string& tested) {
  std::set<std::string> seen, included;
  CollectIncludes(root, file, seen, included);
  for (const std::string& name : included) {
    if (IsIn(name, tested)) return true;
  }
  return included.empty();
}

class Exceptions {
 public:
  Exceptions(const std::string& text, Findings& findings) {
    for (const std::string& line : Lines(text)) {
      const std::vector<std::string> words = Words(line);
      if (words.empty() || words.front().starts_with('#')) continue;
      if (words.size() < 3) findings.push_back("mirror.txt: a reason is missing: " + line);
      used_[words.front()] = false;
    }
  }
  bool Have(const std::string& path) {
    for (auto& [name, used] : used_) {
      if (path != name && !IsIn(path, name)) continue;
      used = true;
      return true;
    }
    return false;
  }
  void ReportUnused(Findings& findings) const {
    for (const auto& [name, used] : used_) {
      if (!used) findings.push_back("mirror.txt: nothing is an exception by '" + name + "'; remove it");
    }
  }

 private:
  std::map<std::string, bool> used_;
};

}  // namespace

Findings CheckMirror(const std::string& root, const std::string& exceptions) {
  Findings findings;
  Exceptions allowed(exceptions, findings);
  for (const std::string& lists : FilesBelow(root, "tests", {"CMakeLists.txt"})) {
    const std::string folder = ParentOf(lists);
    if (folder == "tests" || !HasTests(ReadFile(root + "/" + lists))) continue;
    const std::optional<std::string> tested = TestedBy(root, folder);
    if (!tested.has_value() && !allowed.Have(folder)) {
      findings.push_back(folder + ": no folder of transpiler/ has this name; say in mirror.txt what it is about");
    }
  }
  for (const std::string& file : FilesBelow(root, "tests", {"_test.cc"})) {
    const std::optional<std::string> tested = TestedBy(root, ParentOf(file));
    if (!tested.has_value() || IsAbout(root, file, *tested) || allowed.Have(file)) continue;
    findings.push_back(file + ": includes nothing of " + *tested + "; it belongs to the folder that it tests");
  }
  allowed.ReportUnused(findings);
  return findings;
}

}  // namespace plcxx::policy
