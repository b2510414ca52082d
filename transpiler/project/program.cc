#include "transpiler/project/program.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "transpiler/compilation/option_check.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/project/globs.h"
#include "transpiler/support/near_words.h"

namespace plcxx::project {
namespace {

namespace fs = std::filesystem;

/// "a" below "": "a"; below ".", "a": the names in messages are those that people wrote.
std::string Below(const std::string& folder, const std::string& path) {
  const fs::path whole = fs::path(path).is_absolute() ? fs::path(path) : fs::path(folder) / path;
  const std::string normal = whole.lexically_normal().generic_string();
  return normal.size() > 1 && normal.ends_with('/') ? normal.substr(0, normal.size() - 1) : normal;
}

std::string OnlyWord(const Value& value) { return value.words.empty() ? std::string() : value.words.front().text; }

class ProgramMaker {
 public:
  ProgramMaker(Reach reach, yaml::Reader& reader) : reach_(reach), reader_(reader) {
    file_folder_ = fs::path(reader.path()).parent_path().string();
  }

  Program Make(const std::vector<NamedValue>& keys, yaml::Place mark) {
    for (const NamedValue& key : keys) {  // the others are relative to it
      if (key.row->key == Key::kFolder && CheckReach(key.value.words)) own_folder_ = OnlyWord(key.value);
    }
    program_.folder = own_folder_.empty() ? file_folder_ : Below(file_folder_, own_folder_);
    program_.generated = Below(program_.folder, "generated");
    program_.scenarios = {program_.folder.empty() ? "." : program_.folder};
    for (const NamedValue& key : keys) Take(key);
    if (!own_folder_.empty()) program_.include.push_back(file_folder_.empty() ? "." : file_folder_);
    const bool has_sources = std::ranges::any_of(keys, [](const NamedValue& k) { return k.row->key == Key::kSources; });
    if (!has_sources) reader_.Fail(mark, "'sources' is missing", "name the files of the program, in their order");
    if (reader_.errors().empty()) CheckDialect(keys);
    return std::move(program_);
  }

 private:
  void Take(const NamedValue& key) {
    const Value& value = key.value;
    switch (key.row->key) {
      case Key::kName:
        program_.name = OnlyWord(value);
        return;
      case Key::kFolder:
      case Key::kPrograms:  // of the file
        return;
      case Key::kDialect:
        program_.dialect = OnlyWord(value);
        return;
      case Key::kHost:
        program_.host = OnlyWord(value);
        return;
      case Key::kSources:
        program_.sources = Files(value);
        if (program_.sources.empty() && reader_.errors().empty()) reader_.Fail(value.mark, "'sources' names no file");
        return;
      case Key::kEncoding:
        program_.encoding = OnlyWord(value) == "auto" ? "" : OnlyWord(value);
        return;
      case Key::kOptions:
        for (const NamedValue& option : value.entries) {
          CheckReach(option.value.words);
          program_.options.emplace_back(option.name.text, OnlyWord(option.value));
        }
        return;
      case Key::kInclude:
        program_.include = Paths(value);
        return;
      case Key::kSystemInclude:
        program_.system_include = Paths(value);
        return;
      case Key::kMacros:
        for (const NamedValue& macro : value.entries)
          program_.macros.push_back({macro.name.text, macro.value.words.empty() ? "1" : OnlyWord(macro.value)});
        return;
      case Key::kUndefine:
        for (const yaml::MarkedText& name : value.words) program_.macros.push_back({name.text, std::nullopt});
        return;
      case Key::kWarnings:
        for (const NamedValue& one : value.entries) Take(one);
        return;
      case Key::kScenarios:
        program_.scenarios = Scenarios(value);
        return;
      case Key::kProperties:
        program_.properties = Paths(value);
        if (program_.properties.empty()) return;  // outside, which has been reported
        for (const yaml::MarkedText& file : value.words) CheckIsThere(file);
        return;
      case Key::kPlant:
        program_.plant = OnlyFile(value);
        return;
      case Key::kPanel:
        program_.panel = OnlyFile(value);
        return;
      case Key::kGenerated:
        program_.generated = Paths(value).empty() ? program_.generated : Paths(value).front();
        return;
      case Key::kTargets:
        for (const NamedValue& target : value.entries) TakeTarget(target);
        return;
      case Key::kEnable:
        TakeWarnings(value, "");
        return;
      case Key::kDisable:
        TakeWarnings(value, "no-");
        return;
      case Key::kErrors:
        TakeWarnings(value, "error=");
        return;
      case Key::kBaseline:
        program_.baseline = Paths(value).empty() ? "" : Paths(value).front();
        return;
      case Key::kClock:
      case Key::kMaxFastUs:
      case Key::kMaxSlowUs:
      case Key::kMaxStack:
      case Key::kMaxCode:
      case Key::kOptimize:
      case Key::kCompiler:
      case Key::kOutput:
        return TakeOfTarget(key);
    }
  }

