#include "tests/policy/namespaces.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "tests/policy/tokens.h"

namespace plcxx::policy {
namespace {

enum class Scope : uint8_t { kNamespace, kNameless, kOther };

struct Definition {
  std::string name;  // "plcxx::prove::Version"
  std::string place;
};

struct FileNames {
  std::vector<Definition> types;
  std::vector<Definition> local_functions;  // of namespaces without a name, as if that one had none
  std::set<std::string> namespaces;         // those with a name that hold anything
};

/// Follows the braces of one file.
class NameReader {
 public:
  NameReader(const std::string& file, std::vector<Token> tokens) : file_(file), tokens_(std::move(tokens)) {}

  FileNames Read() {
    for (at_ = 0; at_ < tokens_.size();) {
      const std::string& word = tokens_[at_].text;
      if (word == "namespace") {
        Namespace();
      } else if (AtNamespaceScope() && (word == "class" || word == "struct" || word == "union" || word == "enum")) {
        Type();
      } else if (word == "{") {
        NoteUse();
        Open(Scope::kOther, {});
      } else if (word == "}") {
        if (!scopes_.empty()) scopes_.pop_back();
        ++at_;
      } else {
        NoteUse();
        if (word == "(") NoteLocalFunction();
        ++at_;
      }
    }
    return std::move(found_);
  }

 private:
  struct Level {
    Scope scope;
    std::string name;
  };

  bool AtNamespaceScope() const {
    return std::ranges::all_of(scopes_, [](const Level& level) { return level.scope == Scope::kNamespace; });
  }
  std::string Qualified() const {
    std::string name;
    for (const Level& level : scopes_) {
      if (level.scope == Scope::kNamespace) name += (name.empty() ? "" : "::") + level.name;
    }
    return name;
  }
  void NoteUse() {
    if (!scopes_.empty() && scopes_.back().scope == Scope::kNamespace) found_.namespaces.insert(Qualified());
  }
  void Open(Scope scope, std::string name) {
    scopes_.push_back({scope, std::move(name)});
    ++at_;
  }

  /// `namespace a::b {`, `namespace {`; an alias opens nothing.
  void Namespace() {
    std::string name;
    for (++at_; at_ < tokens_.size() && tokens_[at_].text != "{" && tokens_[at_].text != ";"; ++at_) {
      if (tokens_[at_].text == "=") return;
      name += tokens_[at_].text;
    }
    if (at_ < tokens_.size() && tokens_[at_].text == "{")
      Open(name.empty() ? Scope::kNameless : Scope::kNamespace, name);
  }

  /// `struct Name ... {` defines, `struct Name;` and `struct Name* function(` do not.
  void Type() {
    const bool in_template = at_ > 0 && (tokens_[at_ - 1].text == "<" || tokens_[at_ - 1].text == ",");
    const size_t line = tokens_[at_].line;
    std::string name;
    for (++at_; at_ < tokens_.size(); ++at_) {
      const std::string& text = tokens_[at_].text;
      if (text == "class" || text == "struct" || text == "alignas" || text == "[" || text == "]" ||
          text == "nodiscard") {
        continue;
      }
      // `struct Outer::Inner` is a type inside of another one.
      if (text == "::" && !name.empty()) {
        name += text;
        continue;
      }
      if (!IsWord(text.front())) break;
      if (text != "final") name = name.ends_with("::") ? name + text : text;
    }
    if (in_template || name.empty()) return;
    if (at_ < tokens_.size() && tokens_[at_].text == "<") return;  // a specialization is another type
    while (at_ < tokens_.size() && tokens_[at_].text != "{" && tokens_[at_].text != ";" && tokens_[at_].text != "(" &&
           tokens_[at_].text != "=" && tokens_[at_].text != ")" && tokens_[at_].text != "}") {
      ++at_;
    }
    if (at_ == tokens_.size() || tokens_[at_].text != "{") return;
    NoteUse();
    found_.types.push_back({Qualified() + "::" + name, Place(file_, line)});
    Open(Scope::kOther, {});
  }

  const std::string& TextAt(size_t at) const {
    static const std::string kNothing;
    return at < tokens_.size() ? tokens_[at].text : kNothing;
  }

