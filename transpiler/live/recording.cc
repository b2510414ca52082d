#include "transpiler/live/recording.h"

#include <algorithm>
#include <filesystem>
#include <variant>

#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/yaml/words.h"

namespace plcxx::live {
namespace {

std::string Word(const std::string& text) { return yaml::YamlWord(text, "_./"); }

/// Steps as they come, neighbours of one kind as one.
class StepWriter {
 public:
  void Run(const Advance& advance, uint64_t count) {
    if (count == 0) return;
    switch (advance.kind) {
      case AdvanceKind::kMs:
        Append("run", "ms", advance.ms * count);
        return;
      case AdvanceKind::kSlowPeriod:
      case AdvanceKind::kFastPeriod:
        has_parts = true;
        return;
    }
  }
  void Value(const std::string& step, const Action& action) {
    const dialects::Location& location = action.location;
    const std::string value = action.kind == ActionKind::kText
                                  ? Word(action.text)
                                  : sim::ValueDigits(location.place.type, action.value, scenarios::SignOf(location));
    // One location twice in a step would be one key twice.
    if (step != step_ || std::ranges::find(names_, action.name) != names_.end()) Begin(step);
    names_.push_back(action.name);
    items_.push_back(Word(action.name) + ": " + value);
  }
  void Name(const std::string& step, const std::string& name) {
    if (step != step_) Begin(step);
    items_.push_back(Word(name));
  }
  void Whole(const std::string& line) {
    Flush();
    text_ += line;
  }
  std::string Take() {
    Flush();
    return std::move(text_);
  }
  bool has_parts = false;  // a stretch that no step alone stands for

 private:
  void Append(const std::string& step, const std::string& key, uint64_t count) {
    if (step_ != "run") Begin(step);
    if (items_.empty()) {
      items_.push_back(key);
      run_ = 0;
    }
    run_ += count;
  }
  void Begin(std::string step) {
    Flush();
    step_ = std::move(step);
  }
  void Flush() {
    if (items_.empty()) return;
    if (step_ == "run") {
      text_ += "- run: {ms: " + std::to_string(run_) + "}\n";
    } else {
      const bool is_list = step_ == "release";
      text_ += "- " + step_ + ": " + (is_list ? "[" : "{");
      for (size_t i = 0; i < items_.size(); ++i) text_ += (i == 0 ? "" : ", ") + items_[i];
      text_ += is_list ? "]\n" : "}\n";
    }
    items_.clear();
    names_.clear();
    step_.clear();
  }

  std::string text_, step_;
  std::vector<std::string> items_, names_;
  uint64_t run_ = 0;
};

/// False: it has no step.
bool Write(const Action& action, StepWriter& steps) {
  switch (action.kind) {
    case ActionKind::kSet:
    case ActionKind::kText:
      steps.Value("set", action);
      return true;
    case ActionKind::kForce:
      steps.Value("force", action);
      return true;
    case ActionKind::kExpect:
      steps.Value("expect", action);
      return true;
    case ActionKind::kRelease:
      steps.Name("release", action.name);
      return true;
    case ActionKind::kPowerCycle:
      steps.Whole("- power_cycle: {}\n");
      return true;
    case ActionKind::kExpectMessages: {
      std::string list;
      for (const std::string& message : action.messages) list += (list.empty() ? "" : ", ") + Word(message);
      steps.Whole("- expect_messages: [" + list + "]\n");
      return true;
    }
    case ActionKind::kSwitchOff:
    case ActionKind::kSwitchOn:
      return false;
  }
  return false;
}

}  // namespace

bool IsScenarioName(const std::string& name) {
  constexpr size_t kMost = 64;
  constexpr std::string_view kEnd = ".yaml";
  if (!name.ends_with(kEnd) || name.size() <= kEnd.size() || name.size() > kMost) return false;
  const std::string_view stem = std::string_view(name).substr(0, name.size() - kEnd.size());
  return stem.front() != '-' && std::ranges::all_of(stem, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
         });
}

Recording WriteRecording(const compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                         const Timeline& timeline, const std::string& directory) {
  Recording recording;
  if (!timeline.is_between()) {
    recording.refusal = "the period is half done: complete it first";
    return recording;
  }
  StepWriter steps;
  uint64_t at = 0;
  const auto run_to = [&](uint64_t period) {
    while (at < period) {
      // As far as the same stretch goes.
      const auto behind = std::ranges::upper_bound(timeline.stretches(), at, {}, &Stretch::first);
      const uint64_t end = behind == timeline.stretches().end() ? period : std::min(period, behind->first);
      steps.Run(timeline.AdvanceOf(at), end - at);
      at = end;
    }
  };
  for (const Entry& entry : timeline.entries()) {
    if (entry.period > timeline.period()) break;
    run_to(entry.period);
    if (!Write(entry.action, steps)) {
      recording.refusal = "statements were switched off or on, and a scenario cannot do that";
      return recording;
    }
  }
  run_to(timeline.period());
  if (steps.has_parts) {
    recording.refusal = "a scenario was opened that runs parts alone: begin anew to record";
    return recording;
  }
  std::string written = steps.Take();
  if (written.empty()) {
    recording.refusal = "nothing has been done yet";
    return recording;
  }
  recording.yaml = "# Recorded with plcxx live.\n" + scenarios::ScenarioHeading(compilation, request, directory) +
                   scenarios::PlantHeading(timeline.plant().get(), directory) + "steps:\n" + written;
  return recording;
}

Recording CheckedRecording(compilation::Compilation& compilation, const compilation::CompilationRequest& request,
                           const Timeline& timeline, const std::string& directory, const std::string& name) {
  Recording recording = WriteRecording(compilation, request, timeline, directory);
  if (!recording.refusal.empty()) return recording;
  const std::string path = (std::filesystem::path(directory) / name).generic_string();
  scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, recording.yaml);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    recording.refusal = ToText(errors->front());
    return recording;
  }
  scenarios::ScenarioProgram program(compilation);
  const scenarios::ScenarioResult ran = scenarios::TestScenario(std::get<scenarios::Scenario>(read), {}, program);
  if (ran.test.outcome != scenarios::TestOutcome::kPassed) recording.refusal = "it does not pass: " + ran.test.text;
  return recording;
}

}  // namespace plcxx::live
