// From a difference to a scenario that shows it: shortened as far as it still does, and run on both versions.
#include <algorithm>
#include <filesystem>
#include <set>
#include <variant>

#include "transpiler/driver/diff_machine.h"
#include "transpiler/driver/diff_runs.h"
#include "transpiler/driver/scenario.h"
#include "transpiler/driver/scenario_suite.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::driver {
namespace {

using prove::CellId;

constexpr size_t kMostTries = 400;
constexpr size_t kMostShown = 12;  // of what one step sets, in the line of text; the scenario has all

/// One step in words of a scenario.
struct Words {
  std::vector<std::pair<std::string, std::string>> sets;
  std::string run;  // "slow: 1"
};

class Shortener {
 public:
  Shortener(const DiffSide& old_side, const DiffSide& new_side, const ExampleBudget& budget)
      : old_side_(old_side),
        new_side_(new_side),
        budget_(budget),
        old_version_(prove::MakeVersion(old_side.whole)),
        new_version_(prove::MakeVersion(new_side.whole)) {}

  /// Whether the item differs behind the last stimulus; the values then.
  bool Shows(const Stimuli& stimuli, const std::vector<CellId>& old_cells, const std::vector<CellId>& new_cells) {
    DiffMachine old_machine(old_side_, old_version_), new_machine(new_side_, new_version_);
    for (const Stimulus& stimulus : stimuli) {
      if (!old_machine.Apply(stimulus, &prove::SetCell::old_cell)) return false;
      if (!new_machine.Apply(stimulus, &prove::SetCell::new_cell)) return false;
    }
    old_machine.Look();
    new_machine.Look();
    for (size_t i = 0; i < old_cells.size(); ++i) {
      if (old_machine.Seen(old_cells[i]) != new_machine.Seen(new_cells[i])) return true;
    }
    return false;
  }

  /// Drops steps, then single inputs, then time, as long as the difference stays.
  Stimuli Shorten(Stimuli stimuli, const std::vector<CellId>& old_cells, const std::vector<CellId>& new_cells) {
    size_t tries = 0;
    const auto try_without = [&](Stimuli shorter) {
      if (++tries > kMostTries || std::chrono::steady_clock::now() > budget_.end) return false;
      if (!Shows(shorter, old_cells, new_cells)) return false;
      stimuli = std::move(shorter);
      return true;
    };
    // Halves of the steps first, then smaller pieces; what a dropped step sets goes to the next one.
    for (size_t piece = std::max<size_t>(1, stimuli.size() / 2); piece >= 1; piece /= 2) {
      for (size_t i = 0; i + piece < stimuli.size();) {
        Stimuli shorter;
        std::vector<prove::SetCell> carried;
        std::vector<std::pair<std::string, std::string>> carried_words;
        for (size_t step = 0; step < stimuli.size(); ++step) {
          Stimulus stimulus = stimuli[step];
          std::vector<prove::SetCell> inputs = Merged(carried, stimulus.inputs);
          std::vector<std::pair<std::string, std::string>> words = MergedWords(carried_words, stimulus.words);
          if (step >= i && step < i + piece) {
            carried = std::move(inputs);
            carried_words = std::move(words);
            continue;
          }
          stimulus.inputs = std::move(inputs);
          stimulus.words = std::move(words);
          carried.clear();
          carried_words.clear();
          shorter.push_back(std::move(stimulus));
        }
        if (!try_without(std::move(shorter))) i += piece;
      }
    }
    for (size_t step = 0; step < stimuli.size(); ++step) {
      for (size_t piece = std::max<size_t>(1, stimuli[step].inputs.size() / 2); piece >= 1; piece /= 2) {
        for (size_t i = 0; i < stimuli[step].inputs.size();) {
          Stimuli shorter = stimuli;
          std::vector<prove::SetCell>& inputs = shorter[step].inputs;
          const size_t end = std::min(i + piece, inputs.size());
          inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(i),
                       inputs.begin() + static_cast<std::ptrdiff_t>(end));
          if (!try_without(std::move(shorter))) i += piece;
        }
      }
    }
    for (size_t step = 0; step < stimuli.size(); ++step) {
      for (size_t i = 0; i < stimuli[step].words.size();) {
        Stimuli shorter = stimuli;
        shorter[step].words.erase(shorter[step].words.begin() + static_cast<std::ptrdiff_t>(i));
        if (!try_without(std::move(shorter))) ++i;
      }
    }
    for (Stimulus& stimulus : stimuli) {
      if (stimulus.ms == 0) continue;
      Stimuli shorter = stimuli;
      Stimulus& same = shorter[static_cast<size_t>(&stimulus - stimuli.data())];
      same.ms = 0;
      same.slow = 1;
      if (try_without(std::move(shorter))) break;
    }
    for (size_t step = 0; step < stimuli.size(); ++step) {
      for (const uint32_t ms : {100U, 200U, 500U, 1000U, 2000U, 5000U, 10'000U, 20'000U, 60'000U}) {
        if (stimuli[step].ms <= ms) break;
        Stimuli shorter = stimuli;
        shorter[step].ms = ms;
        if (try_without(std::move(shorter))) break;
      }
    }
    return stimuli;
  }

