// From a difference to a scenario that shows it: shortened as far as it still does, and run on both versions.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <variant>

#include "transpiler/project/reach.h"
#include "transpiler/review/diff/calls.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/review/diff/shorten.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/yaml/words.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;

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

/// The cells of one version that a scenario means by a name; none: it means something else, or nothing.
std::vector<CellId> CellsNamed(const DiffSide& side, const prove::machine::Version& version, const CellWords& words,
                               const std::string& name) {
  const std::optional<dialects::Location> location = side.compilation.dialect->locate(words.compiled_names(), name);
  if (!location || location->absent || location->cell || location->text_input || !location->bits.empty()) return {};
  if (!execute::IsInside(*version.program, location->place)) return {};
  return execute::CellsOf(*version.program, version.cells, location->place);
}

/// A name of the word that means the same cells in both versions. Where a location has moved, its address is another
/// one's in the new version: then the symbol that moved with it, where there is one.
std::optional<std::string> NameInBoth(const DiffSide& old_side, const DiffSide& new_side,
                                      const CounterexampleRequest& request, const CellWord& word) {
  if (!word.place) return word.name;
  std::vector<std::string> names{word.name};
  if (!word.place->name.empty() && word.place->name != word.name) names.push_back(word.place->name);
  for (const std::string& name : names) {
    std::vector<CellId> matched = CellsNamed(old_side, request.old_version, request.old_words, name);
    if (matched.empty()) continue;
    for (CellId& cell : matched) cell = request.match.new_of_old[cell.index];
    if (matched == CellsNamed(new_side, request.new_version, request.new_words, name)) return name;
  }
  return std::nullopt;
}

/// How a scenario names the word.
std::string ScenarioName(const DiffSide& old_side, const DiffSide& new_side, const CounterexampleRequest& request,
                         const CellWord& word) {
  return NameInBoth(old_side, new_side, request, word).value_or(word.name);
}

/// Does a scenario of the old version know the name?
bool IsKnownToOld(const DiffSide& old_side, const CounterexampleRequest& request, const std::string& name) {
  return old_side.compilation.dialect->locate(request.old_words.compiled_names(), name).has_value();
}

/// A part of a timer that is nobody else's, or the calls of a function: no location of a scenario.
bool HasNoName(const CellWord& word) { return !word.place && word.cells.size() == 1; }

/// A value as a scenario writes it.
std::string WordText(const DiffSide& side, const CellWords& words, const CellWord& word, uint64_t value) {
  if (!word.place) return std::to_string(value);
  const std::optional<dialects::Location> location =
      side.compilation.dialect->locate(words.compiled_names(), word.name);
  return sim::ValueDigits(word.place->type, value, location ? scenarios::SignOf(*location) : sim::Sign::kNone);
}

using Sets = std::vector<std::pair<std::string, std::string>>;  // location, value

/// Inputs as a scenario writes them: whole words where the program has no bit of that name, of which the other bits
/// stay as they are in `machine`, the old version before this step. None: one of them has no name.
std::optional<Sets> SetsOf(const DiffSide& old_side, const DiffSide& new_side, const CounterexampleRequest& request,
                           const std::vector<prove::diff::SetCell>& inputs, DiffMachine& machine) {
  std::vector<CellWord> words;
  std::set<std::string> taken;
  std::map<CellId, uint64_t> values;
  for (const prove::diff::SetCell& input : inputs) {
    values[input.old_cell] = input.value;
    CellWord word = WordOfBoth(request, input.old_cell);
    if (HasNoName(word)) return std::nullopt;
    if (taken.insert(word.name).second) words.push_back(std::move(word));
  }
  machine.Look();
  Sets sets;
  for (const CellWord& word : words) {
    uint64_t value = 0;
    for (size_t i = 0; i < word.cells.size() && i < 64; ++i) {
      const auto set = values.find(word.cells[i]);
      value |= (set != values.end() ? set->second : machine.Seen(word.cells[i])) << i;
    }
    const std::string name = ScenarioName(old_side, new_side, request, word);
    if (!IsKnownToOld(old_side, request, name)) return std::nullopt;
    sets.emplace_back(name, WordText(old_side, request.old_words, word, value));
  }
  return sets;
}

