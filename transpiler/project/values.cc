#include "transpiler/project/values.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include "transpiler/compilation/warning_options.h"
#include "transpiler/measure/limits.h"
#include "transpiler/support/file_names.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::project {
namespace {

constexpr size_t kMaxPrograms = 1000;

std::vector<std::string_view> Views(const std::vector<std::string>& words) { return {words.begin(), words.end()}; }

std::string Quoted(std::string_view word) { return "'" + std::string(word) + "'"; }

/// "a program", for messages about its keys.
std::string_view NameOf(Section section) {
  switch (section) {
    case Section::kFile:
      return "plcxx.yaml";
    case Section::kProgram:
      return "a program";
    case Section::kWarnings:
      return "'warnings'";
    case Section::kTarget:
      return "a target";
  }
  return {};
}

class KeyReader {
 public:
  explicit KeyReader(yaml::Reader& reader) : reader_(reader) {}

  std::vector<NamedValue> ReadSection(const YAML::Node& node, Section section) {
    std::vector<NamedValue> keys;
    for (const yaml::Entry& entry : reader_.Map(node, NameOf(section))) {
      const KeyRow* row = FindKey(section, entry.key.text);
      if (row == nullptr) {
        RefuseKey(entry.key, section);
        continue;
      }
      keys.push_back({entry.key, row, ReadValue(entry.value, *row)});
    }
    return keys;
  }

 private:
  void RefuseKey(const yaml::MarkedText& key, Section section) {
    std::vector<std::string_view> known;
    for (const KeyRow* one : KeysOf(section)) known.push_back(one->text);
    std::vector<std::string> unknown;
    compilation::ReadWarningOptions({key.text}, unknown);
    if (section != Section::kWarnings || !unknown.empty()) return reader_.RefuseKey(key, NameOf(section), known);
    // "warnings: {W350: off}"
    reader_.Fail(
        key.mark,
        Quoted(key.text) + " is a warning, and no key of 'warnings'; there are: " + support::CommaSeparated(known),
        "'disable: [" + key.text + "]' turns it off, 'enable: [" + key.text + "]' on, 'errors: [" + key.text +
            "]' makes an error of it");
  }

  Value ReadValue(const YAML::Node& node, const KeyRow& row) {
    Value value{yaml::Reader::Mark(node), {}, {}};
    const std::string what = Quoted(row.text);
    switch (row.shape) {
      case Shape::kWord:
      case Shape::kNumber:
      case Shape::kFileName:
      case Shape::kPath:
      case Shape::kDialect:
      case Shape::kEncoding:
      case Shape::kLevel:
      case Shape::kFrequency:
      case Shape::kHost:
        if (std::optional<yaml::MarkedText> word = reader_.Word(node, what)) value.words.push_back(std::move(*word));
        break;
      case Shape::kWords:
      case Shape::kPaths:
      case Shape::kGlobs:
      case Shape::kWarningNames:
      case Shape::kWarningNamesOrAll:
        value.words = reader_.MarkedWords(node, what);
        break;
      case Shape::kOptions:
        ReadOptions(node, what, value);
        break;
      case Shape::kMacros:
        ReadMacros(node, what, value);
        break;
      case Shape::kWarnings:
        value.entries = ReadSection(node, Section::kWarnings);
        break;
      case Shape::kTargets:
        ReadTargets(node, what, value);
        break;
      case Shape::kPrograms:
        ReadPrograms(node, value);
        break;
    }
    for (const yaml::MarkedText& word : value.words) Check(word, row);
    return value;
  }

  void ReadOptions(const YAML::Node& node, const std::string& what, Value& value) {
    for (const yaml::Entry& entry : reader_.Map(node, what)) {
      std::string text;  // options that take several values separate them so
      for (const std::string& word : reader_.Words(entry.value, "the value of option " + Quoted(entry.key.text)))
        text += (text.empty() ? "" : ",") + word;
      const yaml::Place mark = yaml::Reader::Mark(entry.value);
      value.entries.push_back({entry.key, nullptr, {mark, {{std::move(text), mark}}, {}}});
    }
  }

  void ReadMacros(const YAML::Node& node, const std::string& what, Value& value) {
    if (node.IsMap()) {
      for (const yaml::Entry& entry : reader_.Map(node, what)) {
        Value text{entry.key.mark, {}, {}};
        if (!entry.value.IsNull()) text.words = reader_.MarkedWords(entry.value, "the value of a macro");
        value.entries.push_back({entry.key, nullptr, std::move(text)});
      }
      return;
    }
    for (const yaml::MarkedText& word : reader_.MarkedWords(node, what)) {
      const size_t equals = word.text.find('=');
      Value text{word.mark, {}, {}};
      if (equals != std::string::npos) text.words.push_back({word.text.substr(equals + 1), word.mark});
      value.entries.push_back({{word.text.substr(0, equals), word.mark}, nullptr, std::move(text)});
    }
  }