  const prove::Version& old_version() const { return old_version_; }
  const prove::Version& new_version() const { return new_version_; }

 private:
  static std::vector<std::pair<std::string, std::string>> MergedWords(
      std::vector<std::pair<std::string, std::string>> earlier,
      const std::vector<std::pair<std::string, std::string>>& later) {
    for (const auto& word : later) {
      const auto same = std::ranges::find(earlier, word.first, &std::pair<std::string, std::string>::first);
      if (same == earlier.end()) {
        earlier.push_back(word);
      } else {
        same->second = word.second;
      }
    }
    return earlier;
  }
  static std::vector<prove::SetCell> Merged(std::vector<prove::SetCell> earlier,
                                            const std::vector<prove::SetCell>& later) {
    for (const prove::SetCell& input : later) {
      const auto same = std::ranges::find(earlier, input.old_cell, &prove::SetCell::old_cell);
      if (same == earlier.end()) {
        earlier.push_back(input);
      } else {
        same->value = input.value;
      }
    }
    return earlier;
  }

  const DiffSide& old_side_;
  const DiffSide& new_side_;
  const ExampleBudget& budget_;
  prove::Version old_version_, new_version_;
};

/// Time that passes in several pieces, with nothing set between them, passes in one.
Stimuli Joined(const Stimuli& stimuli) {
  Stimuli joined;
  for (const Stimulus& stimulus : stimuli) {
    const bool sets = !stimulus.inputs.empty() || !stimulus.words.empty();
    if (!joined.empty() && !sets && (joined.back().slow == 0) == (stimulus.slow == 0)) {
      joined.back().slow += stimulus.slow;
      joined.back().ms += stimulus.ms;
    } else {
      joined.push_back(stimulus);
    }
  }
  return joined;
}

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
  return TestScenario(std::get<Scenario>(read), suite, program).test.outcome == TestOutcome::kPassed;
}

}  // namespace

namespace {

uint32_t PeriodMs(const DiffSide& side) { return side.compilation.program.schedule.period_ms; }

}  // namespace

