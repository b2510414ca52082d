// The comparison of two versions: cells in, items with names, causes and counterexamples out.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "transpiler/dialects/statement_text.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/review/diff/causes.h"
#include "transpiler/review/diff/confirm.h"
#include "transpiler/review/diff/declared.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/items.h"
#include "transpiler/review/diff/left_out.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/review/diff/search.h"
#include "transpiler/review/diff/statements.h"
#include "transpiler/review/diff/turns.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::PairResult;
using prove::diff::PairVerdict;

ItemKind KindOf(const prove::machine::Version& version, CellId cell) {
  if (execute::CellAt(*version.program, version.cells, cell).kind == execute::CellKind::kCalls) return ItemKind::kCalls;
  if (prove::machine::DirectionOf(version, cell) == ir::Direction::kOutput) return ItemKind::kOutput;
  return prove::machine::IsRetentive(version, cell) ? ItemKind::kRetentive : ItemKind::kInternal;
}

ItemVerdict VerdictOf(const PairResult& pair) {
  switch (pair.verdict) {
    case PairVerdict::kUntouched:
    case PairVerdict::kEqual:
      return ItemVerdict::kEqual;
    case PairVerdict::kDifferent:
      return ItemVerdict::kDifferent;
    case PairVerdict::kUndecided:
      return ItemVerdict::kUndecided;
  }
  return ItemVerdict::kUndecided;
}

/// The worse of two: what differs beats what is not decided.
bool IsWorse(ItemVerdict one, ItemVerdict other) {
  const auto rank = [](ItemVerdict verdict) {
    return verdict == ItemVerdict::kDifferent ? 2 : verdict == ItemVerdict::kUndecided ? 1 : 0;
  };
  return rank(one) > rank(other);
}

std::vector<Gathered> Gather(const prove::diff::CompareResult& result, const Named& old_side, const Named& new_side) {
  std::vector<Gathered> items;
  std::map<std::pair<ItemKind, std::string>, size_t> index;
  for (const PairResult& pair : result.pairs) {
    if (pair.verdict == PairVerdict::kUntouched) continue;
    const Named& side = pair.old_cell.valid() ? old_side : new_side;
    const CellId cell = pair.old_cell.valid() ? pair.old_cell : pair.new_cell;
    CellWord word = side.words.WordOf(cell);
    // A place that only the new version uses has its name there.
    if (!word.place && pair.new_cell.valid()) {
      CellWord other = new_side.words.WordOf(pair.new_cell);
      if (other.place) word = std::move(other);
    }
    const ItemKind kind = KindOf(side.version, cell);
    const auto [at, added] = index.try_emplace({kind, word.name}, items.size());
    if (added) {
      items.push_back({.item = {.name = word.name, .kind = kind, .verdict = ItemVerdict::kEqual}});
      items.back().item.meaning = new_side.words.MeaningOf(word);
      if (items.back().item.meaning.empty()) items.back().item.meaning = old_side.words.MeaningOf(word);
      std::ranges::replace(items.back().item.meaning, '\n', ' ');  // comments of several lines
    }
    Gathered& gathered = items[at->second];
    // No run has to show it: the other version has no such function.
    if (kind == ItemKind::kCalls && pair.old_cell.valid() != pair.new_cell.valid()) {
      const std::string without = "not asked of the control", with = "asked of the control";
      gathered.item.declared = pair.old_cell.valid() ? Declared{with, without} : Declared{without, with};
    }
    if (pair.old_cell.valid()) gathered.old_cells.push_back(pair.old_cell);
    if (pair.new_cell.valid()) gathered.new_cells.push_back(pair.new_cell);
    gathered.item.changed_itself = gathered.item.changed_itself || pair.changed_itself;
    if (gathered.worst == nullptr || IsWorse(VerdictOf(pair), gathered.item.verdict)) {
      gathered.worst = &pair;
      gathered.item.verdict = VerdictOf(pair);
      gathered.item.reason = pair.reason;
    }
  }
  return items;
}

/// The order of calls is news where no function by itself is called otherwise.
void DropOrderOfCalls(std::vector<Gathered>& items, CellId order) {
  const auto is_order = [order](const Gathered& gathered) {
    return std::ranges::find(gathered.old_cells, order) != gathered.old_cells.end();
  };
  const bool is_explained = std::ranges::any_of(items, [&](const Gathered& gathered) {
    const DiffItem& item = gathered.item;
    return item.kind == ItemKind::kCalls && item.verdict == ItemVerdict::kDifferent && !is_order(gathered);
  });
  std::erase_if(items, [&](const Gathered& gathered) {
    return is_order(gathered) && (is_explained || gathered.item.verdict == ItemVerdict::kEqual);
  });
}

