#include "tests/policy/sources.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <set>

namespace plcxx::policy {
namespace {

constexpr size_t kQuestioned = 400;
constexpr size_t kRefused = 600;

std::vector<std::string> CppFiles(const std::string& root) {
  std::vector<std::string> all;
  for (const char* folder : {"transpiler", "runtime_support", "tests"}) {
    for (std::string& file : FilesBelow(root, folder, {".cc", ".h"})) {
      // Headers of machine programs are no C++, and what plcxx printed of programs is formatted by plcxx.
      const bool beside_a_program = file.starts_with("tests/golden/") && std::ranges::count(file, '/') > 2;
      if (!beside_a_program) all.push_back(std::move(file));
    }
  }
  return all;
}

/// Without comments and the contents of strings, line by line; inclusions are left out.
std::string CodeOf(const std::string& line) {
  std::string code;
  char quote = 0;
  for (size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == '\\') {
        ++i;
      } else if (line[i] == quote) {
        quote = 0;
      }
      continue;
    }
    if (line.compare(i, 2, "//") == 0) break;
    if (line[i] == '"' || line[i] == '\'') quote = line[i];
    code += line[i];
  }
  return code.starts_with("#include") ? std::string() : code;
}

/// "helper", "utils" or "manager" in it, as a word of the name; empty when there is none.
std::string VagueWord(const std::string& name) {
  // The source manager is what compilers call the owner of files and positions: a term, not a way out.
  static const std::set<std::string> kTerms = {"SourceManager", "sourcemanager"};
  // Functions of Clang's, such as getSourceManager, createFileManager.
  if (kTerms.contains(name) || name.ends_with("SourceManager") || name.ends_with("FileManager")) return {};
  std::string lower;
  for (const char c : name) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* word : {"utils", "util_", "_util", "helper", "manager"}) {
    if (lower.find(word) != std::string::npos) return word;
  }
  return lower == "util" ? lower : std::string();
}

Findings RunClangFormat(const std::string& root, const std::vector<std::string>& files) {
  std::string command = "cd '" + root + "' && clang-format-19 --dry-run -Werror";
  for (const std::string& file : files) command += " '" + file + "'";
  Findings findings;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {"clang-format-19 cannot be started"};
  std::string output;
  char piece[4096];
  for (size_t n = 0; (n = fread(piece, 1, sizeof piece, pipe)) > 0;) output.append(piece, n);
  const int status = pclose(pipe);
  for (const std::string& line : Lines(output)) {
    const bool failed = line.find("not found") != std::string::npos;
    if (!failed && line.find("error:") == std::string::npos) continue;
    const std::string place = failed ? line : line.substr(0, line.find(':', line.find(':') + 1));
    const std::string file = place.substr(0, place.find(':'));
    if (findings.empty() || !findings.back().starts_with(file + ":")) findings.push_back(place + ": not formatted");
  }
  if (status != 0 && findings.empty()) findings.push_back("clang-format-19 failed: " + output);
  return findings;
}

}  // namespace

Findings CheckSizes(const std::string& root, Findings& to_question) {
  Findings findings;
  for (const std::string& file : CppFiles(root)) {
    const size_t lines = Lines(ReadFile(root + "/" + file)).size();
    const std::string finding = file + ": " + std::to_string(lines) + " lines";
    if (lines > kRefused) {
      findings.push_back(finding);
    } else if (lines > kQuestioned) {
      to_question.push_back(finding);
    }
  }
  return findings;
}

Findings CheckNames(const std::string& root) {
  Findings findings;
  for (const std::string& file : CppFiles(root)) {
    const std::string name = file.substr(file.rfind('/') + 1);
    if (!VagueWord(name).empty()) findings.push_back(file + ": the file's name says '" + VagueWord(name) + "'");
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      std::string identifier;
      for (const char c : CodeOf(line) + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
          identifier += c;
          continue;
        }
        if (!VagueWord(identifier).empty()) findings.push_back(Place(file, number) + "'" + identifier + "'");
        identifier.clear();
      }
    }
  }
  return findings;
}

Findings CheckDefaults(const std::string& root) {
  Findings findings;
  for (const std::string& file : CppFiles(root)) {
    if (file.starts_with("tests/")) continue;
    bool is_ours = false;
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      const std::string code = CodeOf(line);
      if (const size_t label = code.find("case ");
          label != std::string::npos && code.find(':', label) != std::string::npos) {
        is_ours = code.find("::k", label) != std::string::npos;
      }
      if (is_ours && code.find("default:") != std::string::npos) {
        findings.push_back(Place(file, number) + "'default:' over an enum of ours; spell its enumerators");
      }
    }
  }
  return findings;
}

Findings CheckFormat(const std::string& root) {
  // Two at once: small enough for a laptop, and the files are many.
  std::vector<std::string> halves[2];
  size_t next = 0;
  for (std::string& file : CppFiles(root)) halves[next++ % 2].push_back(std::move(file));
  if (halves[0].empty()) return {"no files"};
  auto other =
      std::async(std::launch::async, [&] { return halves[1].empty() ? Findings() : RunClangFormat(root, halves[1]); });
  Findings findings = RunClangFormat(root, halves[0]);
  for (std::string& finding : other.get()) findings.push_back(std::move(finding));
  std::ranges::sort(findings);
  return findings;
}

Findings CheckLeftovers(const std::string& root) {
  Findings findings;
  for (const std::string& file : FilesBelow(root, "tests", {".cc", ".h"})) {
    if (file == "tests/temporary_directory.h" || file.starts_with("tests/policy/sources")) continue;
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      for (const char* word : {"TempDir(", "temp_directory_path(", "mkdtemp(", "mkstemp(", "tmpnam(", "\"/tmp"}) {
        if (line.find(word) != std::string::npos) {
          findings.push_back(Place(file, number) + "'" + word + "': use tests/temporary_directory.h");
        }
      }
    }
  }
  return findings;
}

Findings CheckScripts(const std::string& root) {
  namespace fs = std::filesystem;
  Findings findings;
  size_t found = 0;
  for (const std::string& file : FilesBelow(root, "")) {
    char start[2] = {};
    if (!std::ifstream(root + "/" + file, std::ios::binary).read(start, 2) || start[0] != '#' || start[1] != '!')
      continue;
    ++found;
    if ((fs::status(root + "/" + file).permissions() & fs::perms::owner_exec) == fs::perms::none)
      findings.push_back(Place(file, 1) + "not executable");
  }
  if (found == 0) findings.push_back("there are no scripts");
  return findings;
}

}  // namespace plcxx::policy