std::optional<Counterexample> FindCounterexample(DiffSide& old_side, DiffSide& new_side,
                                                 const CounterexampleRequest& request, const DiffOptions& options,
                                                 ExampleBudget& budget) {
  Shortener shortener(old_side, new_side, budget);
  const prove::Match& match = request.match;
  std::vector<CellId> new_cells;
  for (const CellId cell : request.old_cells) new_cells.push_back(match.new_of_old[cell.index]);
  Stimuli stimuli;
  for (const CellId cell : request.old_cells) {
    const auto found = request.runs.difference_of.find(cell);
    if (found == request.runs.difference_of.end()) continue;
    const Stimuli& run = request.runs.runs[found->second.run];
    stimuli.assign(run.begin(), run.begin() + found->second.steps);
    break;
  }
  if (request.run) {
    stimuli.clear();
    // An arbitrary state is set before the first period; later inputs stay.
    for (const std::vector<prove::SetCell>& inputs : request.run->periods) {
      stimuli.push_back({.inputs = inputs, .slow = 1});
    }
  }
  if (stimuli.empty()) return std::nullopt;
  if (!shortener.Shows(stimuli, request.old_cells, new_cells)) {
    // The slow part may be in slices: what the proof takes for one period is seen in a part of them only.
    if (!request.run) return std::nullopt;
    for (Stimulus& stimulus : stimuli) stimulus = {.inputs = stimulus.inputs, .words = {}, .ms = PeriodMs(old_side)};
    if (!shortener.Shows(stimuli, request.old_cells, new_cells)) return std::nullopt;
  }
  stimuli = Joined(shortener.Shorten(std::move(stimuli), request.old_cells, new_cells));
  // A wait that came in pieces is one number now, perhaps a rounder one.
  stimuli = shortener.Shorten(std::move(stimuli), request.old_cells, new_cells);
  --budget.left;
  return DescribeCounterexample(old_side, new_side, request, stimuli, options, budget);
}

std::optional<Counterexample> DescribeCounterexample(DiffSide& old_side, DiffSide& new_side,
                                                     const CounterexampleRequest& request, const Stimuli& stimuli,
                                                     const DiffOptions& options, ExampleBudget& budget) {
  Counterexample example;
  example.from_state = request.run && request.run->from_state;
  std::string steps;
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
      add(example.steps, sets[i].first + "=" + sets[i].second);
    }
    if (sets.size() > kMostShown) add(example.steps, std::to_string(sets.size() - kMostShown) + " more");
    if (!sets.empty()) steps += "- set: {" + assignments + "}\n";
    const std::string run =
        stimulus.slow != 0 ? "slow: " + std::to_string(stimulus.slow) : "ms: " + std::to_string(stimulus.ms);
    steps += "- run: {" + run + "}\n";
    add(example.steps,
        stimulus.slow != 0 ? "slow " + std::to_string(stimulus.slow) : std::to_string(stimulus.ms) + " ms");
  }
  const prove::Version old_version = prove::MakeVersion(old_side.whole),
                       new_version = prove::MakeVersion(new_side.whole);
  DiffMachine old_machine(old_side, old_version), new_machine(new_side, new_version);
  for (const Stimulus& stimulus : stimuli) {
    old_machine.Apply(stimulus, &prove::SetCell::old_cell);
    new_machine.Apply(stimulus, &prove::SetCell::new_cell);
  }
  old_machine.Look();
  new_machine.Look();
  const CellWord word = WordOfBoth(request, request.old_cells.front());
  const auto value_of = [&](const DiffMachine& machine, bool is_old) {
    uint64_t value = 0;
    for (size_t i = 0; i < word.cells.size() && i < 64; ++i) {
      const CellId cell = is_old ? word.cells[i] : request.match.new_of_old[word.cells[i].index];
      if (!cell.valid()) continue;
      const uint64_t part = machine.Seen(cell);
      if (word.cells.size() == 1) return part;
      value |= part << i;
    }
    return value;
  };
  const uint64_t old_value = value_of(old_machine, true), new_value = value_of(new_machine, false);
  if (request.kind == ItemKind::kCalls) {
    example.old_value = "other calls";
    example.new_value = "other calls";
    return example;
  }
  example.old_value = ValueText(word, old_value);
  example.new_value = ValueText(word, new_value);
  // What the language has no name for is seen in the simulator, and in no scenario.
  if (!old_side.compilation.dialect->locate(old_side.compilation.program, word.name)) return example;
  const std::string heading = "# " + request.name + " is " + example.old_value + " in the old version and " +
                              example.new_value + " in the new one.\n" + Heading(old_side, options);
  example.scenario =
      heading + "steps:\n" + steps + "- expect: {" + Quoted(word.name) + ": " + example.old_value + "}\n";
  example.confirmed =
      Passes(example.scenario, budget.old_program, options) && !Passes(example.scenario, budget.new_program, options);
  return example;
}

}  // namespace plcxx::driver
