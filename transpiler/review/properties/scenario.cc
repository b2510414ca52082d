#include "transpiler/review/properties/scenario.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "transpiler/prove/machine/transition.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/yaml/words.h"

namespace plcxx::review::properties {
namespace {

using execute::CellId;

std::string Scalar(const std::string& text) { return yaml::YamlWord(text, "_./"); }

std::string Heading(const scenarios::ProveMachine& machine, const compilation::CompilationRequest& request,
                    const prove::properties::Property& property, const scenarios::BoundPlant* plant,
                    const std::string& directory) {
  const std::string text = property.kind == prove::properties::PropertyKind::kNeverStuck
                               ? "# A run behind which no inputs move the output in time.\n"
                               : "# A run that violates the property: it passes when the program has been repaired.\n";
  return text + scenarios::ScenarioHeading(machine.compilation, request, directory) +
         scenarios::PlantHeading(plant, directory) + "properties:\n- " + Scalar(property.text) + "\n";
}

/// Steps in one line: what comes again and again is said once.
std::string Line(const std::vector<std::string>& steps) {
  constexpr size_t kLongestCycle = 12, kLeastTimes = 3;
  std::string line;
  const auto add = [&line](const std::string& text) { line += (line.empty() ? "" : ", ") + text; };
  const auto joined = [&steps](size_t begin, size_t count) {
    std::string text;
    for (size_t i = begin; i < begin + count; ++i) text += (i == begin ? "" : ", ") + steps[i];
    return text;
  };
  for (size_t at = 0; at < steps.size();) {
    size_t length = 1, times = 1;
    for (size_t cycle = 1; cycle <= kLongestCycle && at + 2 * cycle <= steps.size(); ++cycle) {
      size_t same = cycle;
      while (at + same < steps.size() && steps[at + same] == steps[at + same - cycle]) ++same;
      if (same / cycle < kLeastTimes || same / cycle * cycle <= length * times) continue;
      length = cycle;
      times = same / cycle;
    }
    add(times == 1 ? steps[at] : std::to_string(times) + " times (" + joined(at, length) + ")");
    at += length * times;
  }
  return line;
}

/// Values as a scenario sets them: with their sign, or as the floating-point numbers that they are.
class InputTexts {
 public:
  explicit InputTexts(const scenarios::ProveMachine& machine)
      : dialect_(*machine.compilation.dialect), names_(machine.compilation.program) {}
  std::string Of(const scenarios::InputWord& word, uint64_t value) const {
    const std::optional<dialects::Location> location = dialect_.locate(names_, word.name);
    return location ? sim::ValueDigits(location->place.type, value, scenarios::SignOf(*location))
                    : std::to_string(value);
  }

