// How the parts of the scenario reader see the YAML tree: typed access that collects errors with their places.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

/// One `key: value` of a YAML map.
struct YamlEntry {
  MarkedText key;
  YAML::Node value;
};

class ScenarioReader {
 public:
  ScenarioReader(std::string path, Reach reach) : path_(std::move(path)), reach_(reach) {}

  Scenario Read(const YAML::Node& root);
  std::vector<ScenarioError>& errors() { return errors_; }
  void Fail(ScenarioMark mark, std::string message);

 private:
  static ScenarioMark Mark(const YAML::Node& node);

  /// The entries of a map, each key once; reports anything else. `what` names the node in messages.
  std::vector<YamlEntry> Map(const YAML::Node& node, std::string_view what);
  /// The elements of a list, or the node itself when it is none.
  std::vector<YAML::Node> ListOrSingle(const YAML::Node& node);
  std::optional<MarkedText> Word(const YAML::Node& node, std::string_view what);
  std::optional<uint32_t> Number(const YAML::Node& node, std::string_view what);
  void RefuseKey(const MarkedText& key, std::string_view where, std::initializer_list<std::string_view> known);

  std::vector<std::string> Words(const YAML::Node& node, std::string_view what);
  std::map<std::string, std::string> Options(const YAML::Node& node);
  ExpectedError ReadExpectedError(const YAML::Node& node);
  std::vector<ExpectedWarning> ReadWarnings(const YAML::Node& node);

  std::vector<ScenarioStep> ReadSteps(const YAML::Node& node);
  std::optional<StepAction> ReadAction(const YamlEntry& entry);
  std::vector<Assignment> Assignments(const YAML::Node& node, std::string_view what);
  std::vector<MarkedText> Locations(const YAML::Node& node);
  RunStep ReadRun(const YAML::Node& node);
  std::optional<RunPart> ReadRunPart(const YamlEntry& entry);
  ExpectCallsStep ReadCalls(const YAML::Node& node);
  ExpectMessagesStep ReadMessages(const YAML::Node& node);

  /// Refuses what names a file outside of the scenario's project, unless that was allowed.
  void CheckReach(ScenarioMark mark, const std::vector<std::string>& paths);

  std::string path_;
  Reach reach_;
  std::vector<ScenarioError> errors_;
};

}  // namespace plcxx::scenarios
