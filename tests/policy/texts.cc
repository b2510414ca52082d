#include "tests/policy/texts.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <string_view>
#include <vector>

namespace plcxx::policy {
namespace {

struct Pattern {
  const char* what;
  std::regex regex;
  /// A line with none of these has no match, and std::regex is slow; empty: each line is looked at.
  std::vector<std::string_view> one_of = {};
};

bool MayMatch(const Pattern& pattern, std::string_view line) {
  return pattern.one_of.empty() || std::ranges::any_of(pattern.one_of, [line](std::string_view part) {
           return line.find(part) != std::string_view::npos;
         });
}

void CheckLines(const std::string& root, const std::string& file, const std::vector<Pattern>& patterns,
                Findings& findings) {
  const std::string text = ReadFile(root + "/" + file);
  if (text.find('\0') != std::string::npos) return;
  size_t number = 0;
  for (const std::string& line : Lines(text)) {
    ++number;
    if (line.size() > 4000) continue;  // std::regex recurses; texts of people have no such lines
    std::smatch match;
    for (const Pattern& pattern : patterns) {
      if (MayMatch(pattern, line) && std::regex_search(line, match, pattern.regex)) {
        findings.push_back(Place(file, number) + pattern.what + " '" + match.str() + "'");
      }
    }
  }
}

/// What is after the "//" of a line, but for one in a literal.
std::string_view CommentOf(std::string_view line) {
  for (size_t at = line.find("//"); at != std::string_view::npos; at = line.find("//", at + 1)) {
    if (std::ranges::count(line.substr(0, at), '"') % 2 == 0) return line.substr(at + 2);
  }
  return {};
}

/// Such as "solver.h" and "prove/diff/compare.h"; what is written with a placeholder, or as a compiler's own, is none.
std::vector<std::string_view> SourcesNamedIn(std::string_view comment) {
  const auto is_of_name = [](char c) {
    return std::islower(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/';
  };
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::vector<std::string_view> names;
  for (const std::string_view ending : {".h", ".cc", ".def"}) {
    for (size_t at = comment.find(ending); at != std::string_view::npos; at = comment.find(ending, at + 1)) {
      const size_t end = at + ending.size();
      size_t begin = at;
      while (begin > 0 &&
             (is_of_name(comment[begin - 1]) || std::isdigit(static_cast<unsigned char>(comment[begin - 1]))))
        --begin;
      const bool is_cut =
          begin > 0 && std::string_view("<>*$\"{}-.").find(comment[begin - 1]) != std::string_view::npos;
      const bool is_name =
          begin < at && comment[begin] != '/' && !is_cut && (begin == 0 || !is_word(comment[begin - 1]));
      if (is_name && (end == comment.size() || !is_word(comment[end])))
        names.push_back(comment.substr(begin, end - begin));
    }
  }
  return names;
}

}  // namespace

Findings CheckGenerated(const std::string& root) {
  const std::vector<Pattern> patterns = {
      {"date", std::regex("\\b20[0-9]{2}-[0-9]{2}-[0-9]{2}\\b|__DATE__|__TIME__")},
      {"path", std::regex("(^|[\\s\"'(])/(work|home|root|tmp|usr|var|opt|mnt|build)/|__FILE__|\\.\\./")},
      {"version", std::regex("plcxx[ -]v?[0-9]+\\.[0-9]|\\bversion [0-9]+\\.", std::regex::icase)},
      {"line number", std::regex("#line|__LINE__|\\.(plc|sym|lst):[0-9]|// .*\\bline [0-9]+\\b", std::regex::icase)},
  };
  Findings findings;
  for (const std::string& file : FilesBelow(root, "samples", {".hpp", ".cpp"})) {
    CheckLines(root, file, patterns, findings);
  }
  return findings;
}

Findings CheckPrivate(const std::string& root) {
  // Written in pieces, because this file is checked as well.
  const std::vector<Pattern> patterns = {
      {"path of a machine",
       std::regex("(^|[^\\w./])/(wo"
                  "rk|ho"
                  "me/[a-z]|ro"
                  "ot/|t"
                  "mp/[bg]-)"),
       {"/wo", "/ho", "/ro", "/t"}},
      {"e-mail address", std::regex("[A-Za-z0-9._%+-]+@[A-Za-z0-9-]+(\\.[A-Za-z0-9-]+)*\\.[A-Za-z]{2,}"), {"@"}},
      {"registry",
       std::regex("pypi\\.or"
                  "g|registry\\.npm|deb\\.deb"
                  "ian|proxy\\.gol"
                  "ang|crates\\.i"
                  "o|artifac"
                  "tory|packages\\.micro"
                  "soft"),
       {"pypi", "registry", "deb", "proxy", "crates", "artifac", "packages"}},
  };
  Findings findings;
  for (const std::string& file : FilesBelow(root, "")) CheckLines(root, file, patterns, findings);
  return findings;
}

Findings CheckNamedFiles(const std::string& root) {
  // A name with a placeholder, `tests/golden/<d>`, stands for several.
  const std::regex named("`((transpiler|tests|runtime_support|docs|samples|grammars|cmake|dev)/[A-Za-z0-9_./-]+)`");
  Findings findings;
  size_t found = 0;
  for (const std::string& file : FilesBelow(root, "", {".md"})) {
    if (file.starts_with("build") || file.find("/fixtures/") != std::string::npos) continue;
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      if (line.size() > 4000) continue;
      for (std::sregex_iterator at(line.begin(), line.end(), named), end; at != end; ++at) {
        ++found;
        if (!std::filesystem::exists(root + "/" + (*at)[1].str())) {
          findings.push_back(Place(file, number) + "there is no '" + (*at)[1].str() + "'");
        }
      }
    }
  }
  if (found == 0) findings.push_back("no document names a file");
  return findings;
}

Findings CheckNamedSources(const std::string& root) {
  std::set<std::string, std::less<>> ends;  // of the paths of all files
  for (const std::string& file : FilesBelow(root, "")) {
    for (size_t at = 0; at != std::string::npos; at = file.find('/', at)) {
      at += at == 0 ? 0 : 1;
      ends.insert(file.substr(at));
    }
  }
  Findings findings;
  size_t found = 0;
  for (const char* folder : {"transpiler", "runtime_support", "tests"}) {
    for (const std::string& file : FilesBelow(root, folder, {".h", ".cc", ".def"})) {
      if (file.starts_with("tests/golden/")) continue;
      size_t number = 0;
      for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
        ++number;
        for (const std::string_view name : SourcesNamedIn(CommentOf(line))) {
          ++found;
          if (!ends.contains(name)) findings.push_back(Place(file, number) + "there is no '" + std::string(name) + "'");
        }
      }
    }
  }
  if (found == 0) findings.push_back("no comment names a source");
  return findings;
}