  /// `Type Name(...) ... {` in a namespace without a name. A member that is defined outside its class is none.
  void NoteLocalFunction() {
    const auto is_namespace = [](const Level& level) { return level.scope != Scope::kOther; };
    if (scopes_.empty() || scopes_.back().scope != Scope::kNameless || !std::ranges::all_of(scopes_, is_namespace))
      return;
    if (at_ < 2 || !IsWord(TextAt(at_ - 1).front())) return;
    const std::string& before = TextAt(at_ - 2);
    if (!IsWord(before.front()) && before != ">" && before != "*" && before != "&") return;
    size_t end = at_, depth = 0;
    do {
      depth += TextAt(end) == "(" ? 1 : 0;
      depth -= TextAt(end) == ")" ? 1 : 0;
      ++end;
    } while (end < tokens_.size() && depth != 0);
    while (end < tokens_.size() && TextAt(end) != "{" && TextAt(end) != ";" && TextAt(end) != "=" && TextAt(end) != ",")
      ++end;
    if (TextAt(end) != "{") return;
    found_.local_functions.push_back({Qualified() + "::" + TextAt(at_ - 1), Place(file_, tokens_[at_].line)});
  }

  const std::string& file_;
  std::vector<Token> tokens_;
  size_t at_ = 0;
  std::vector<Level> scopes_;
  FileNames found_;
};

FileNames NamesOf(const std::string& root, const std::string& file) {
  return NameReader(file, TokensOf(ReadFile(root + "/" + file))).Read();
}

std::string FolderOf(const std::string& file) { return file.substr(0, file.rfind('/')); }

}  // namespace

Findings CheckDefinedOnce(const std::string& root) {
  std::map<std::string, std::string> places;
  Findings findings;
  for (const std::string& file : FilesBelow(root, "transpiler", {".cc", ".h"})) {
    for (const Definition& type : NamesOf(root, file).types) {
      const auto [first, is_new] = places.emplace(type.name, type.place);
      if (!is_new) findings.push_back(type.place + type.name + " is also defined at " + first->second);
    }
  }
  if (places.empty()) findings.emplace_back("no type is defined anywhere: the rule looks at nothing");
  return findings;
}

Findings CheckLocalFunctions(const std::string& root) {
  std::set<std::string> alone;
  for (const std::string& file : FilesBelow(root, "transpiler", {"CMakeLists.txt"})) {
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      constexpr std::string_view kAlone = "plcxx_alone(";
      if (!line.starts_with(kAlone)) continue;
      for (const std::string& one : Words(line.substr(kAlone.size(), line.find(')') - kAlone.size())))
        alone.insert(FolderOf(file) + "/" + one);
    }
  }
  std::map<std::string, std::string> places;
  std::map<std::string, std::string> file_of;
  Findings findings;
  for (const std::string& file : FilesBelow(root, "transpiler", {".cc"})) {
    if (alone.contains(file)) continue;
    for (const Definition& function : NamesOf(root, file).local_functions) {
      const auto [first, is_new] = places.emplace(function.name, function.place);
      if (is_new) file_of.emplace(function.name, file);
      if (file_of.at(function.name) == file) continue;
      findings.push_back(function.place + function.name + " may be compiled together with " + first->second +
                         "the same name");
    }
  }
  if (places.empty()) findings.emplace_back("no local function is defined anywhere: the rule looks at nothing");
  return findings;
}

Findings CheckFolderNamespaces(const std::string& root) {
  Findings findings;
  std::map<std::string, std::string> rows;      // folder: namespace
  std::map<std::string, std::string> owner_of;  // namespace: folder
  for (const std::string& line : Lines(ReadFile(root + "/tests/policy/namespaces.txt"))) {
    const std::vector<std::string> words = Words(line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (words.size() != 2) {
      findings.push_back("namespaces.txt: '" + line + "' is no row");
      continue;
    }
    rows.emplace(words[0], words[1]);
    const auto [owner, is_new] = owner_of.emplace(words[1], words[0]);
    if (!is_new) findings.push_back("namespaces.txt: " + owner->second + " and " + words[0] + " share " + words[1]);
  }
  std::set<std::string> used;
  for (const std::string& file : FilesBelow(root, "transpiler", {".cc", ".h"})) {
    const std::set<std::string> names = NamesOf(root, file).namespaces;
    if (names.empty()) continue;  // main, or nothing but inclusions
    auto row = rows.end();
    for (std::string folder = FolderOf(file); row == rows.end() && folder.find('/') != std::string::npos;
         folder = FolderOf(folder)) {
      row = rows.find(folder);
    }
    if (row == rows.end()) {
      findings.push_back(file + ": its folder has no row in namespaces.txt");
      continue;
    }
    used.insert(row->first);
    for (const std::string& name : names) {
      // Parts of a folder's own namespace, and of other people's libraries.
      if (name == row->second || name.starts_with(row->second + "::") || !name.starts_with("plcxx")) continue;
      findings.push_back(file + ": opens " + name + ", not " + row->second);
    }
  }
  for (const auto& [folder, name] : rows) {
    if (!used.contains(folder)) findings.push_back("namespaces.txt: nothing in " + folder);
  }
  return findings;
}

}  // namespace plcxx::policy