constexpr int kMostExamples = 60;
constexpr size_t kMostChangesShown = 50;  // statements of which the line is sought that was changed
constexpr uint64_t kExampleShare = 10;    // of the time: for shorter runs
constexpr int kRestShare = 3;             // or of what is left of it, for a busy machine needs longer
constexpr uint64_t kLastShare = 6;        // of the time: left for that, and for showing them
constexpr uint64_t kScenariosShare = 5, kQuickSearchShare = 40, kQuickWideShare = 10, kSearchShare = 6,
                   kKeptShare = 60;   // of the time: for runs
constexpr uint64_t kSlicesShare = 6;  // of the time, where the slow part is in slices: for what is seen between them

bool IsSliced(const ir::Program& program) {
  return std::ranges::any_of(program.routines, [](const ir::Routine& routine) { return routine.slices > 1; });
}

/// The comparison takes the slow part in one piece, so that moved cuts are no news. Here the programs are executed as
/// they run, slice by slice: an item for all that is not proved equal then, where it is so for whole passes.
void CompareBetweenSlices(const DiffSide& old_side, const DiffSide& new_side,
                          const std::vector<std::pair<ir::Place, ir::Place>>& same, uint64_t time_ms, Diff& diff) {
  const prove::machine::Version old_version = prove::machine::MakeVersion(old_side.compilation.program),
                                new_version = prove::machine::MakeVersion(new_side.compilation.program);
  const Named old_named(old_side, old_version), new_named(new_side, new_version);
  const prove::diff::CompareResult result = CompareVersions(
      old_version, new_version, prove::diff::MatchCells(old_version, new_version, same), {}, {.total_ms = time_ms});
  if (!result.refusal.empty()) {
    diff.not_looked_at.push_back("what is seen between two slices of the slow part: " + result.refusal);
    return;
  }
  std::vector<std::string> names;
  for (const Gathered& gathered : Gather(result, old_named, new_named)) {
    const DiffItem& item = gathered.item;
    const bool is_known = std::ranges::find(diff.items, item.name, &DiffItem::name) != diff.items.end();
    // What one version alone has to count its slices nobody sees.
    const bool is_seen = std::ranges::find(diff.of_slices, item.name) == diff.of_slices.end();
    if (item.verdict != ItemVerdict::kEqual && !is_known && is_seen) names.push_back(item.name);
  }
  if (names.empty()) return;
  diff.items.push_back({.name = "between slices",
                        .kind = ItemKind::kSchedule,
                        .verdict = ItemVerdict::kUndecided,
                        .through = names,
                        .reason =
                            "a statement stands in another slice: until its pass ends, a location may be ahead of "
                            "the old version or behind it"});
}

/// What a solver says counts when both versions were run. `is_seen`: they were, beside each other in the simulator, and
/// differed.
void KeepWhatWasReplayed(DiffItem& item, bool is_seen) {
  const auto not_decided = [&item](const std::string& reason) {
    item.verdict = ItemVerdict::kUndecided;
    item.reason = reason;
    item.counterexample.reset();
  };
  if (!item.counterexample) {
    if (item.verdict == ItemVerdict::kDifferent && !is_seen)
      not_decided("a run was computed that should show a difference, and could not be repeated");
    return;
  }
  switch (item.counterexample->replay) {
    case Replay::kSideBySide:
    case Replay::kSimulator:
    case Replay::kCompiled:
      // Nobody knows whether the machine comes to a state that is only set.
      if (item.counterexample->from_state) {
        const std::string& steps = item.counterexample->steps;
        not_decided("they differ from a state " + (steps.empty()
                                                       ? "that no scenario can set, and no run to it is known"
                                                       : "to which no run from power-on is known (" + steps + ")"));
      } else {
        item.verdict = ItemVerdict::kDifferent;
      }
      return;
    case Replay::kRefuted:
      not_decided("a run shows a difference that its scenario does not show");
      return;
  }
}