Findings CheckNamedFolders(const std::string& root) {
  const std::string text = ReadFile(root + "/CONTRIBUTING.md");
  std::set<std::string> folders;
  for (const std::string& file : FilesBelow(root, "transpiler")) {
    const size_t begin = file.find('/') + 1, end = file.find('/', begin);
    if (end != std::string::npos) folders.insert(file.substr(0, end));
  }
  Findings findings;
  for (const std::string& folder : folders) {
    const bool is_named =
        text.find('`' + folder + '`') != std::string::npos || text.find('`' + folder + '/') != std::string::npos;
    if (!is_named) findings.push_back("CONTRIBUTING.md does not say what " + folder + " is");
  }
  if (folders.empty()) findings.push_back("there are no folders");
  return findings;
}

Findings CheckShownFiles(const std::string& root) {
  const std::regex shown("^```[^`]* file=(\\S+)");
  Findings findings;
  size_t found = 0;
  for (const std::string& file : FilesBelow(root, "", {".md"})) {
    if (file != "README.md" && !file.starts_with("docs/")) continue;
    std::string paragraph;  // the last one that ended
    bool inside = false, ended = true;
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      if (line.starts_with("```")) {
        std::smatch match;
        if (!inside && std::regex_search(line, match, shown)) {
          ++found;
          if (paragraph.find(match[1].str()) == std::string::npos)
            findings.push_back(Place(file, number) + "nothing above says that this is '" + match[1].str() + "'");
        }
        inside = !inside;
        paragraph.clear();
        ended = true;
      } else if (!inside && line.empty()) {
        ended = true;
      } else if (!inside) {
        paragraph = ended ? line : paragraph + "\n" + line;
        ended = false;
      }
    }
  }
  if (found == 0) findings.push_back("no document shows a file");
  return findings;
}

Findings CheckSecurity(const std::string& root) {
  const std::regex used("add_subcommand\\(\"([a-z]+)\"|(?:getenv|EnvironmentValue)\\(\"([A-Z_]+)\"");
  const std::string page = ReadFile(root + "/docs/security.md");
  Findings findings;
  size_t found = 0;
  for (const std::string& file : FilesBelow(root, "transpiler", {".cc"})) {
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      std::smatch match;
      if (line.find('"') == std::string::npos || !std::regex_search(line, match, used)) continue;
      ++found;
      const std::string name = match[1].matched ? match[1].str() : match[2].str();
      if (page.find("`" + name + "`") == std::string::npos && page.find("`" + name + " -") == std::string::npos)
        findings.push_back(Place(file, number) + "docs/security.md does not name '" + name + "'");
    }
  }
  if (found == 0) findings.push_back("there are no commands");
  return findings;
}

}  // namespace plcxx::policy
