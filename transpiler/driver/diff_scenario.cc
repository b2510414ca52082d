// From a difference to a scenario that shows it: shortened as far as it still does, and run on both versions.
#include <algorithm>
#include <filesystem>
#include <set>
#include <variant>

#include "transpiler/driver/diff_calls.h"
#include "transpiler/driver/diff_machine.h"
#include "transpiler/driver/diff_runs.h"
#include "transpiler/driver/diff_shorten.h"
#include "transpiler/driver/scenario.h"
#include "transpiler/driver/scenario_suite.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::driver {
namespace {

using prove::CellId;

constexpr size_t kMostShown = 12;  // of what one step sets, in the line of text; the scenario has all

/// As the old version names the cell, or the new one where only that one does; the cells are the old version's.
CellWord WordOfBoth(const CounterexampleRequest& request, CellId old_cell) {
  CellWord word = request.old_words.WordOf(old_cell);
  const CellId new_cell = request.match.new_of_old[old_cell.index];
  if (word.place || !new_cell.valid()) return word;
  CellWord other = request.new_words.WordOf(new_cell);
  if (!other.place) return word;
  for (CellId& cell : other.cells) {
    cell = request.match.old_of_new[cell.index];
    if (!cell.valid()) return word;
  }
  return other;
}

/// A part of a timer that is nobody else's, or the calls of a function: no location of a scenario.
bool HasNoName(const CellWord& word) { return !word.place && word.cells.size() == 1; }

/// A value as a scenario writes it.
std::string ValueText(const CellWord& word, uint64_t value) {
  const bool is_float = word.place && sim::IsFloat(word.place->type);
  return is_float ? sim::ValueDigits(word.place->type, value) : std::to_string(value);
}

/// Inputs as a scenario writes them: whole words where the program has no bit of that name.
std::vector<std::pair<std::string, std::string>> SetsOf(const CounterexampleRequest& request,
                                                        const std::vector<prove::SetCell>& inputs,
                                                        std::map<CellId, uint64_t>& now) {
  std::vector<CellWord> words;
  std::set<std::string> taken;
  for (const prove::SetCell& input : inputs) {
    now[input.old_cell] = input.value;
    CellWord word = WordOfBoth(request, input.old_cell);
    if (HasNoName(word)) continue;
    if (taken.insert(word.name).second) words.push_back(std::move(word));
  }
  std::vector<std::pair<std::string, std::string>> sets;
  for (const CellWord& word : words) {
    uint64_t value = 0;
    for (size_t i = 0; i < word.cells.size() && i < 64; ++i) {
      const auto cell = now.find(word.cells[i]);
      if (cell != now.end()) value |= cell->second << i;
    }
    sets.emplace_back(word.name, ValueText(word, value));
  }
  return sets;
}

std::string Quoted(const std::string& text) {
  const bool plain = std::ranges::all_of(text, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '.' ||
           c == '-';
  });
  if (plain && !text.empty()) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string RelativePath(const std::string& path, const std::string& directory) {
  std::error_code error;
  const std::filesystem::path from = std::filesystem::absolute(directory.empty() ? "." : directory, error);
  const std::filesystem::path to = std::filesystem::absolute(path, error).lexically_normal();
  const std::filesystem::path relative = to.lexically_relative(from.lexically_normal());
  return relative.empty() ? path : relative.generic_string();
}

std::string Heading(const DiffSide& side, const DiffOptions& options) {
  std::string text = "dialect: " + std::string(side.compilation.dialect->name) + "\nsources: [";
  std::string separator;
  for (const std::string& source : side.request.sources) {
    const std::string path = (std::filesystem::path(side.scenario_base) / source).string();
    text += separator + Quoted(RelativePath(path, options.scenario_directory));
    separator = ", ";
  }
  text += "]\n";
  if (!side.request.options.empty()) {
    text += "options: {";
    separator.clear();
    for (const auto& [key, value] : side.request.options) {
      // A value that is a file of the program is named from where the scenario stands.
      std::error_code error;
      const bool is_file =
          std::filesystem::is_regular_file(std::filesystem::path(side.request.base_directory) / value, error);
      const std::string written = is_file ? RelativePath((std::filesystem::path(side.scenario_base) / value).string(),
                                                         options.scenario_directory)
                                          : value;
      text += separator + Quoted(key) + ": " + Quoted(written);
      separator = ", ";
    }
    text += "}\n";
  }
  return text;
}

/// Whether a scenario passes: run in the simulator.
bool Passes(const std::string& scenario, ScenarioProgram& program, const DiffOptions& options) {
  const std::string path = (std::filesystem::path(options.scenario_directory) / "counterexample.yaml").string();
  ScenarioOrErrors read = ParseScenario(path, scenario);
  if (!std::holds_alternative<Scenario>(read)) return false;
  SuiteOptions suite;
  suite.platforms.clear();
  suite.simulator = false;  // then it is one that does not note who wrote what
  return TestScenario(std::get<Scenario>(read), suite, program).test.outcome == TestOutcome::kPassed;
}

uint32_t PeriodMs(const DiffSide& side) { return side.compilation.program.schedule.period_ms; }

struct Candidate {
  Stimuli stimuli;
  bool from_state = false;
};
/// The runs that may show the difference, the best one first.
std::vector<Candidate> Candidates(const DiffSide& old_side, const CounterexampleRequest& request) {
  std::vector<Candidate> candidates;
  if (request.run) {
    // An arbitrary state is set before the first period; later inputs stay.
    Stimuli by_pass, by_time;
    for (const std::vector<prove::SetCell>& inputs : request.run->periods) {
      by_pass.push_back({.inputs = inputs, .words = {}, .slow = 1});
      by_time.push_back({.inputs = inputs, .words = {}, .ms = PeriodMs(old_side)});
    }
    candidates.push_back({std::move(by_pass), request.run->from_state});
    // The slow part may be in slices, or the fast part have a time of its own: what the proof takes for one period is
    // seen in a part of the pass only, or when time passes.
    candidates.push_back({std::move(by_time), request.run->from_state});
  }
  const RandomRuns::Difference* shortest = nullptr;
  for (const CellId cell : request.old_cells) {
    const auto found = request.runs.difference_of.find(cell);
    if (found == request.runs.difference_of.end()) continue;
    if (shortest == nullptr || found->second.periods < shortest->periods) shortest = &found->second;
  }
  if (shortest != nullptr) {
    const Stimuli& run = request.runs.runs[shortest->run];
    candidates.push_back({Stimuli(run.begin(), run.begin() + shortest->steps)});
  }
  return candidates;
}

/// Both versions behind the last stimulus.
struct Ends {
  DiffMachine old_machine, new_machine;
};

/// Where the item differs, and its values there.
struct SeenDifference {
  CellWord word;
  uint64_t old_value = 0, new_value = 0;
};
SeenDifference FindSeen(const CounterexampleRequest& request, const Ends& ends) {
  SeenDifference seen;
  for (const CellId cell : request.old_cells) {
    seen = {.word = WordOfBoth(request, cell)};
    const std::vector<CellId> cells = seen.word.cells.empty() ? std::vector{cell} : seen.word.cells;
    for (size_t i = 0; i < cells.size() && i < 64; ++i) {
      const CellId new_cell = request.match.new_of_old[cells[i].index];
      const uint32_t shift = cells.size() == 1 ? 0 : static_cast<uint32_t>(i);
      seen.old_value |= ends.old_machine.Seen(cells[i]) << shift;
      if (new_cell.valid()) seen.new_value |= ends.new_machine.Seen(new_cell) << shift;
    }
    if (seen.old_value != seen.new_value) break;
  }
  return seen;
}

/// The steps of a scenario, and the same in one line.
struct WrittenSteps {
  std::string scenario, line;
};
WrittenSteps Write(const DiffSide& old_side, const CounterexampleRequest& request, const Stimuli& stimuli) {
  WrittenSteps written;
  std::map<CellId, uint64_t> now;
  const auto add = [](std::string& text, const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const Stimulus& stimulus : stimuli) {
    std::vector<std::pair<std::string, std::string>> sets = SetsOf(request, stimulus.inputs, now);
    sets.insert(sets.end(), stimulus.words.begin(), stimulus.words.end());
    std::erase_if(sets, [&old_side](const auto& set) {
      return !old_side.compilation.dialect->locate(old_side.compilation.program, set.first);
    });
    std::string assignments;
    for (const auto& [name, value] : sets) add(assignments, Quoted(name) + ": " + Quoted(value));
    for (size_t i = 0; i < sets.size() && i < kMostShown; ++i) {
      add(written.line, sets[i].first + "=" + sets[i].second);
    }
    if (sets.size() > kMostShown) add(written.line, std::to_string(sets.size() - kMostShown) + " more");
    if (!sets.empty()) written.scenario += "- set: {" + assignments + "}\n";
    const bool by_pass = stimulus.slow != 0;
    const std::string count = std::to_string(by_pass ? stimulus.slow : stimulus.ms);
    written.scenario += std::string("- run: {") + (by_pass ? "slow: " : "ms: ") + count + "}\n";
    add(written.line, by_pass ? "slow " + count : count + " ms");
  }
  return written;
}

/// The last step of the scenario, with the values of both; none where no scenario can tell.
std::optional<std::string> Expectation(const DiffSide& old_side, const DiffSide& new_side,
                                       const CounterexampleRequest& request, const Ends& ends,
                                       Counterexample& example) {
  if (request.kind == ItemKind::kCalls) {
    const ir::Program &old_program = old_side.compilation.program, &new_program = new_side.compilation.program;
    const prove::Version version = prove::MakeVersion(old_side.whole);
    const ir::HostFunctionId id(request.old_cells.front().index - version.cells.calls);
    const std::string& function = old_side.whole.host_functions[id].name;
    const std::vector<sim::HostEvent>&old_events = ends.old_machine.events(), &new_events = ends.new_machine.events();
    const FirstDifferentCall call = FindDifferentCall(old_program, old_events, new_program, new_events, function);
    example.old_value = call.old_text;
    example.new_value = call.new_text;
    const std::optional<std::string> calls = ExpectedCalls(old_program, old_events, function);
    if (!calls) return std::nullopt;
    return "expect_calls: " + *calls;
  }
  const SeenDifference seen = FindSeen(request, ends);
  example.old_value = ValueText(seen.word, seen.old_value);
  example.new_value = ValueText(seen.word, seen.new_value);
  // What the language has no name for is seen in the simulator, and in no scenario.
  if (HasNoName(seen.word)) return std::nullopt;
  if (!old_side.compilation.dialect->locate(old_side.compilation.program, seen.word.name)) return std::nullopt;
  return "expect: {" + Quoted(seen.word.name) + ": " + example.old_value + "}";
}

Counterexample Describe(DiffSide& old_side, DiffSide& new_side, const CounterexampleRequest& request,
                        const Stimuli& stimuli, const DiffOptions& options, ExampleBudget& budget) {
  Counterexample example;
  WrittenSteps steps = Write(old_side, request, stimuli);
  example.steps = std::move(steps.line);
  const prove::Version old_version = prove::MakeVersion(old_side.whole),
                       new_version = prove::MakeVersion(new_side.whole);
  const auto begin = std::chrono::steady_clock::now();
  Ends ends{DiffMachine(old_side, old_version), DiffMachine(new_side, new_version)};
  for (const Stimulus& stimulus : stimuli) {
    ends.old_machine.Apply(stimulus, &prove::SetCell::old_cell);
    ends.new_machine.Apply(stimulus, &prove::SetCell::new_cell);
  }
  ends.old_machine.Look();
  ends.new_machine.Look();
  const std::optional<std::string> expectation = Expectation(old_side, new_side, request, ends, example);
  if (!expectation) return example;
  const bool is_value = request.kind != ItemKind::kCalls;
  const std::string heading =
      is_value ? "# " + request.name + " is " + example.old_value + " in the old version and " + example.new_value
               : "# " + request.name + ": " + example.old_value + " in the old version, " + example.new_value;
  example.scenario = heading + " in the new one.\n" + Heading(old_side, options) + "steps:\n" + steps.scenario + "- " +
                     *expectation + "\n";
  // To run it once more costs about the same.
  const auto now = std::chrono::steady_clock::now();
  example.confirmed = now + (now - begin) < budget.all_end && Passes(example.scenario, budget.old_program, options) &&
                      !Passes(example.scenario, budget.new_program, options);
  return example;
}

}  // namespace

std::optional<Counterexample> FindCounterexample(DiffSide& old_side, DiffSide& new_side,
                                                 const CounterexampleRequest& request, const DiffOptions& options,
                                                 ExampleBudget& budget) {
  const prove::Version old_version = prove::MakeVersion(old_side.whole),
                       new_version = prove::MakeVersion(new_side.whole);
  std::vector<CellId> new_cells;
  for (const CellId cell : request.old_cells) new_cells.push_back(request.match.new_of_old[cell.index]);
  Shortener shortener(old_side, new_side, old_version, new_version, request.old_cells, new_cells, budget.end);
  for (Candidate& candidate : Candidates(old_side, request)) {
    if (!shortener.Shows(candidate.stimuli, budget.last_end)) continue;
    --budget.left;
    const Stimuli shortened = shortener.Shorten(std::move(candidate.stimuli));
    Counterexample example = Describe(old_side, new_side, request, shortened, options, budget);
    example.from_state = candidate.from_state;
    return example;
  }
  return std::nullopt;
}

}  // namespace plcxx::driver
