// A scenario file as it is written: what to compile, with which options, and the steps to run.
//
// In: YAML (section 6 of the design). Out: a Scenario, every word of it with its line and column, or all that is wrong
// with the file. Not its job: what a location or a value means (plan.h) and running (run.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/plant/plant.h"
#include "transpiler/project/project.h"
#include "transpiler/yaml/place.h"

namespace plcxx::scenarios {

using ScenarioMark = yaml::Place;
using yaml::MarkedText;
using ScenarioError = yaml::Error;

/// `I0A3: 1`
struct Assignment {
  MarkedText location;
  MarkedText value;
};

struct SetStep {
  std::vector<Assignment> assignments;
};
struct ExpectStep {
  std::vector<Assignment> expectations;
};
struct ForceStep {
  std::vector<Assignment> assignments;
};
struct ReleaseStep {
  std::vector<MarkedText> locations;
};

enum class RunUnit : uint8_t { kSlowCycles, kFastTicks, kMilliseconds };
struct RunPart {
  RunUnit unit{};
  uint32_t count = 0;
};
struct RunStep {
  std::vector<RunPart> parts;  // in the order written
};

/// `axis_home: {axis: 1}`; `axis_home: none`: there is none.
struct ExpectedCall {
  MarkedText function;
  std::vector<Assignment> arguments;
  bool none = false;
};
struct ExpectCallsStep {
  std::vector<ExpectedCall> calls;
};
/// Each by its number or its text.
struct ExpectMessagesStep {
  std::vector<std::string> messages;
};
struct PowerCycleStep {};

using StepAction = std::variant<SetStep, RunStep, ExpectStep, ForceStep, ReleaseStep, ExpectCallsStep,
                                ExpectMessagesStep, PowerCycleStep>;

struct ScenarioStep {
  uint32_t number = 0;  // 1-based
  std::string name;     // "expect_calls"
  ScenarioMark mark;
  StepAction action;
};

struct ExpectedError {
  ScenarioMark mark;
  uint32_t line = 0;                  // 0: any
  std::vector<std::string> contains;  // all of them
  std::string file;                   // empty: whichever holds the error
};

struct ExpectedWarning {
  ScenarioMark mark;
  uint32_t line = 0;  // 0: any
  std::string code;   // "W356" or "nc110-W356"
  std::string file;
};

struct Scenario {
  std::string path;       // as given
  std::string directory;  // of `path`; sources and files of options are relative to it
  std::string name;
  std::string dialect;  // empty: told by the sources
  std::vector<std::string> sources;
  /// The sources that are written in the scenario itself, by their paths in `sources`: "drill.yaml/main.plc".
  std::map<std::string, std::string> texts;
  std::map<std::string, std::string> options;
  std::optional<ExpectedError> expect_error;
  std::optional<std::vector<ExpectedWarning>> warnings;  // an empty list: no warning at all
  std::optional<std::vector<ScenarioStep>> steps;
  /// What `plcxx prove` proves of the program, and what is watched while the steps run.
  std::vector<MarkedText> properties;
  /// What the machine does around the program while the steps run; may be none.
  std::shared_ptr<const plant::Model> plant;
  /// Of the project, where the scenario names no sources: `sources` are then those of this program, and what it says is
  /// meant where the scenario says nothing.
  std::optional<project::Program> program;
};

using ScenarioOrErrors = std::variant<Scenario, std::vector<ScenarioError>>;

using project::Reach;

/// A scenario without sources takes the program of the plcxx.yaml beside it, or above.
ScenarioOrErrors ReadScenario(const std::string& path, Reach reach = Reach::kProject);
/// As ReadScenario, from a text in memory, which is the tool's own unless `reach` says something else.
ScenarioOrErrors ParseScenario(const std::string& path, const std::string& text, Reach reach = Reach::kAnywhere);

}  // namespace plcxx::scenarios
