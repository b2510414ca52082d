#include "tests/policy/rows.h"

#include <map>

namespace plcxx::policy {
namespace {

/// "table FILE MACRO ENUM"; FILE is in the dialect's folder, or in its room machine/.
struct RowTable {
  std::string file, macro, enumeration;
  std::string Folder() const {
    const std::string folder = file.substr(0, file.rfind('/'));
    const std::string_view room = "/machine";
    return folder.ends_with(room) ? folder.substr(0, folder.size() - room.size()) : folder;
  }
};

/// The first arguments of `macro` at the begin of a line.
std::vector<std::string> KeysOf(const std::string& text, const std::string& macro) {
  std::vector<std::string> keys;
  for (const std::string& line : Lines(text)) {
    if (!line.starts_with(macro + "(")) continue;
    const size_t begin = macro.size() + 1;
    keys.push_back(line.substr(begin, line.find_first_of(",)", begin) - begin));
  }
  return keys;
}

bool IsWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// As a whole: "Op::kAnd" is not in "Op::kAndNot", nor in "ExprOp::kAnd".
bool Names(const std::string& text, const std::string& name) {
  for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const size_t end = at + name.size();
    if ((at == 0 || !IsWordCharacter(text[at - 1])) && (end == text.size() || !IsWordCharacter(text[end]))) return true;
  }
  return false;
}

/// "Call of transpiler/dialects/host50": where it is named.
std::map<std::string, std::vector<std::string>> NamedIn(const std::string& root, const RowTable& table) {
  std::map<std::string, std::vector<std::string>> found;
  const std::vector<std::string> keys = KeysOf(ReadFile(root + "/" + table.file), table.macro);
  for (const std::string& file : FilesBelow(root, table.Folder(), {".cc", ".h"})) {
    const std::string text = ReadFile(root + "/" + file);
    for (const std::string& key : keys) {
      if (Names(text, table.enumeration + "::k" + key)) found[key + " of " + table.Folder()].push_back(file);
    }
  }
  if (keys.empty()) found[table.file + " has no " + table.macro];
  return found;
}

}  // namespace

Findings CheckRows(const std::string& root, const std::string& rows) {
  std::vector<RowTable> tables;
  std::map<std::string, size_t> allowed;
  Findings findings;
  for (const std::string& line : Lines(rows)) {
    const std::vector<std::string> words = Words(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (words.size() == 4 && words.front() == "table") {
      tables.push_back({words[1], words[2], words[3]});
    } else if (words.size() == 3) {
      allowed[words[1] + " of " + words[0]] = std::stoul(words[2]);
    } else {
      findings.push_back("rows.txt: cannot be read: " + line);
    }
  }
  if (tables.empty()) findings.emplace_back("rows.txt: no table");
  for (const RowTable& table : tables) {
    for (const auto& [row, files] : NamedIn(root, table)) {
      if (files.empty()) findings.push_back(row);
      const auto exception = allowed.find(row);
      const size_t most = exception == allowed.end() ? 1 : exception->second;
      if (files.size() > most) {
        std::string text = row + ": named in " + std::to_string(files.size()) + " sources";
        for (const std::string& file : files) text += " " + file.substr(file.rfind('/') + 1);
        findings.push_back(text);
      } else if (exception != allowed.end() && files.size() < most) {
        findings.push_back(row + ": named in " + std::to_string(files.size()) + " sources; shorten rows.txt");
      }
      if (exception != allowed.end()) allowed.erase(exception);
    }
  }
  for (const auto& [row, most] : allowed) findings.push_back(row + ": has no row, or no name; remove it from rows.txt");
  return findings;
}

}  // namespace plcxx::policy