  void TakeTarget(const NamedValue& named) {
    program_.targets.push_back({.name = named.name.text, .output = Below(program_.folder, "out/" + named.name.text)});
    for (const NamedValue& key : named.value.entries) TakeOfTarget(key);
  }

  void TakeOfTarget(const NamedValue& key) {
    Target& target = program_.targets.back();
    const std::string word = OnlyWord(key.value);
    const auto number = [&] { return reader_.errors().empty() ? std::optional(std::stoull(word)) : std::nullopt; };
    if (key.row->key == Key::kClock) target.clock = word;
    if (key.row->key == Key::kMaxFastUs) target.max_fast_us = number();
    if (key.row->key == Key::kMaxSlowUs) target.max_slow_us = number();
    if (key.row->key == Key::kMaxStack) target.max_stack = number();
    if (key.row->key == Key::kMaxCode) target.max_code = number();
    if (key.row->key == Key::kOptimize) target.optimize = word;
    if (key.row->key == Key::kCompiler) target.compiler = word;
    if (key.row->key == Key::kOutput && CheckReach(key.value.words)) target.output = Below(program_.folder, word);
  }

  void TakeWarnings(const Value& value, const std::string& prefix) {
    for (const yaml::MarkedText& word : value.words)
      program_.warnings.push_back(word.text == "all" ? "error" : prefix + word.text);
  }

  /// False when a path leaves the project; reported.
  bool CheckReach(const std::vector<yaml::MarkedText>& paths) {
    if (reach_ == Reach::kAnywhere) return true;
    bool inside = true;
    for (const yaml::MarkedText& path : paths) {
      const std::string named = (fs::path(own_folder_) / path.text).string();
      const std::optional<std::string> outside = OutsideOfProject(reader_.path(), named);
      if (!outside) continue;
      reader_.Fail(path.mark, "'" + path.text + "' is outside of the project " + *outside,
                   "move it there, or allow it with --allow-outside");
      inside = false;
    }
    return inside;
  }

  std::vector<std::string> Paths(const Value& value) {
    std::vector<std::string> paths;
    if (!CheckReach(value.words)) return paths;
    for (const yaml::MarkedText& path : value.words) paths.push_back(Below(program_.folder, path.text));
    return paths;
  }

  /// A file that is there, as it is opened; empty: reported.
  std::string OnlyFile(const Value& value) {
    if (value.words.empty() || !CheckReach(value.words) || !CheckIsThere(value.words.front())) return {};
    return Below(program_.folder, value.words.front().text);
  }

  /// The files that a pattern stands for, relative to the program's folder; what is wrong with it is reported.
  std::vector<std::string> Matches(const yaml::MarkedText& pattern) {
    const std::string fixed = pattern.text.substr(0, pattern.text.find_first_of("*?"));
    const size_t slash = fixed.rfind('/');
    if (slash != std::string::npos && !CheckReach({{fixed.substr(0, slash + 1), pattern.mark}})) return {};
    std::variant<std::vector<std::string>, std::string> expanded = ExpandGlob(program_.folder, pattern.text);
    if (const auto* why = std::get_if<std::string>(&expanded)) {
      reader_.Fail(pattern.mark, "'" + pattern.text + "': " + *why, "name the folder in front of the pattern");
      return {};
    }
    auto& names = std::get<std::vector<std::string>>(expanded);
    std::erase_if(names, [](const std::string& name) { return fs::path(name).filename() == kProjectFile; });
    if (names.empty()) reader_.Fail(pattern.mark, "no file is called '" + pattern.text + "'");
    for (const std::string& name : names) {
      if (!CheckReach({{name, pattern.mark}})) return {};
    }
    return std::move(names);
  }