  void ReadTargets(const YAML::Node& node, const std::string& what, Value& value) {
    if (node.IsMap()) {
      for (const yaml::Entry& entry : reader_.Map(node, what)) {
        Value target{entry.key.mark, {}, {}};
        if (!entry.value.IsNull()) target.entries = ReadSection(entry.value, Section::kTarget);
        value.entries.push_back({entry.key, nullptr, std::move(target)});
      }
    } else {
      for (const yaml::MarkedText& word : reader_.MarkedWords(node, what))
        value.entries.push_back({word, nullptr, {word.mark, {}, {}}});
    }
    for (const NamedValue& target : value.entries) CheckOneOf(target.name, "target", WordsOf(Shape::kTargets));
  }

  void ReadPrograms(const YAML::Node& node, Value& value) {
    if (!node.IsSequence() || node.size() == 0) {
      reader_.Fail(value.mark, "'programs' is a list of maps", "write '- name: lathe', and its other keys below");
      return;
    }
    if (node.size() > kMaxPrograms) {
      reader_.Fail(value.mark, "more than " + std::to_string(kMaxPrograms) + " programs", "write several files");
      return;
    }
    for (const YAML::Node& item : node) {
      const yaml::Place mark = yaml::Reader::Mark(item);
      value.entries.push_back({{"", mark}, nullptr, {mark, {}, ReadSection(item, Section::kProgram)}});
    }
  }

  void CheckOneOf(const yaml::MarkedText& word, std::string_view what, const std::vector<std::string>& known) {
    if (std::ranges::find(known, word.text) != known.end()) return;
    const std::string_view near = support::NearestWord(word.text, Views(known));
    reader_.Fail(word.mark,
                 Quoted(word.text) + " is no " + std::string(what) + "; there are: " + support::CommaSeparated(known),
                 near.empty() ? "" : "did you mean " + Quoted(near));
  }

  void CheckWarning(const yaml::MarkedText& word) {
    std::vector<std::string> unknown;
    static_cast<void>(compilation::ReadWarningOptions({word.text}, unknown));
    const bool is_name = unknown.empty() && !word.text.starts_with("no-") && !word.text.starts_with("error");
    if (is_name) return;
    reader_.Fail(word.mark, Quoted(word.text) + " names no warning", compilation::RemedyOfUnknownWarning(word.text));
  }

  void Check(const yaml::MarkedText& word, const KeyRow& row) {
    switch (row.shape) {
      case Shape::kDialect:
      case Shape::kEncoding:
      case Shape::kLevel:
      case Shape::kHost:
        CheckOneOf(word, row.shape == Shape::kLevel ? "level of optimization" : row.text, WordsOf(row.shape));
        return;
      case Shape::kNumber: {
        uint64_t number = 0;
        const char* const end = word.text.data() + word.text.size();
        const auto [last, error] = std::from_chars(word.text.data(), end, number);
        if (error != std::errc() || last != end)
          reader_.Fail(word.mark, Quoted(word.text) + ": " + Quoted(row.text) + " is a whole number");
        return;
      }
      case Shape::kFrequency:
        if (!measure::ParseClock(word.text))
          reader_.Fail(word.mark, Quoted(word.text) + " is no frequency", "write 168MHz, 32kHz or 16000000");
        return;
      case Shape::kFileName:
        if (!support::IsFileName(word.text))
          reader_.Fail(word.mark, Quoted(word.text) + " cannot name files", "use letters, digits, '_', '-' and '.'");
        return;
      case Shape::kWarningNamesOrAll:
        if (word.text != "all") CheckWarning(word);
        return;
      case Shape::kWarningNames:
        CheckWarning(word);
        return;
      case Shape::kPath:
      case Shape::kPaths:
      case Shape::kGlobs:
        if (word.text.empty()) reader_.Fail(word.mark, "a path of " + Quoted(row.text) + " is empty");
        return;
      case Shape::kWord:
      case Shape::kWords:
      case Shape::kOptions:
      case Shape::kMacros:
      case Shape::kWarnings:
      case Shape::kTargets:
      case Shape::kPrograms:
        return;
    }
  }

  yaml::Reader& reader_;
};

}  // namespace

std::vector<NamedValue> ReadKeys(const YAML::Node& root, yaml::Reader& reader) {
  return KeyReader(reader).ReadSection(root, Section::kFile);
}

std::vector<NamedValue> Merged(std::vector<NamedValue> common, const std::vector<NamedValue>& own) {
  for (const NamedValue& one : own) {
    const auto same = std::ranges::find(common, one.name.text, [](const NamedValue& it) { return it.name.text; });
    if (same == common.end()) {
      common.push_back(one);
    } else if (!same->value.entries.empty() && !one.value.entries.empty()) {
      same->value.entries = Merged(std::move(same->value.entries), one.value.entries);
    } else {
      common.erase(same);
      common.push_back(one);  // at the end: of two options that mean the same thing the later one counts
    }
  }
  return common;
}

}  // namespace plcxx::project
