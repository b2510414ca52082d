#include "transpiler/scenarios/scenario.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/scenarios/project_files.h"
#include "transpiler/scenarios/reader.h"

namespace plcxx::scenarios {
namespace {

constexpr std::uintmax_t kMaxBytes = 16u << 20;

std::string Join(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::vector<ScenarioError> Refuse(const std::string& path, ScenarioMark mark, std::string message) {
  return {ScenarioError{path, mark, std::move(message)}};
}

/// Where the documents of a stream begin. The parser gives documents without end for some texts, such as ",", as it
/// does not move on at what begins none; so nobody asks it for more than two.
struct Documents : YAML::EventHandler {
  std::optional<ScenarioMark> first, second;

  void OnDocumentStart(const YAML::Mark& mark) override {
    (first ? second : first) = {static_cast<uint32_t>(mark.line + 1), static_cast<uint32_t>(mark.column + 1)};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

Documents FirstDocuments(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Documents documents;
  if (parser.HandleNextDocument(documents)) parser.HandleNextDocument(documents);
  return documents;
}

/// Why a text does not end where its first document does; JSON's habit of a last comma is told as what it is.
std::string WhyNotTwo(const std::string& text, ScenarioMark second) {
  std::istringstream lines(text);
  std::string line;
  for (uint32_t i = 0; i < second.line; ++i) std::getline(lines, line);
  const size_t at = line.find_first_not_of(" \t", second.column - 1);
  if (at != std::string::npos && std::string_view(",]}").find(line[at]) != std::string_view::npos) {
    return std::string("not YAML: '") + line[at] + "' belongs to no list and no map: delete it";
  }
  return "the file holds more than one YAML document";
}

/// Names of locations with signs that YAML takes for its own: Y[0], %I0, !LAMP. Behind its message, or nothing.
std::string QuotesMissing(const std::string& text, uint32_t number) {
  std::istringstream lines(text);
  std::string line;
  for (uint32_t i = 0; i < number; ++i) std::getline(lines, line);
  if (const size_t tab = line.find_first_not_of(' '); tab != std::string::npos && line[tab] == '\t') {
    return "; indent with blanks, not with tabs";
  }
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  bool quoted = false;
  for (size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"' || line[at] == '\'') quoted = !quoted;
    if (quoted || line[at] == '#') continue;
    const bool begins = at > 0 && std::string_view(" {[,").find(line[at - 1]) != std::string_view::npos;
    const bool sign = begins && (line[at] == '%' || line[at] == '@' || line[at] == '!');
    const bool bracket = at > 0 && line[at] == '[' && is_word(line[at - 1]);
    if (!sign && !bracket) continue;
    size_t first = at, last = at;
    while (bracket && first > 0 && is_word(line[first - 1])) --first;
    while (last + 1 < line.size() && (is_word(line[last + 1]) || line[last + 1] == ']' || line[last + 1] == '.'))
      ++last;
    return "; write names with such signs in quotes: \"" + line.substr(first, last + 1 - first) + "\"";
  }
  return {};
}

}  // namespace

std::string ToText(const ScenarioError& error) {
  std::string text = diag::Escaped(error.path) + ":";
  if (error.mark.line != 0) text += std::to_string(error.mark.line) + ":" + std::to_string(error.mark.column) + ":";
  return text + " " + diag::EscapedLines(error.message);
}

ScenarioOrErrors ReadScenario(const std::string& path, Reach reach) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return Refuse(path, {}, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) return Refuse(path, {}, "not a file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > kMaxBytes) return Refuse(path, {}, "the file is larger than 16 MB: not a scenario");
  std::ifstream in(path, std::ios::binary);
  if (!in) return Refuse(path, {}, "the file cannot be read");
  return ParseScenario(path, std::string(std::istreambuf_iterator<char>(in), {}), reach);
}

ScenarioOrErrors ParseScenario(const std::string& path, const std::string& text, Reach reach) {
  ScenarioReader reader(path, reach);
  Scenario scenario;
  try {
    const Documents documents = FirstDocuments(text);
    if (documents.second) return Refuse(path, *documents.second, WhyNotTwo(text, *documents.second));
    const YAML::Node root = YAML::Load(text);
    if (root.IsNull()) return Refuse(path, {}, "the file holds no scenario");
    scenario = reader.Read(root);
  } catch (const YAML::Exception& fault) {
    const bool placed = !fault.mark.is_null();
    const auto line = static_cast<uint32_t>(placed ? fault.mark.line + 1 : 0);
    return Refuse(path, {line, static_cast<uint32_t>(placed ? fault.mark.column + 1 : 0)},
                  "not YAML: " + fault.msg + QuotesMissing(text, line));
  }
  if (!reader.errors().empty()) return std::move(reader.errors());
  return scenario;
}

void ScenarioReader::Fail(ScenarioMark mark, std::string message) {
  errors_.push_back({path_, mark, std::move(message)});
}

ScenarioMark ScenarioReader::Mark(const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  return {static_cast<uint32_t>(mark.line + 1), static_cast<uint32_t>(mark.column + 1)};
}

std::vector<YamlEntry> ScenarioReader::Map(const YAML::Node& node, std::string_view what) {
  std::vector<YamlEntry> entries;
  if (!node.IsMap()) {
    Fail(Mark(node), std::string(what) + " is a map '{key: value}'");
    return entries;
  }
  for (const auto& pair : node) {
    const std::optional<MarkedText> key = Word(pair.first, "a key");
    if (!key) continue;
    const bool twice =
        std::any_of(entries.begin(), entries.end(), [&](const YamlEntry& e) { return e.key.text == key->text; });
    if (twice)
      Fail(key->mark, "'" + key->text + "' is given twice");
    else
      entries.push_back({*key, pair.second});
  }
  return entries;
}

std::vector<YAML::Node> ScenarioReader::ListOrSingle(const YAML::Node& node) {
  if (!node.IsSequence()) return {node};
  return {node.begin(), node.end()};
}

std::optional<MarkedText> ScenarioReader::Word(const YAML::Node& node, std::string_view what) {
  if (node.IsScalar()) return MarkedText{node.Scalar(), Mark(node)};
  Fail(Mark(node),
       node.IsNull() ? std::string(what) + " is missing" : std::string(what) + " is a single word or number");
  return std::nullopt;
}

std::optional<uint32_t> ScenarioReader::Number(const YAML::Node& node, std::string_view what) {
  const std::optional<MarkedText> word = Word(node, what);
  if (!word) return std::nullopt;
  uint32_t number = 0;
  const char* end = word->text.data() + word->text.size();
  const auto [last, error] = std::from_chars(word->text.data(), end, number);
  if (error == std::errc() && last == end) return number;
  Fail(word->mark, "'" + word->text + "': " + std::string(what) + " is a whole number from 0 to " +
                       std::to_string(std::numeric_limits<uint32_t>::max()));
  return std::nullopt;
}

void ScenarioReader::RefuseKey(const MarkedText& key, std::string_view where,
                               std::initializer_list<std::string_view> known) {
  Fail(key.mark, "'" + key.text + "' is no key of " + std::string(where) + "; there are: " + Join(known));
}

void ScenarioReader::CheckReach(ScenarioMark mark, const std::vector<std::string>& paths) {
  if (reach_ == Reach::kAnywhere) return;
  for (const std::string& path : paths) {
    const std::optional<std::string> outside = OutsideOfProject(path_, path);
    if (outside) Fail(mark, "'" + path + "' is outside of the project " + *outside + "; --allow-outside allows it");
  }
}

std::vector<std::string> ScenarioReader::Words(const YAML::Node& node, std::string_view what) {
  std::vector<std::string> words;
  for (const YAML::Node& item : ListOrSingle(node)) {
    if (const std::optional<MarkedText> word = Word(item, what)) words.push_back(word->text);
  }
  return words;
}

std::map<std::string, std::string> ScenarioReader::Options(const YAML::Node& node) {
  std::map<std::string, std::string> options;
  for (const YamlEntry& entry : Map(node, "'options'")) {
    std::string value;
    for (const std::string& word : Words(entry.value, "the value of option '" + entry.key.text + "'")) {
      value += (value.empty() ? "" : ",") + word;  // options that take several values separate them so
    }
    CheckReach(entry.key.mark, {value});
    options[entry.key.text] = value;
  }
  return options;
}

ExpectedError ScenarioReader::ReadExpectedError(const YAML::Node& node) {
  ExpectedError expected{.mark = Mark(node), .contains = {}, .file = {}};
  for (const YamlEntry& entry : Map(node, "'expect_error'")) {
    if (entry.key.text == "line") {
      expected.line = Number(entry.value, "'line'").value_or(0);
    } else if (entry.key.text == "contains") {
      expected.contains = Words(entry.value, "'contains'");
    } else if (entry.key.text == "file") {
      if (const auto word = Word(entry.value, "'file'")) expected.file = word->text;
    } else {
      RefuseKey(entry.key, "'expect_error'", {"line", "contains", "file"});
    }
  }
  return expected;
}

std::vector<ExpectedWarning> ScenarioReader::ReadWarnings(const YAML::Node& node) {
  std::vector<ExpectedWarning> warnings;
  if (!node.IsSequence()) {
    Fail(Mark(node), "'warnings' is a list of '{line: n, code: Wnnn}'");
    return warnings;
  }
  for (const YAML::Node& item : node) {
    ExpectedWarning warning{.mark = Mark(item), .code = {}, .file = {}};
    for (const YamlEntry& entry : Map(item, "a warning")) {
      if (entry.key.text == "line") {
        warning.line = Number(entry.value, "'line'").value_or(0);
      } else if (entry.key.text == "code") {
        if (const auto word = Word(entry.value, "'code'")) warning.code = word->text;
      } else if (entry.key.text == "file") {
        if (const auto word = Word(entry.value, "'file'")) warning.file = word->text;
      } else {
        RefuseKey(entry.key, "a warning", {"line", "code", "file"});
      }
    }
    if (item.IsMap() && warning.code.empty()) Fail(warning.mark, "a warning needs its 'code'");
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

Scenario ScenarioReader::Read(const YAML::Node& root) {
  Scenario scenario;
  scenario.path = path_;
  scenario.directory = std::filesystem::path(path_).parent_path().string();
  for (const YamlEntry& entry : Map(root, "a scenario")) {
    const std::string& key = entry.key.text;
    if (key == "dialect" || key == "name" || key == "description") {
      const std::optional<MarkedText> word = Word(entry.value, "'" + key + "'");
      if (word && key == "dialect") scenario.dialect = word->text;
      if (word && key == "name") scenario.name = word->text;
    } else if (key == "sources") {
      scenario.sources = Words(entry.value, "a source");
      CheckReach(Mark(entry.value), scenario.sources);
    } else if (key == "options") {
      scenario.options = Options(entry.value);
    } else if (key == "expect_error") {
      scenario.expect_error = ReadExpectedError(entry.value);
    } else if (key == "warnings") {
      scenario.warnings = ReadWarnings(entry.value);
    } else if (key == "properties") {
      for (const YAML::Node& item : ListOrSingle(entry.value)) {
        if (std::optional<MarkedText> word = Word(item, "a property")) scenario.properties.push_back(std::move(*word));
      }
    } else if (key == "steps") {
      scenario.steps = ReadSteps(entry.value);
    } else {
      RefuseKey(
          entry.key, "a scenario",
          {"dialect", "sources", "options", "steps", "properties", "expect_error", "warnings", "name", "description"});
    }
  }
  if (!root.IsMap()) return scenario;
  if (scenario.steps && scenario.expect_error) {
    Fail(scenario.expect_error->mark, "'expect_error' stands instead of 'steps', not beside them");
  } else if (!scenario.steps && !scenario.expect_error && !scenario.warnings && scenario.properties.empty()) {
    Fail(Mark(root), "nothing to test: there are no 'steps', no 'expect_error' and no 'warnings'");
  }
  return scenario;
}

}  // namespace plcxx::scenarios