  /// Each file once, by whatever path it is named.
  std::vector<std::string> Files(const Value& value) {
    std::vector<std::string> files;
    std::set<fs::path> named, matched;
    for (const yaml::MarkedText& word : value.words) {
      if (!IsGlob(word.text) && !named.insert(fs::path(word.text).lexically_normal()).second)
        reader_.Fail(word.mark, "'" + word.text + "' is named twice", "name each file once");
    }
    for (const yaml::MarkedText& word : value.words) {
      if (IsGlob(word.text)) {
        for (std::string& name : Matches(word)) {  // a pattern means all the others
          const fs::path path = fs::path(name).lexically_normal();
          if (!named.contains(path) && matched.insert(path).second) files.push_back(std::move(name));
        }
      } else if (CheckReach({word}) && CheckIsThere(word)) {
        files.push_back(word.text);
      }
    }
    return files;
  }

  bool CheckIsThere(const yaml::MarkedText& file) {
    const fs::path path = Below(program_.folder, file.text);
    std::error_code error;
    if (fs::exists(path, error)) return true;
    std::vector<std::string> names;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMaxNames;
         at.increment(error))
      names.push_back(at->path().filename().string());
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view near = support::NearestWord(path.filename().string(), views);
    reader_.Fail(file.mark, "there is no file '" + path.generic_string() + "'",
                 near.empty() ? "" : "did you mean '" + std::string(near) + "'");
    return false;
  }

  std::vector<std::string> Scenarios(const Value& value) {
    std::vector<std::string> scenarios = Files(value);
    for (std::string& scenario : scenarios) scenario = Below(program_.folder, scenario);
    return scenarios;
  }

  /// Where the dialect is known before anything is compiled: what it takes, each at its place.
  void CheckDialect(const std::vector<NamedValue>& keys) {
    const auto is_of_some = [](const NamedValue& key) {
      return key.row->key == Key::kOptions || key.row->key == Key::kMacros || key.row->key == Key::kUndefine ||
             key.row->key == Key::kSystemInclude;
    };
    if (std::ranges::none_of(keys, is_of_some)) return;
    const dialects::Dialect* dialect = compilation::DialectOf(RequestOf(program_));
    if (dialect == nullptr) return;  // whoever compiles it is told
    for (const NamedValue& key : keys) {
      const bool is_macro = key.row->key == Key::kMacros || key.row->key == Key::kUndefine;
      if (key.row->key == Key::kOptions) CheckOptions(*dialect, key.value);
      if (is_macro && !dialect->takes_macros) RefuseFor(*dialect, key.name);
      if (key.row->key == Key::kSystemInclude && !dialect->takes_system_includes) RefuseFor(*dialect, key.name);
    }
  }

  void RefuseFor(const dialects::Dialect& dialect, const yaml::MarkedText& key) {
    reader_.Fail(key.mark, "'" + key.text + "' says nothing to dialect " + std::string(dialect.name),
                 "delete it: a program of this dialect has 'options' and 'include'");
  }

  void CheckOptions(const dialects::Dialect& dialect, const Value& options) {
    for (const NamedValue& option : options.entries) {
      for (const diag::Diagnostic& found :
           compilation::CheckOption(dialect, option.name.text, OnlyWord(option.value))) {
        const bool unknown = found.row->key == diag::UnknownOption.row.key;
        reader_.Fail(unknown ? option.name.mark : option.value.mark, found.text, found.remedy);
      }
    }
  }

  Reach reach_;
  yaml::Reader& reader_;
  Program program_;
  std::string file_folder_, own_folder_;  // the second as written, relative to the first
};

}  // namespace

Program MakeProgram(const std::vector<NamedValue>& keys, yaml::Place mark, Reach reach, yaml::Reader& reader) {
  return ProgramMaker(reach, reader).Make(keys, mark);
}

}  // namespace plcxx::project