std::string Quoted(const std::string& text) { return yaml::YamlWord(text, "_.-"); }

std::string RelativePath(const std::string& path, const std::string& directory) {
  std::error_code error;
  const std::filesystem::path from = std::filesystem::absolute(directory.empty() ? "." : directory, error);
  const std::filesystem::path to = std::filesystem::absolute(path, error).lexically_normal();
  const std::filesystem::path relative = to.lexically_relative(from.lexically_normal());
  return relative.empty() ? path : relative.generic_string();
}

std::string Heading(const DiffSide& side, const DiffOptions& options) {
  std::vector<std::string> sources;
  std::string names, separator;
  for (const std::string& source : side.request.sources) {
    const std::string& name = side.file_name.empty() ? source : side.file_name;
    sources.push_back(
        RelativePath((std::filesystem::path(side.scenario_base) / name).string(), options.scenario_directory));
    names += separator + Quoted(sources.back());
    separator = ", ";
  }
  std::string text = project::ReplayComment(options.scenario_directory, sources) +
                     "dialect: " + std::string(side.compilation.dialect->name) + "\nsources: [" + names + "]\n";
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

/// Run in the simulator; none: it is no scenario of this program.
std::optional<scenarios::TestOutcome> OutcomeOf(const std::string& scenario, scenarios::ScenarioProgram& program,
                                                const DiffOptions& options) {
  const std::string path = (std::filesystem::path(options.scenario_directory) / "counterexample.yaml").string();
  scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, scenario);
  if (!std::holds_alternative<scenarios::Scenario>(read)) return std::nullopt;
  scenarios::SuiteOptions suite;
  suite.platforms.clear();
  suite.simulator = false;  // then it is one that does not note who wrote what
  return scenarios::TestScenario(std::get<scenarios::Scenario>(read), suite, program).test.outcome;
}

uint32_t PeriodMs(const DiffSide& side) { return side.compilation.program.schedule.period_ms; }

struct Candidate {
  Stimuli stimuli;
  bool from_state = false;
};
/// The run without what no scenario has a name for.
Stimuli Nameable(const DiffSide& old_side, const DiffSide& new_side, const CounterexampleRequest& request,
                 Stimuli stimuli) {
  const auto has_no_name = [&](const prove::diff::SetCell& input) {
    const CellWord word = WordOfBoth(request, input.old_cell);
    return HasNoName(word) || !IsKnownToOld(old_side, request, ScenarioName(old_side, new_side, request, word));
  };
  for (Stimulus& stimulus : stimuli) {
    std::erase_if(stimulus.inputs, has_no_name);
    std::erase_if(stimulus.kept, has_no_name);
    stimulus.repeated = Nameable(old_side, new_side, request, std::move(stimulus.repeated));
  }
  return stimuli;
}