 private:
  const dialects::Dialect& dialect_;
  ir::NameIndex names_;
};

/// Some controls keep memory only when the program has asked for it: by which bit; empty: nothing is kept, or always.
std::string KeptBy(const scenarios::ProveMachine& machine, const prove::properties::PropertyRun& run) {
  const ir::Program& program = machine.compilation.program;
  const ir::PlaceId asked = program.schedule.retain_at_power_off;
  const bool is_kept = std::ranges::any_of(run.before_power_on, [&](const prove::properties::InputValue& value) {
    return prove::machine::IsRetentive(machine.version, value.cell);
  });
  if (!is_kept || !asked.valid()) return {};
  return scenarios::WordsOf(machine, execute::CellsOf(program, machine.version.cells, program.places[asked]))
      .front()
      .name;
}

/// The control brings whole bytes back: what stands in one beside what the program uses need not have a name.
prove::properties::PropertyRun WithoutUnused(const scenarios::ProveMachine& machine,
                                             const prove::properties::PropertyRun& told) {
  const prove::machine::Uses uses = prove::machine::UsesOf(machine.version);
  prove::properties::PropertyRun run = told;
  std::erase_if(run.before_power_on, [&](const prove::properties::InputValue& stored) {
    if (uses.reads[stored.cell.index] || uses.writes[stored.cell.index]) return false;
    return scenarios::WordsOf(machine, {stored.cell}).front().name.empty();
  });
  return run;
}

/// The steps of the run; false: an input has no name.
bool WriteSteps(const scenarios::ProveMachine& machine, const prove::properties::PropertyRun& told,
                PropertyScenario& scenario) {
  const prove::properties::PropertyRun run = WithoutUnused(machine, told);
  std::vector<CellId> cells;
  for (const prove::properties::InputValue& stored : run.before_power_on) cells.push_back(stored.cell);
  for (const auto& period : run.periods) {
    for (const auto& part : period) {
      for (const prove::properties::InputValue& input : part) {
        if (std::ranges::find(cells, input.cell) == cells.end()) cells.push_back(input.cell);
      }
    }
  }
  std::ranges::sort(cells);
  const std::vector<scenarios::InputWord> words = scenarios::WordsOf(machine, cells);
  if (std::ranges::any_of(words, [](const scenarios::InputWord& word) { return word.name.empty(); })) return false;
  const ir::Program& program = machine.compilation.program;
  const ir::Schedule& schedule = program.schedule;
  const bool by_slices = machine.slices > 1 && !run.periods.empty() && run.periods.front().size() > 1;
  const bool by_slow = machine.slices > 1 && !by_slices;
  const uint32_t part_ms = by_slices               ? schedule.period_ms / machine.slices
                           : schedule.fast_ms != 0 ? schedule.fast_ms
                                                   : schedule.period_ms;
  const std::string time = std::to_string(part_ms);
  // A scenario sets whole words: what the run does not name of them is as it was when power came.
  std::map<CellId, bool> now;
  for (const scenarios::InputWord& word : words) {
    for (const CellId id : word.cells) now[id] = prove::machine::PowerOnValue(machine.version, id);
  }
  const InputTexts texts(machine);
  uint32_t runs = 0;  // parts without a change in between
  std::string steps;
  std::vector<std::string> lines;
  const auto add_line = [&lines](const std::string& part) { lines.push_back(part); };
  const auto flush = [&] {
    if (runs == 0) return;
    const std::string count = by_slow ? std::to_string(runs) : std::to_string(uint64_t{runs} * std::stoul(time));
    steps += by_slow ? "- run: {slow: " + count + "}\n" : "- run: {ms: " + count + "}\n";
    add_line(by_slow ? "slow " + count : count + " ms");
    runs = 0;
  };
  const auto set = [&](const std::vector<prove::properties::InputValue>& part) {
    for (const prove::properties::InputValue& input : part) now[input.cell] = input.value;
    std::string sets;
    for (const scenarios::InputWord& word : words) {
      const bool changes = std::ranges::any_of(part, [&](const prove::properties::InputValue& input) {
        return std::ranges::find(word.cells, input.cell) != word.cells.end();
      });
      if (!changes) continue;
      uint64_t value = 0;
      for (size_t i = 0; i < word.cells.size(); ++i) value |= uint64_t{now[word.cells[i]] ? 1U : 0U} << i;
      const std::string text = texts.Of(word, value);
      sets += (sets.empty() ? "" : ", ") + Scalar(word.name) + ": " + text;
      add_line(word.name + "=" + text);
    }
    if (!sets.empty()) steps += "- set: {" + sets + "}\n";
  };
  if (!run.before_power_on.empty()) {
    set(run.before_power_on);
    if (const std::string bit = KeptBy(machine, run); !bit.empty()) {
      steps += "- set: {" + Scalar(bit) + ": 1}\n";
      add_line(bit + "=1");
    }
    steps += "- power_cycle: {}\n";
    add_line("power cycle");
  }
  for (const auto& period : run.periods) {
    for (const auto& part : period) {
      if (!part.empty()) flush();
      set(part);
      ++runs;
    }
  }
  flush();
  scenario.steps = Line(lines);
  scenario.yaml += "steps:\n" + steps;
  return true;
}

}  // namespace

PropertyScenario MakePropertyScenario(const scenarios::ProveMachine& machine,
                                      const compilation::CompilationRequest& request,
                                      const prove::properties::Property& property,
                                      const prove::properties::PropertyResult& result, const ScenarioPlace& place) {
  PropertyScenario scenario;
  const bool is_stuck = property.kind == prove::properties::PropertyKind::kNeverStuck;
  scenario.yaml = Heading(machine, request, property, result.run->has_plant ? place.plant : nullptr, place.directory);
  if (!WriteSteps(machine, *result.run, scenario)) {
    scenario.reason = "an input has no name that a scenario can set";
    return scenario;
  }
  if (is_stuck) {
    const uint64_t ms = uint64_t{property.periods} * machine.compilation.program.schedule.period_ms;
    scenario.yaml +=
        "- run: {" + (machine.slices > 1 ? "slow: " + std::to_string(property.periods) : "ms: " + std::to_string(ms)) +
        "}\n- expect: {" + Scalar(property.operands.front().text) + ": " + (result.stuck_at ? "1" : "0") + "}\n";
  }
  const std::string path = (std::filesystem::path(place.directory) / place.name).generic_string();
  scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, scenario.yaml);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    scenario.reason = ToText(errors->front());
    return scenario;
  }
  // The program as it was asked for: the directory of the scenario need not be there yet.
  scenarios::ScenarioProgram program(request);
  const scenarios::ScenarioResult ran = scenarios::TestScenario(std::get<scenarios::Scenario>(read), {}, program);
  const bool violates =
      ran.test.outcome == scenarios::TestOutcome::kFailed && ran.test.text.find("property '") != std::string::npos;
  if (is_stuck ? ran.test.outcome == scenarios::TestOutcome::kPassed : violates) return scenario;
  scenario.reason = ran.test.outcome == scenarios::TestOutcome::kPassed
                        ? "the simulation, with its slices and its simulated control, does not show it"
                        : ran.test.text.substr(0, ran.test.text.find('\n'));
  return scenario;
}

}  // namespace plcxx::review::properties
