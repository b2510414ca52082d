#include "transpiler/review/diff/stimulus.h"

#include <algorithm>
#include <set>
#include <string_view>

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

Stimuli PowerOnWith(const std::vector<prove::diff::SetCell>& kept) {
  if (kept.empty()) return {};
  return {{.inputs = {}, .words = {}, .power_cycle = true, .kept = kept}};
}

Stimuli Folded(const Stimuli& stimuli) {
  constexpr size_t kLongestPiece = 4, kLeastTimes = 3;
  Stimuli folded;
  for (size_t at = 0; at < stimuli.size();) {
    const size_t begin = at;
    for (size_t length = 1; length <= kLongestPiece && at == begin; ++length) {
      const auto piece = stimuli.begin() + static_cast<std::ptrdiff_t>(at);
      size_t times = 1;
      while (at + (times + 1) * length <= stimuli.size() &&
             std::equal(piece, piece + static_cast<std::ptrdiff_t>(length),
                        piece + static_cast<std::ptrdiff_t>(times * length))) {
        ++times;
      }
      if (times < kLeastTimes) continue;
      folded.push_back({.inputs = {},
                        .words = {},
                        .repeated = Stimuli(piece, piece + static_cast<std::ptrdiff_t>(length)),
                        .times = static_cast<uint32_t>(times)});
      at += times * length;
    }
    if (at != begin) continue;
    folded.push_back(stimuli[at++]);
    // What is repeated already, and once more before it and after it.
    if (folded.back().repeated.empty()) continue;
    Stimulus last = std::move(folded.back());
    folded.pop_back();
    const Stimuli& body = last.repeated;
    const auto length = static_cast<std::ptrdiff_t>(body.size());
    while (folded.size() >= body.size() && std::equal(body.begin(), body.end(), folded.end() - length)) {
      folded.erase(folded.end() - length, folded.end());
      ++last.times;
    }
    while (stimuli.size() - at >= body.size() &&
           std::equal(body.begin(), body.end(), stimuli.begin() + static_cast<std::ptrdiff_t>(at))) {
      at += body.size();
      ++last.times;
    }
    folded.push_back(std::move(last));
  }
  return folded;
}

void WrittenSteps::AddPowerCycle() {
  scenario += "- power_cycle: {}\n";
  AddTo(line, "power off and on");
}

void WrittenSteps::AddSets(const std::vector<std::pair<std::string, std::string>>& words) {
  std::string assignments;
  std::set<std::string_view> names;  // of this step
  for (const auto& [name, value] : words) {
    // A step sets a location once, and the order matters: a text is sent twice, a bit is set after its byte.
    if (!names.insert(name).second) {
      scenario += "- set: {" + assignments + "}\n";
      assignments.clear();
      names = {name};
    }
    AddTo(assignments, StepWord(name) + ": " + StepWord(value));
    AddTo(line, name + "=" + value);
  }
  if (!assignments.empty()) scenario += "- set: {" + assignments + "}\n";
}

void WrittenSteps::Add(const Stimulus& stimulus) {
  AddSets(stimulus.words);
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

void WrittenSteps::AddRepeated(const WrittenSteps& steps, uint32_t times) {
  scenario += "- repeat:\n    times: " + std::to_string(times) + "\n    steps:\n";
  for (size_t begin = 0; begin < steps.scenario.size();) {
    const size_t end = steps.scenario.find('\n', begin) + 1;
    scenario += "    " + steps.scenario.substr(begin, end - begin);
    begin = end;
  }
  AddTo(line, std::to_string(times) + " times (" + steps.line + ")");
}

}  // namespace plcxx::review::diff
