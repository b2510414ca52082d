// The parts of the scenario reader.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/scenarios/scenario.h"
#include "transpiler/yaml/reader.h"

namespace plcxx::scenarios {

using YamlEntry = yaml::Entry;

class ScenarioReader : public yaml::Reader {
 public:
  ScenarioReader(std::string path, Reach reach) : Reader(std::move(path)), reach_(reach) {}

  Scenario Read(const YAML::Node& root);
  /// The word of `program:`, which is not the scenario's but its project's; empty when there is none.
  const MarkedText& program() const { return program_; }
  /// The word of `plant:`, a file or `project`; empty when there is none.
  const MarkedText& plant() const { return plant_; }
  /// The word of `dialect:`; empty when there is none.
  const MarkedText& dialect() const { return dialect_; }
  /// The keys and values of `options:`.
  const std::vector<std::pair<MarkedText, MarkedText>>& options() const { return options_; }

 private:
  /// Names of files, or a map of names and texts.
  void ReadSources(const YAML::Node& node, Scenario& scenario);
  std::map<std::string, std::string> Options(const YAML::Node& node);
  ExpectedError ReadExpectedError(const YAML::Node& node);
  std::vector<ExpectedWarning> ReadWarnings(const YAML::Node& node);

  std::vector<ScenarioStep> ReadSteps(const YAML::Node& node);
  std::optional<StepAction> ReadAction(const YamlEntry& entry);
  /// Its steps, as often as it says, behind those that are there.
  void ReadRepeat(const YamlEntry& entry, std::vector<ScenarioStep>& steps);
  std::vector<Assignment> Assignments(const YAML::Node& node, std::string_view what);
  std::vector<MarkedText> Locations(const YAML::Node& node);
  RunStep ReadRun(const YAML::Node& node);
  std::optional<RunPart> ReadRunPart(const YamlEntry& entry);
  ExpectCallsStep ReadCalls(const YAML::Node& node);
  ExpectMessagesStep ReadMessages(const YAML::Node& node);

  /// Refuses what names a file outside of the scenario's project, unless that was allowed.
  void CheckReach(ScenarioMark mark, const std::vector<std::string>& paths);

  Reach reach_;
  uint32_t repeats_ = 0;  // that what is being read stands in
  MarkedText program_, plant_, dialect_;
  std::vector<std::pair<MarkedText, MarkedText>> options_;
};

}  // namespace plcxx::scenarios