/// The runs that may show the difference, the best one first.
std::vector<Candidate> Candidates(const DiffSide& old_side, const DiffSide& new_side,
                                  const CounterexampleRequest& request) {
  std::vector<Candidate> candidates;
  if (request.run) {
    // An arbitrary state is set before the first period; later inputs stay.
    Stimuli by_pass = PowerOnWith(request.run->kept), by_time = by_pass;
    for (const std::vector<prove::diff::SetCell>& inputs : request.run->periods) {
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
  if (shortest != nullptr && shortest->steps != 0) {
    const Stimuli& run = request.runs.runs[shortest->run];
    candidates.push_back({Folded(Joined(Stimuli(run.begin(), run.begin() + shortest->steps)))});
  }
  // Better one that a scenario can say; else any.
  const size_t count = candidates.size();
  for (size_t i = 0; i < count; ++i) {
    candidates.push_back(candidates[i]);
    candidates[i].stimuli = Nameable(old_side, new_side, request, std::move(candidates[i].stimuli));
  }
  return candidates;
}

}  // namespace

/// Both versions after the last stimulus.
struct Ends {
  DiffMachine old_machine, new_machine;
};

struct ShownRun {
  Stimuli stimuli;
  bool from_state;
  Ends ends;
  std::chrono::steady_clock::duration cost;
};

namespace {

constexpr size_t kMostRemembered = 16;  // runs; each holds two machines

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

/// Of a stimulus that power fails, and what is kept meanwhile.
Stimulus PowerOf(const Stimulus& stimulus) {
  return {.inputs = {}, .words = {}, .power_cycle = true, .kept = stimulus.kept};
}

/// Some controls keep the memory only when the program has asked for it.
void AddRequestToKeep(const DiffSide& old_side, const CounterexampleRequest& request, Sets& kept) {
  const ir::Program& program = old_side.compilation.program;
  const ir::PlaceId asked = program.schedule.retain_at_power_off;
  if (!asked.valid()) return;
  const std::vector<CellId> cells =
      execute::CellsOf(*request.old_version.program, request.old_version.cells, program.places[asked]);
  kept.emplace_back(request.old_words.WordOf(cells.front()).name, "1");
}

/// None: the run sets what a scenario has no name for. `machine`: the old version where the run begins.
std::optional<WrittenSteps> Write(const DiffSide& old_side, const DiffSide& new_side,
                                  const CounterexampleRequest& request, const Stimuli& stimuli, DiffMachine& machine) {
  WrittenSteps written;
  for (const Stimulus& stimulus : stimuli) {
    if (!stimulus.repeated.empty()) {
      // As it is written for the first time it has to be right for all others.
      const std::optional<WrittenSteps> once = Write(old_side, new_side, request, stimulus.repeated, machine);
      if (!once) return std::nullopt;
      Stimulus rest = stimulus;
      --rest.times;
      machine.Apply(rest, &prove::diff::SetCell::old_cell);
      written.AddRepeated(*once, stimulus.times);
      continue;
    }
    Stimulus after_power = stimulus;
    if (stimulus.power_cycle) {
      std::optional<Sets> kept = SetsOf(old_side, new_side, request, stimulus.kept, machine);
      if (kept && !kept->empty()) AddRequestToKeep(old_side, request, *kept);
      if (!kept) return std::nullopt;
      written.AddSets(*kept);
      written.AddPowerCycle();
      machine.Apply(PowerOf(stimulus), &prove::diff::SetCell::old_cell);
      after_power.power_cycle = false;
    }
    std::optional<Sets> sets = SetsOf(old_side, new_side, request, stimulus.inputs, machine);
    if (!sets) return std::nullopt;
    // A word of a scenario beside the program that the old version does not know sets nothing there.
    std::ranges::copy_if(stimulus.words, std::back_inserter(*sets),
                         [&](const auto& set) { return IsKnownToOld(old_side, request, set.first); });
    machine.Apply(after_power, &prove::diff::SetCell::old_cell);
    after_power.words = std::move(*sets);
    written.Add(after_power);
  }
  return written;
}

/// The last step of the scenario, with the values of both; none where no scenario can tell.
std::optional<std::string> Expectation(const DiffSide& old_side, const DiffSide& new_side,
                                       const CounterexampleRequest& request, const Ends& ends,
                                       Counterexample& example) {
  if (request.kind == ItemKind::kCalls) {
    const ir::Program &old_program = old_side.compilation.program, &new_program = new_side.compilation.program;
    const CellId told = request.old_cells.front();
    const bool of_all = told == request.old_version.cells.OfOrder();
    const std::string function =
        of_all ? ""
               : old_side.whole.host_functions[ir::HostFunctionId(told.index - request.old_version.cells.calls)].name;
    const std::vector<sim::HostEvent>&old_events = ends.old_machine.events(), &new_events = ends.new_machine.events();
    const FirstDifferentCall call = FindDifferentCall(old_program, old_events, new_program, new_events, function);
    example.old_value = call.old_text;
    example.new_value = call.new_text;
    // Scenarios do not list these.
    if (call.is_of_exchange) return std::nullopt;
    const auto expected = [&function](const ir::Program& program, const std::vector<sim::HostEvent>& events,
                                      StatementNumbers numbers) {
      return ExpectedCalls(program, events, function, numbers);
    };
    // Where the same faults come from other statements, their numbers are what differs.
    const bool is_told = expected(old_program, old_events, StatementNumbers::kLeftOut) !=
                         expected(new_program, new_events, StatementNumbers::kLeftOut);
    const std::optional<std::string> calls =
        expected(old_program, old_events, is_told ? StatementNumbers::kLeftOut : StatementNumbers::kNamed);
    if (!calls) return std::nullopt;
    return "expect_calls: " + *calls;
  }
  const SeenDifference seen = FindSeen(request, ends);
  example.old_value = WordText(old_side, request.old_words, seen.word, seen.old_value);
  example.new_value = WordText(new_side, request.new_words, seen.word, seen.new_value);
  // What the language has no name for is seen in the simulator, and in no scenario.
  if (HasNoName(seen.word)) return std::nullopt;
  // Of what has another name in each version a scenario would show that the new one does not know it.
  const std::optional<std::string> name = NameInBoth(old_side, new_side, request, seen.word);
  if (!name || !IsKnownToOld(old_side, request, *name)) return std::nullopt;
  return "expect: {" + Quoted(*name) + ": " + example.old_value + "}";
}

/// The inputs with the other bits of their words, as the old version has them then: a scenario sets words, and the new
/// version may have had something else there.
std::vector<prove::diff::SetCell> WholeWords(const CounterexampleRequest& request,
                                             const std::vector<prove::diff::SetCell>& inputs, DiffMachine& machine) {
  std::vector<prove::diff::SetCell> whole = inputs;
  std::set<CellId> set;
  for (const prove::diff::SetCell& input : inputs) set.insert(input.old_cell);
  machine.LookAtMemory();
  for (const prove::diff::SetCell& input : inputs) {
    for (const CellId cell : WordOfBoth(request, input.old_cell).cells) {
      if (!set.insert(cell).second) continue;
      whole.push_back(
          {.old_cell = cell, .new_cell = request.match.new_of_old[cell.index], .value = machine.Seen(cell)});
    }
  }
  return whole;
}

enum class SetAs : uint8_t { kWords, kBits };

std::shared_ptr<const ShownRun> Show(const DiffSide& old_side, const DiffSide& new_side,
                                     const CounterexampleRequest& request, Stimuli stimuli, bool from_state,
                                     SetAs set_as) {
  const auto begin = std::chrono::steady_clock::now();
  const std::shared_ptr<ShownRun> run(
      new ShownRun{.stimuli = std::move(stimuli),
                   .from_state = from_state,
                   .ends = {DiffMachine(old_side, request.old_version), DiffMachine(new_side, request.new_version)},
                   .cost = {}});
  const auto apply = [&run](const Stimulus& stimulus) {
    run->ends.old_machine.Apply(stimulus, &prove::diff::SetCell::old_cell);
    run->ends.new_machine.Apply(stimulus, &prove::diff::SetCell::new_cell);
  };
  const auto show = [&](const auto& self, const Stimuli& steps) -> void {
    for (const Stimulus& stimulus : steps) {
      for (uint32_t i = 0; !stimulus.repeated.empty() && i < stimulus.times; ++i) self(self, stimulus.repeated);
      if (!stimulus.repeated.empty()) continue;
      Stimulus after_power = stimulus;
      if (std::exchange(after_power.power_cycle, false)) {
        Stimulus power = PowerOf(stimulus);
        if (set_as == SetAs::kWords) power.kept = WholeWords(request, power.kept, run->ends.old_machine);
        apply(power);
      }
      if (set_as == SetAs::kWords && !stimulus.inputs.empty())
        after_power.inputs = WholeWords(request, stimulus.inputs, run->ends.old_machine);
      apply(after_power);
    }
  };
  show(show, run->stimuli);
  run->ends.old_machine.Look();
  run->ends.new_machine.Look();
  run->cost = std::chrono::steady_clock::now() - begin;
  return run;
}

Counterexample Describe(DiffSide& old_side, DiffSide& new_side, const CounterexampleRequest& request,
                        const ShownRun& run, const DiffOptions& options, ExampleBudget& budget) {
  Counterexample example{.from_state = run.from_state, .cost = run.cost};
  DiffMachine machine(old_side, request.old_version);
  const std::optional<WrittenSteps> steps = Write(old_side, new_side, request, run.stimuli, machine);
  const std::optional<std::string> expectation = Expectation(old_side, new_side, request, run.ends, example);
  if (!steps) return example;
  example.steps = steps->line;
  if (!expectation) return example;
  const bool is_value = request.kind != ItemKind::kCalls;
  const std::string heading =
      is_value ? "# " + request.name + " is " + example.old_value + " in the old version and " + example.new_value
               : "# " + request.name + ": " + example.old_value + " in the old version, " + example.new_value;
  example.scenario = heading + " in the new one.\n" + Heading(old_side, options) + "steps:\n" + steps->scenario + "- " +
                     *expectation + "\n";
  // To run it once more on each version costs more than both together did.
  constexpr int kReplays = 3;
  if (std::chrono::steady_clock::now() + kReplays * run.cost >= budget.all_end) {
    example.scenario.clear();
    return example;
  }
  // A new version that does not know a location does not show another value there.
  const bool confirmed = OutcomeOf(example.scenario, budget.old_program, options) == scenarios::TestOutcome::kPassed &&
                         OutcomeOf(example.scenario, budget.new_program, options) == scenarios::TestOutcome::kFailed;
  example.replay = confirmed ? Replay::kSimulator : Replay::kRefuted;
  return example;
}

}  // namespace

std::optional<Counterexample> FindCounterexample(DiffSide& old_side, DiffSide& new_side,
                                                 const CounterexampleRequest& request, const DiffOptions& options,
                                                 ExampleBudget& budget) {
  std::vector<CellId> new_cells;
  for (const CellId cell : request.old_cells) new_cells.push_back(request.match.new_of_old[cell.index]);
  const Shortener::Shows shows = ShowsDifference(old_side, new_side, request.old_version, request.new_version,
                                                 request.old_cells, std::move(new_cells));
  Shortener shortener(shows, budget.end);
  const auto differs = [&request](const ShownRun& run) {
    if (request.kind == ItemKind::kCalls) return true;
    const SeenDifference seen = FindSeen(request, run.ends);
    return seen.old_value != seen.new_value;
  };
  for (Candidate& candidate : Candidates(old_side, new_side, request)) {
    if (!shows(candidate.stimuli, budget.last_end)) continue;
    --budget.left;
    Stimuli shortened = Folded(shortener.Shorten(std::move(candidate.stimuli)));
    std::shared_ptr<const ShownRun> run =
        Show(old_side, new_side, request, shortened, candidate.from_state, SetAs::kWords);
    if (!differs(*run)) {
      run = Show(old_side, new_side, request, std::move(shortened), candidate.from_state, SetAs::kBits);
    }
    if (budget.shown.size() < kMostRemembered) budget.shown.push_back(run);
    return Describe(old_side, new_side, request, *run, options, budget);
  }
  return std::nullopt;
}

std::optional<Counterexample> FindAmongShown(DiffSide& old_side, DiffSide& new_side,
                                             const CounterexampleRequest& request, const DiffOptions& options,
                                             ExampleBudget& budget) {
  const auto differs_in = [&request](const std::shared_ptr<const ShownRun>& run) {
    return std::ranges::any_of(request.old_cells, [&](CellId cell) {
      const CellId new_cell = request.match.new_of_old[cell.index];
      return run->ends.old_machine.Seen(cell) != run->ends.new_machine.Seen(new_cell);
    });
  };
  const auto found = std::ranges::find_if(budget.shown, differs_in);
  if (found == budget.shown.end()) return std::nullopt;
  --budget.left;
  return Describe(old_side, new_side, request, **found, options, budget);
}

}  // namespace plcxx::review::diff