/// The places of --map; the first word that is no place of its program, otherwise.
std::optional<std::string> PlacesOf(const DiffSide& old_side, const DiffSide& new_side, const DiffOptions& options,
                                    std::vector<std::pair<ir::Place, ir::Place>>& same) {
  const ir::NameIndex old_names(old_side.whole), new_names(new_side.whole);
  const auto locate = [](const DiffSide& side, const ir::NameIndex& names,
                         const std::string& name) -> std::optional<ir::Place> {
    const std::optional<dialects::Location> location = side.compilation.dialect->locate(names, name);
    if (!location || location->absent || location->cell || location->text_input) return std::nullopt;
    return location->place;
  };
  for (const auto& [old_name, new_name] : options.same) {
    const std::optional<ir::Place> one = locate(old_side, old_names, old_name),
                                   other = locate(new_side, new_names, new_name);
    if (!one) return "--map: '" + old_name + "' is no location of " + old_side.label;
    if (!other) return "--map: '" + new_name + "' is no location of " + new_side.label;
    if (one->type != other->type) return "--map: '" + old_name + "' and '" + new_name + "' have different types";
    same.emplace_back(*one, *other);
  }
  return std::nullopt;
}

}  // namespace

DiffSide MakeDiffSide(std::string label, const compilation::CompilationRequest& request,
                      const std::string& hidden_prefix) {
  DiffSide side{.label = std::move(label),
                .request = request,
                .scenario_base = hidden_prefix.empty() ? request.base_directory : std::string(),
                .hidden_prefix = hidden_prefix,
                .compilation = compilation::Compile(request, compilation::Stage::kChecked),
                .whole = {}};
  if (!side.compilation.ok() || !side.compilation.has_program) return side;
  side.whole = side.compilation.program;
  compilation::OptimizeProgram(side.compilation);
  for (ir::Routine& routine : side.whole.routines) routine.slices = 1;
  passes::Optimize(side.whole);
  std::vector<source::Range> statements;
  for (const ir::Statement& statement : side.whole.statements) statements.push_back(statement.range);
  side.elsewhere = dialects::LinesElsewhere(side.whole.dialect, *side.compilation.sources, statements);
  return side;
}

