#include "transpiler/scenarios/scenario.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/option_check.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/project/reach.h"
#include "transpiler/scenarios/project_program.h"
#include "transpiler/scenarios/reader.h"
#include "transpiler/support/near_words.h"
#include "transpiler/yaml/document.h"

namespace plcxx::scenarios {
namespace {

constexpr size_t kMaxBytes = 16u << 20;
constexpr std::string_view kOfProject = "project";  // as the word of `plant:`

std::vector<ScenarioError> Refuse(const std::string& path, ScenarioMark mark, std::string message) {
  return {ScenarioError{path, mark, std::move(message)}};
}

/// What most often is given in the place of a scenario is a source file. Nothing for what is YAML by its name.
std::string WhatAScenarioIs(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".yaml" || ending == ".yml" || ending == ".json") return {};
  return "a scenario is a file in YAML that names its program in 'sources' (docs/scenarios.md)";
}

/// What the word of `plant:` names.
std::vector<ScenarioError> TakePlant(const MarkedText& word, Scenario& scenario) {
  std::string path = (std::filesystem::path(scenario.directory) / word.text).lexically_normal().generic_string();
  if (word.text == kOfProject) {
    path = scenario.program ? scenario.program->plant : "";
    if (path.empty()) {
      return {{scenario.path, word.mark,
               "'plant: project' is the plant of plcxx.yaml, and this scenario has none of it",
               scenario.program ? "write 'plant: FILE' into plcxx.yaml, or name the file here"
                                : "name the file, or leave 'sources' out: then the program is that of plcxx.yaml"}};
    }
  }
  plant::ModelOrErrors read = plant::ReadPlant(path);
  if (auto* errors = std::get_if<std::vector<ScenarioError>>(&read)) {
    // The file itself cannot be read: the scenario's line says more than the path.
    if (errors->size() == 1 && errors->front().mark.line == 0) {
      return {{scenario.path, word.mark, "plant '" + path + "': " + errors->front().message, errors->front().remedy}};
    }
    return std::move(*errors);
  }
  scenario.plant = std::move(std::get<std::shared_ptr<const plant::Model>>(read));
  return {};
}

/// The dialect and its options, each at its place; where a fault is expected, it may be about these.
std::vector<ScenarioError> CheckDialect(const ScenarioReader& reader, const Scenario& scenario) {
  std::vector<ScenarioError> errors;
  if (scenario.expect_error || scenario.dialect.empty()) return errors;
  const dialects::Dialect* dialect = dialects::DialectByName(scenario.dialect);
  if (dialect == nullptr) {
    const std::string names = support::ThereAre(scenario.dialect, compilation::DialectNames());
    return {{scenario.path, reader.dialect().mark, "'" + scenario.dialect + "' is no dialect" + names}};
  }
  for (const auto& [name, value] : reader.options()) {
    if (name.text == "encoding" || name.text == "system-include") continue;  // the tool's own
    for (const diag::Diagnostic& found : compilation::CheckOption(*dialect, name.text, value.text)) {
      const bool unknown = found.row->key == diag::UnknownOption.row.key;
      errors.push_back({scenario.path, unknown ? name.mark : value.mark, found.text, found.remedy});
    }
  }
  return errors;
}

}  // namespace

ScenarioOrErrors ReadScenario(const std::string& path, Reach reach) {
  std::variant<std::string, yaml::Fault> text = yaml::ReadText(path, kMaxBytes, "scenario");
  if (auto* fault = std::get_if<yaml::Fault>(&text)) return Refuse(path, fault->mark, std::move(fault->message));
  ScenarioOrErrors read = ParseScenario(path, std::get<std::string>(text), reach);
  if (auto* const errors = std::get_if<std::vector<ScenarioError>>(&read); errors && errors->front().remedy.empty())
    errors->front().remedy = WhatAScenarioIs(path);
  return read;
}

ScenarioOrErrors ParseScenario(const std::string& path, const std::string& text, Reach reach) {
  std::variant<YAML::Node, yaml::Fault> root = yaml::Load(text);
  if (auto* fault = std::get_if<yaml::Fault>(&root)) return Refuse(path, fault->mark, std::move(fault->message));
  if (std::get<YAML::Node>(root).IsNull()) return Refuse(path, {}, "the file holds no scenario");
  ScenarioReader reader(path, reach);
  Scenario scenario = reader.Read(std::get<YAML::Node>(root));
  if (!reader.errors().empty()) return std::move(reader.errors());
  if (scenario.sources.empty()) {
    std::vector<ScenarioError> errors = TakeProgram(scenario, reader.program(), reach);
    if (!errors.empty()) return errors;
  }
  if (std::vector<ScenarioError> errors = CheckDialect(reader, scenario); !errors.empty()) return errors;
  if (!reader.plant().text.empty()) {
    std::vector<ScenarioError> errors = TakePlant(reader.plant(), scenario);
    if (!errors.empty()) return errors;
  }
  return scenario;
}

