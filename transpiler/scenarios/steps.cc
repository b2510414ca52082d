// The steps of a scenario, read from YAML.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "transpiler/scenarios/reader.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::scenarios {
namespace {

constexpr std::string_view kSteps[] = {
    "set", "run", "expect", "force", "release", "expect_calls", "expect_messages", "power_cycle", "repeat"};
constexpr size_t kMostSteps = 300'000;  // of a scenario, each counted as often as it is repeated
constexpr uint32_t kMostNested = 8;

std::string ColonAfter(std::string_view step) {
  return "write '" + std::string(step) + ": ', with a colon and a blank, before what the step is about";
}

}  // namespace

std::vector<ScenarioStep> ScenarioReader::ReadSteps(const YAML::Node& node) {
  std::vector<ScenarioStep> steps;
  if (!node.IsSequence()) {
    Fail(Mark(node), "'steps' is a list");
    return steps;
  }
  for (const YAML::Node& item : node) {
    const auto number = static_cast<uint32_t>(steps.size() + 1);
    ScenarioStep step{.number = number, .name = {}, .mark = Mark(item), .action = {}};
    if (const std::string_view words = item.IsScalar() ? std::string_view(item.Scalar()) : std::string_view();
        !words.empty()) {
      const std::string_view first = words.substr(0, words.find_first_of(" {[:"));
      const bool known = std::ranges::find(kSteps, first) != std::ranges::end(kSteps);
      Fail(step.mark, "'" + std::string(words) + "' is no step",
           known ? ColonAfter(first) : "a step is '- key: value'");
      steps.push_back(std::move(step));
      continue;
    }
    const std::vector<YamlEntry> entries = Map(item, "a step");
    if (entries.size() > 1) {
      Fail(entries[1].key.mark, "a step has one key; '" + entries[1].key.text + "' begins another step");
    } else if (item.IsMap() && entries.empty()) {
      Fail(step.mark, "a step without a key");
    }
    if (!entries.empty() && entries[0].key.text == "repeat") {
      ReadRepeat(entries[0], steps);
      continue;
    }
    if (!entries.empty()) {
      step.name = entries[0].key.text;
      if (std::optional<StepAction> action = ReadAction(entries[0])) step.action = std::move(*action);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

void ScenarioReader::ReadRepeat(const YamlEntry& entry, std::vector<ScenarioStep>& steps) {
  std::optional<uint32_t> times;
  std::optional<std::vector<ScenarioStep>> repeated;
  if (repeats_ == kMostNested) {
    Fail(entry.key.mark, "'repeat' stands in " + std::to_string(kMostNested) + " others, and may not in more");
    return;
  }
  ++repeats_;
  for (const YamlEntry& part : Map(entry.value, "'repeat'")) {
    if (part.key.text == "times") {
      times = Number(part.value, "'times'");
    } else if (part.key.text == "steps") {
      repeated = ReadSteps(part.value);
    } else {
      RefuseKey(part.key, "'repeat'", {"times", "steps"});
    }
  }
  --repeats_;
  if (!times || !repeated) {
    if (entry.value.IsMap() && errors().empty()) Fail(entry.key.mark, "'repeat' needs 'times' and 'steps'");
    return;
  }
  if (!repeated->empty() && *times > (kMostSteps - std::min(kMostSteps, steps.size())) / repeated->size()) {
    Fail(entry.key.mark, "a scenario has at most " + std::to_string(kMostSteps) + " steps, repeated ones counted");
    return;
  }
  for (uint32_t i = 0; i < *times; ++i) {
    for (const ScenarioStep& step : *repeated) {
      steps.push_back(step);
      steps.back().number = static_cast<uint32_t>(steps.size());
    }
  }
}

std::optional<StepAction> ScenarioReader::ReadAction(const YamlEntry& entry) {
  const std::string& key = entry.key.text;
  if (key == "set") return SetStep{Assignments(entry.value, "'set'")};
  if (key == "run") return ReadRun(entry.value);
  if (key == "expect") return ExpectStep{Assignments(entry.value, "'expect'")};
  if (key == "force") return ForceStep{Assignments(entry.value, "'force'")};
  if (key == "release") return ReleaseStep{Locations(entry.value)};
  if (key == "expect_calls") return ReadCalls(entry.value);
  if (key == "expect_messages") return ReadMessages(entry.value);
  if (key == "power_cycle") {
    if (!entry.value.IsNull() && !(entry.value.IsMap() && entry.value.size() == 0)) {
      Fail(Mark(entry.value), "'power_cycle' has no parameters: write 'power_cycle: {}'");
    }
    return PowerCycleStep{};
  }
  const std::string_view near = support::NearestWord(key, kSteps);
  for (const std::string_view step : kSteps) {
    if (!key.starts_with(step) || std::string_view(" {[:").find(key[step.size()]) == std::string_view::npos) continue;
    Fail(entry.key.mark, "'" + key + "' is no step", ColonAfter(step));
    return std::nullopt;
  }
  Fail(entry.key.mark, "'" + key + "' is no step; there are: " + support::CommaSeparated(kSteps),
       near.empty() ? "" : "did you mean '" + std::string(near) + "'");
  return std::nullopt;
}

std::vector<Assignment> ScenarioReader::Assignments(const YAML::Node& node, std::string_view what) {
  std::vector<Assignment> assignments;
  for (const YamlEntry& entry : Map(node, what)) {
    std::optional<MarkedText> value = Word(entry.value, "the value of '" + entry.key.text + "'");
    if (value) assignments.push_back({entry.key, std::move(*value)});
  }
  return assignments;
}

std::vector<MarkedText> ScenarioReader::Locations(const YAML::Node& node) {
  std::vector<MarkedText> locations;
  for (const YAML::Node& item : ListOrSingle(node)) {
    if (std::optional<MarkedText> word = Word(item, "a location of 'release'")) locations.push_back(std::move(*word));
  }
  return locations;
}

RunStep ScenarioReader::ReadRun(const YAML::Node& node) {
  RunStep run;
  const std::vector<YamlEntry> entries = Map(node, "'run'");
  if (node.IsMap() && entries.empty()) Fail(Mark(node), "'run' needs one of: slow, fast, ms, s");
  for (const YamlEntry& entry : entries) {
    if (const std::optional<RunPart> part = ReadRunPart(entry)) run.parts.push_back(*part);
  }
  return run;
}

std::optional<RunPart> ScenarioReader::ReadRunPart(const YamlEntry& entry) {
  const std::string& key = entry.key.text;
  if (key == "slow" || key == "fast" || key == "ms") {
    const std::optional<uint32_t> count = Number(entry.value, "'" + key + "'");
    if (!count) return std::nullopt;
    return RunPart{key == "slow"   ? RunUnit::kSlowCycles
                   : key == "fast" ? RunUnit::kFastTicks
                                   : RunUnit::kMilliseconds,
                   *count};
  }
  if (key != "s") {
    RefuseKey(entry.key, "'run'", {"slow", "fast", "ms", "s"});
    return std::nullopt;
  }
  const std::optional<MarkedText> word = Word(entry.value, "'s'");
  if (!word) return std::nullopt;
  double seconds = -1;
  const char* end = word->text.data() + word->text.size();
  const auto [last, error] = std::from_chars(word->text.data(), end, seconds);
  const double ms = std::round(seconds * 1000);
  const bool whole = error == std::errc() && last == end && std::abs(ms - seconds * 1000) < 1e-6;
  if (!whole || ms < 0 || ms > std::numeric_limits<uint32_t>::max()) {
    Fail(word->mark, "'" + word->text + "': 's' is a number of seconds from 0 to 4294967.295, to the millisecond");
    return std::nullopt;
  }
  return RunPart{RunUnit::kMilliseconds, static_cast<uint32_t>(ms)};
}

ExpectCallsStep ScenarioReader::ReadCalls(const YAML::Node& node) {
  ExpectCallsStep step;
  if (!node.IsSequence()) {
    Fail(Mark(node), "'expect_calls' is a list of '{function: {parameter: value}}' and '{function: none}'");
    return step;
  }
  for (const YAML::Node& item : node) {
    if (item.IsScalar()) {
      step.calls.push_back({{item.Scalar(), Mark(item)}, {}});
      continue;
    }
    const std::vector<YamlEntry> entries = Map(item, "a call");
    if (entries.size() > 1)
      Fail(entries[1].key.mark, "a call has one key; '" + entries[1].key.text + "' begins another call");
    if (item.IsMap() && entries.empty()) Fail(Mark(item), "a call without a function");
    if (entries.empty()) continue;
    ExpectedCall call{entries[0].key, {}};
    if (entries[0].value.IsScalar() && entries[0].value.Scalar() == "none") {
      call.none = true;
    } else if (!entries[0].value.IsNull()) {
      call.arguments = Assignments(entries[0].value, "what '" + entries[0].key.text + "' is called with");
    }
    step.calls.push_back(std::move(call));
  }
  return step;
}

ExpectMessagesStep ScenarioReader::ReadMessages(const YAML::Node& node) {
  ExpectMessagesStep step;
  if (!node.IsSequence()) {
    Fail(Mark(node), "'expect_messages' is a list of numbers or texts of messages");
    return step;
  }
  for (const YAML::Node& item : node) {
    if (const std::optional<MarkedText> word = Word(item, "a message")) step.messages.push_back(word->text);
  }
  return step;
}

}  // namespace plcxx::scenarios