Diff CompareSides(DiffSide& old_side, DiffSide& new_side, const DiffOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now(),
                          whole_end = options.begin.value_or(begin) + std::chrono::milliseconds(options.time_ms);
  std::vector<std::pair<ir::Place, ir::Place>> same;
  if (std::optional<std::string> wrong = PlacesOf(old_side, new_side, options, same)) return {.refusal = *wrong};
  prove::machine::Version old_version = prove::machine::MakeVersion(old_side.whole),
                          new_version = prove::machine::MakeVersion(new_side.whole);
  prove::diff::ShareLoops(old_version, new_version);
  const prove::diff::Match match = prove::diff::MatchCells(old_version, new_version, same);
  RandomRuns runs;  // made when something is not proved equal at once
  const bool sliced = IsSliced(old_side.compilation.program) || IsSliced(new_side.compilation.program);
  const uint64_t slices_ms = sliced ? options.time_ms / kSlicesShare : 0;
  const Clock::time_point last_end = whole_end - std::chrono::milliseconds(slices_ms);
  const Clock::time_point compare_begin = Clock::now();
  const Clock::time_point compare_end =
      std::max(compare_begin, last_end - std::chrono::milliseconds(options.time_ms / kLastShare));
  const std::chrono::milliseconds compare_time =
      std::chrono::duration_cast<std::chrono::milliseconds>(compare_end - compare_begin);
  prove::diff::CompareLimits limits{.total_ms = static_cast<uint64_t>(compare_time.count()),
                                    .progress = options.progress};
  const Named old_named(old_side, old_version), new_named(new_side, new_version);
  std::optional<DirectedSearch> search;
  Turns turns;
  uint32_t round = 0;
  bool scenarios_are_run = false;
  const auto is_seen = [&runs](CellId cell) { return runs.difference_of.contains(cell); };
  // Of a word that differs the other bits are not looked for any longer.
  const auto is_sought = [&](CellId cell) {
    return !is_seen(cell) && std::ranges::none_of(old_named.words.WordOf(cell).cells, is_seen);
  };
  const auto find_different = [&](const prove::diff::Sought& sought, prove::diff::Effort effort, uint64_t most_ms) {
    using prove::diff::Effort;
    const auto part = [&](uint64_t share) {
      return std::min(compare_end, Clock::now() + std::chrono::milliseconds(options.time_ms / share));
    };
    const auto open = [&] {
      std::vector<CellId> cells = sought.open;
      std::erase_if(cells, [&](CellId cell) { return !is_sought(cell); });
      return cells;
    };
    // Too late to begin with anything.
    if (!search && Clock::now() >= compare_end) return std::vector<CellId>();
    if (!search) search.emplace(old_side, new_side, old_version, new_version, match, old_named.words, sought.all);
    const auto run_both = [&](const std::vector<CellId>& cells, Clock::time_point run_end, bool waits_only = false) {
      if (cells.empty()) return;
      RunBoth(old_side, new_side,
              {.old_version = old_version,
               .new_version = new_version,
               .match = match,
               .cells = cells,
               .effort = effort,
               .end = run_end,
               .round = round,
               .waits_only = waits_only},
              options, runs);
    };
    // To begin with it executes both versions once more, which is worth it while most of the time is left.
    const auto is_worth_executing = [&] { return compare_end - Clock::now() > (Clock::now() - begin) / 4; };
    const auto run_wide = [&](Clock::time_point wide_end) {
      if (!is_worth_executing()) return;
      search->RunWideFromMoments(open(), Clock::now() + (wide_end - Clock::now()) / 2, runs);
      search->RunWide(open(), wide_end, runs);
    };
    const auto is_many = [&] { return open().size() > kMostSought; };
    const auto take_turn = [&](Way way, Clock::time_point turn_end) {
      const Clock::time_point turn_begin = Clock::now();
      const size_t before = runs.difference_of.size();
      switch (way) {
        case Way::kWide:
          run_wide(turn_end);
          break;
        case Way::kAtWork:
          search->Run(open(), turn_end, runs);
          break;
      }
      turns.Took(way, Clock::now() - turn_begin, runs.difference_of.size() - before);
    };
    // What a change leads to may show at a limit that was there before.
    const auto counts_share = [&search, &runs] {
      return search->has_changed_constants() || !runs.difference_of.empty() ? kSearchShare : 4 * kSearchShare;
    };
    switch (effort) {
      case Effort::kScenarios:
        if (!std::exchange(scenarios_are_run, true)) search->RunScenarios(part(kScenariosShare), runs);
        break;
      case Effort::kQuick:
        run_both(sought.all, compare_end);
        if (is_worth_executing()) search->RunWideFromMoments(open(), part(kQuickWideShare), runs);
        search->Run(open(), part(kQuickSearchShare), runs);
        break;
      case Effort::kThorough:
        if (search->has_changed_constants()) search->RunCounts(open(), part(kSearchShare), runs);
        run_both(open(), part(kSearchShare), true);
        ++round;
        search->Follow(sought.runs, part(kSearchShare), runs);
        take_turn(Way::kWide, part(is_many() ? 2 * kSearchShare : kSearchShare));
        take_turn(Way::kAtWork, part(is_many() ? 2 * kSearchShare : kSearchShare));
        search->RunCounts(open(), part(counts_share()), runs);
        if (!open().empty() && !is_many()) search->BeginWithKept(part(kKeptShare), runs);
        run_both(open(), compare_end);
        break;
      case Effort::kLasting: {
        search->Follow(sought.runs, compare_end, runs);
        ++round;
        const Clock::time_point lasting_end = std::min(compare_end, Clock::now() + std::chrono::milliseconds(most_ms));
        if (is_many()) {
          take_turn(turns.Next(), lasting_end);
          break;
        }
        if (!open().empty()) search->BeginWithKept(part(kKeptShare), runs);
        const auto counts_ms = std::chrono::milliseconds(most_ms / (counts_share() / kSearchShare * 3));
        search->RunCounts(open(), std::min(compare_end, Clock::now() + counts_ms), runs);
        // By turns: many runs at once, what begins with a machine at work, and what waits long or counts from power-on.
        take_turn(Way::kWide, lasting_end - std::chrono::milliseconds(most_ms / 2));
        take_turn(Way::kAtWork, Clock::now() + (lasting_end - Clock::now()) / 2);
        run_both(open(), lasting_end);
        break;
      }
    }
    std::vector<CellId> different;
    for (const auto& [cell, difference] : runs.difference_of) different.push_back(cell);
    return different;
  };
  const prove::diff::CompareResult result =
      prove::diff::CompareVersions(old_version, new_version, match,
                                   {.find_different = find_different,
                                    .is_sought = is_sought,
                                    .for_each_seen_state =
                                        [&search](prove::diff::Which which, const auto& visit) {
                                          if (search) search->ForEachSeenState(which, visit);
                                        },
                                    .for_each_seen_pair =
                                        [&search](const auto& visit) {
                                          if (search) search->ForEachSeenPair(visit);
                                        }},
                                   limits);
  Diff diff{.invariants = result.invariants, .changes_are_found = result.changes_are_found, .refusal = result.refusal};
  if (!diff.refusal.empty()) return diff;
  NameWhatOneVersionHas(result.one_sided, old_named.words, new_named.words, diff);
  NameOptionsOfSimulation(old_side, new_side, diff);
  NameMovedRetentive(old_version, new_version, match, old_named.words, diff);
  if (sliced) NameBookkeepingOfSlices(old_side, new_side, same, diff);
  DiffItem changes{.old_statements = ChangedStatements(old_side, new_side),
                   .new_statements = ChangedStatements(new_side, old_side)};
  if (std::max(changes.old_statements.size(), changes.new_statements.size()) <= kMostChangesShown)
    ShowChangedLines(old_side, new_side, changes);
  diff.old_statements = std::move(changes.old_statements);
  diff.new_statements = std::move(changes.new_statements);
  std::vector<Gathered> items = Gather(result, old_named, new_named);
  DropOrderOfCalls(items, old_version.cells.OfOrder());
  AddCauses(items, old_named, new_named);
  // Outputs first, and what changed itself: with many differences not every one gets a run of its own.
  std::ranges::stable_sort(
      items, {}, [](const Gathered& gathered) { return std::pair(gathered.item.kind, !gathered.item.changed_itself); });
  const auto is_shown = [](const Gathered& gathered) {
    const bool shown = gathered.item.verdict == ItemVerdict::kDifferent || gathered.worst->run.has_value();
    return shown && !gathered.old_cells.empty() && gathered.old_cells.size() == gathered.new_cells.size();
  };
  const Clock::time_point decided = Clock::now();
  const Clock::duration shortening = std::max<Clock::duration>(
      std::chrono::milliseconds(options.time_ms / kExampleShare), (last_end - decided) / kRestShare);
  const Clock::time_point end = std::min(last_end, decided + shortening);
  // A run that is known is shown, shortened or not, as long as there is a little time left.
  const Clock::time_point shown_end =
      std::min(last_end, end + std::chrono::milliseconds(options.time_ms / kExampleShare / 4));
  const Clock::time_point reused_end =
      std::min(last_end, shown_end + std::chrono::milliseconds(options.time_ms / kExampleShare / 4));
  auto waiting = std::ranges::count_if(items, is_shown);
  ExampleBudget budget{.left = kMostExamples,
                       .end = end,
                       .last_end = shown_end,
                       .all_end = last_end,
                       .old_program = scenarios::ScenarioProgram(old_side.compilation),
                       .new_program = scenarios::ScenarioProgram(new_side.compilation)};
  for (Gathered& gathered : items) {
    if (gathered.item.verdict == ItemVerdict::kEqual) {
      ++diff.equal;
      continue;
    }
    const Clock::time_point now = Clock::now();
    const CounterexampleRequest request{.old_version = old_version,
                                        .new_version = new_version,
                                        .old_words = old_named.words,
                                        .new_words = new_named.words,
                                        .name = gathered.item.name,
                                        .kind = gathered.item.kind,
                                        .old_cells = gathered.old_cells,
                                        .run = gathered.worst->run,
                                        .runs = runs,
                                        .match = match};
    std::optional<Counterexample>& example = gathered.item.counterexample;
    if (is_shown(gathered) && budget.left > 0 && now < shown_end) {
      // Each has its share, and what the ones before it left over.
      budget.end = now + std::max(Clock::duration::zero(), end - now) /
                             std::max<int64_t>(1, std::min<int64_t>(waiting--, budget.left));
      example = FindCounterexample(old_side, new_side, request, options, budget);
    }
    if (is_shown(gathered) && !example && budget.left > 0 && Clock::now() < reused_end) {
      example = FindAmongShown(old_side, new_side, request, options, budget);
    }
    const bool is_run = std::ranges::any_of(gathered.old_cells, is_seen);
    const bool is_comparable = !gathered.old_cells.empty() && gathered.old_cells.size() == gathered.new_cells.size();
    if (is_comparable) KeepWhatWasReplayed(gathered.item, is_run);
    diff.items.push_back(std::move(gathered.item));
  }
  if (!options.compiler.empty()) ConfirmCompiled(old_side, new_side, options, last_end, diff);
  if (!diff.not_compiled.empty())
    diff.not_looked_at.push_back("the runs were not repeated as generated code: " + diff.not_compiled);
  if (sliced) {
    // Too late, too: then it says that it is not decided.
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(whole_end - Clock::now());
    const auto rest_ms = static_cast<uint64_t>(std::max<int64_t>(1, rest.count()));
    CompareBetweenSlices(old_side, new_side, same, std::min(slices_ms, rest_ms), diff);
  }
  std::vector<DiffItem> declared = CompareDeclarations(old_side.compilation.program, new_side.compilation.program);
  std::ranges::move(declared, std::back_inserter(diff.items));
  std::ranges::stable_sort(diff.items, {}, &DiffItem::kind);
  return diff;
}

}  // namespace plcxx::review::diff