void ScenarioReader::CheckReach(ScenarioMark mark, const std::vector<std::string>& paths) {
  if (reach_ == Reach::kAnywhere) return;
  for (const std::string& path : paths) {
    const std::optional<std::string> outside = project::OutsideOfProject(this->path(), path);
    if (outside) Fail(mark, "'" + path + "' is outside of the project " + *outside + "; --allow-outside allows it");
  }
}

std::map<std::string, std::string> ScenarioReader::Options(const YAML::Node& node) {
  std::map<std::string, std::string> options;
  for (const YamlEntry& entry : Map(node, "'options'")) {
    std::string value;
    for (const std::string& word : Words(entry.value, "the value of option '" + entry.key.text + "'")) {
      value += (value.empty() ? "" : ",") + word;  // options that take several values separate them so
    }
    CheckReach(entry.key.mark, {value});
    options_.push_back({entry.key, {value, Mark(entry.value)}});
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

void ScenarioReader::ReadSources(const YAML::Node& node, Scenario& scenario) {
  if (!node.IsMap()) {
    scenario.sources = Words(node, "a source");
    CheckReach(Mark(node), scenario.sources);
    return;
  }
  const std::string folder = std::filesystem::path(path()).filename().string() + "/";
  for (const YamlEntry& entry : Map(node, "'sources'")) {
    const std::string& name = entry.key.text;
    if (name.empty() || name.find_first_of("/\\") != std::string::npos)
      Fail(entry.key.mark, "'" + name + "': a source that is written here has a name without a folder");
    std::optional<MarkedText> text = Word(entry.value, "the text of '" + name + "'");
    if (!text) continue;
    scenario.sources.push_back(folder + name);
    scenario.texts[folder + name] = std::move(text->text);
  }
}

Scenario ScenarioReader::Read(const YAML::Node& root) {
  Scenario scenario;
  scenario.path = path();
  scenario.directory = std::filesystem::path(path()).parent_path().string();
  bool has_misspelt_test = false;  // one of the keys that say what to test is meant
  for (const YamlEntry& entry : Map(root, "a scenario")) {
    const std::string& key = entry.key.text;
    if (key == "dialect" || key == "name" || key == "description") {
      const std::optional<MarkedText> word = Word(entry.value, "'" + key + "'");
      if (word && key == "dialect") dialect_ = *word;
      if (word && key == "dialect") scenario.dialect = word->text;
      if (word && key == "name") scenario.name = word->text;
    } else if (key == "program") {
      if (std::optional<MarkedText> word = Word(entry.value, "'program'")) program_ = std::move(*word);
    } else if (key == "plant") {
      if (std::optional<MarkedText> word = Word(entry.value, "'plant'")) {
        plant_ = std::move(*word);
        if (plant_.text != kOfProject) CheckReach(plant_.mark, {plant_.text});
      }
    } else if (key == "sources") {
      ReadSources(entry.value, scenario);
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
      constexpr std::string_view kTests[] = {"steps", "expect_error", "warnings", "properties"};
      has_misspelt_test = has_misspelt_test || !support::NearestWord(key, kTests).empty();
      RefuseKey(entry.key, "a scenario",
                {"dialect", "program", "sources", "options", "plant", "steps", "properties", "expect_error", "warnings",
                 "name", "description"});
    }
  }
  if (!root.IsMap()) return scenario;
  if (!program_.text.empty() && !scenario.sources.empty())
    Fail(program_.mark, "'program' is one of plcxx.yaml, and 'sources' are others", "delete one of them");
  if (scenario.steps && scenario.expect_error) {
    Fail(scenario.expect_error->mark, "'expect_error' stands instead of 'steps', not beside them");
  } else if (!scenario.steps && !scenario.expect_error && !scenario.warnings && scenario.properties.empty() &&
             !has_misspelt_test) {
    Fail(Mark(root), "nothing to test: there are no 'steps', no 'expect_error' and no 'warnings'");
  }
  return scenario;
}

}  // namespace plcxx::scenarios
