#include "transpiler/review/diff/stimulus.h"

#include "transpiler/yaml/words.h"

namespace plcxx::review::diff {
namespace {

std::string StepWord(const std::string& text) { return yaml::YamlWord(text, "_.-"); }

void AddTo(std::string& text, const std::string& part) { text += (text.empty() ? "" : ", ") + part; }

}  // namespace

Stimulus WithoutWords(const scenarios::KnownStep& step) {
  return {
      .inputs = {}, .words = {}, .slow = step.slow, .ms = step.ms, .fast = step.fast, .power_cycle = step.power_cycle};
}

void WrittenSteps::AddPowerCycle() {
  scenario += "- power_cycle: {}\n";
  AddTo(line, "power off and on");
}

void WrittenSteps::Add(const Stimulus& stimulus) {
  std::string assignments;
  for (const auto& [name, value] : stimulus.words) {
    AddTo(assignments, StepWord(name) + ": " + StepWord(value));
    AddTo(line, name + "=" + value);
  }
  if (!assignments.empty()) scenario += "- set: {" + assignments + "}\n";
  if (stimulus.slow == 0 && stimulus.fast == 0 && stimulus.ms == 0) return;
  if (stimulus.slow == 0 && stimulus.fast == 0) {
    const std::string ms = std::to_string(stimulus.ms);
    scenario += "- run: {ms: " + ms + "}\n";
    AddTo(line, ms + " ms");
    return;
  }
  const std::string part = stimulus.slow != 0 ? "slow" : "fast";
  const std::string count = std::to_string(stimulus.slow != 0 ? stimulus.slow : stimulus.fast);
  scenario += "- run: {" + part + ": " + count + "}\n";
  AddTo(line, part + " " + count);
}

}  // namespace plcxx::review::diff
