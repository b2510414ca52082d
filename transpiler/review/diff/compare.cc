// The comparison of two versions: cells in, items with names, causes and counterexamples out.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <utility>

#include "transpiler/dialects/statement_text.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/review/diff/causes.h"
#include "transpiler/review/diff/confirm.h"
#include "transpiler/review/diff/declared.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/examples.h"
#include "transpiler/review/diff/groups.h"
#include "transpiler/review/diff/left_out.h"
#include "transpiler/review/diff/named_items.h"
#include "transpiler/review/diff/run_searches.h"
#include "transpiler/review/diff/statements.h"

namespace plcxx::review::diff {
namespace {

constexpr size_t kMostChangesShown = 50;  // statements of which the line is sought that was changed
constexpr size_t kMostRangesOfReason = 6;
constexpr uint64_t kLastShare = 6;    // of the time: left for shorter runs, and for showing them
constexpr uint64_t kSlicesShare = 6;  // of the time, where the slow part is in slices: for what is seen between them

bool IsSliced(const ir::Program& program) {
  return std::ranges::any_of(program.routines, [](const ir::Routine& routine) { return routine.slices > 1; });
}

/// The comparison takes the slow part in one piece, so that moved cuts are no news. Here the programs are executed as
/// they run, slice by slice: an item for all that is not proved equal then, where it is so for whole passes.
/// `equal`: the names of what counts as equal so far.
void CompareBetweenSlices(const DiffSide& old_side, const DiffSide& new_side,
                          const std::vector<std::pair<ir::Place, ir::Place>>& same, uint64_t time_ms,
                          const std::set<std::string>& equal, Diff& diff) {
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
  for (const NamedItem& named : MakeItems(result, old_named, new_named)) {
    const DiffItem& item = named.item;
    const bool is_known = std::ranges::find(diff.items, item.name, &DiffItem::name) != diff.items.end();
    // What one version alone has to count its slices nobody sees.
    const bool is_seen = std::ranges::find(diff.of_slices, item.name) == diff.of_slices.end();
    if (item.verdict != ItemVerdict::kEqual && !is_known && is_seen) names.push_back(item.name);
  }
  if (names.empty()) return;
  for (const std::string& name : names) diff.equal -= equal.contains(name) ? 1 : 0;
  const std::string named = NamesAsRanges(names, kMostRangesOfReason) + (names.size() == 1 ? " is" : " are");
  diff.items.push_back({.name = "between slices",
                        .kind = ItemKind::kSchedule,
                        .verdict = ItemVerdict::kUndecided,
                        .through = names,
                        .reason = "executed slice by slice " + named +
                                  " not proved equal: ahead of the old version or behind it until a pass ends, or "
                                  "another one for good by what inputs and the fast part change between two slices"});
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

/// What no claim is made of, and what is news whatever the program does.
void NameLeftOut(const Named& old_named, const Named& new_named, const prove::diff::Match& match,
                 const prove::diff::CompareResult& result, const std::vector<std::pair<ir::Place, ir::Place>>& same,
                 Diff& diff) {
  for (const std::string& routine : result.changed_for_host)
    diff.not_looked_at.push_back("what " + routine + " does, which the host alone calls and which is another one");
  NameWhatOneVersionHas(result.one_sided, old_named.words, new_named.words, diff);
  NameOptionsOfSimulation(old_named.side, new_named.side, diff);
  NameMovedRetentive(old_named.version, new_named.version, match, old_named.words, diff);
  NameOtherNumbers(old_named.version, new_named.version, match, same, diff);
}

void NameChangedStatements(const DiffSide& old_side, const DiffSide& new_side, Diff& diff) {
  DiffItem changes{.old_statements = ChangedStatements(old_side, new_side),
                   .new_statements = ChangedStatements(new_side, old_side)};
  if (std::max(changes.old_statements.size(), changes.new_statements.size()) <= kMostChangesShown)
    ShowChangedLines(old_side, new_side, changes);
  diff.old_statements = std::move(changes.old_statements);
  diff.new_statements = std::move(changes.new_statements);
}

/// Outputs first, and what changed itself: with many differences not every one gets a run of its own.
std::vector<NamedItem> ItemsByWeight(const prove::diff::CompareResult& result, const Named& old_named,
                                     const Named& new_named) {
  std::vector<NamedItem> items = MakeItems(result, old_named, new_named);
  DropOrderOfCalls(items, old_named.version.cells);
  AddCauses(items, old_named, new_named);
  std::ranges::stable_sort(
      items, {}, [](const NamedItem& named) { return std::pair(named.item.kind, !named.item.changed_itself); });
  return items;
}

/// Gives the names of those that are equal.
std::set<std::string> MoveInto(std::vector<NamedItem> items, Diff& diff) {
  std::set<std::string> equal;
  for (NamedItem& named : items) {
    if (named.item.verdict == ItemVerdict::kEqual) {
      ++diff.equal;
      equal.insert(std::move(named.item.name));
    } else {
      diff.items.push_back(std::move(named.item));
    }
  }
  return equal;
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
  const bool sliced = IsSliced(old_side.compilation.program) || IsSliced(new_side.compilation.program);
  const uint64_t slices_ms = sliced ? options.time_ms / kSlicesShare : 0;
  const Clock::time_point last_end = whole_end - std::chrono::milliseconds(slices_ms);
  const Clock::time_point compare_begin = Clock::now();
  const Clock::time_point compare_end =
      std::max(compare_begin, last_end - std::chrono::milliseconds(options.time_ms / kLastShare));
  const auto compare_time = std::chrono::duration_cast<std::chrono::milliseconds>(compare_end - compare_begin);
  const Named old_named(old_side, old_version), new_named(new_side, new_version);
  RunSearches searches(old_named, new_named, match, options, begin, compare_end);
  const prove::diff::CompareResult result = prove::diff::CompareVersions(
      old_version, new_version, match, searches.Answers(),
      {.total_ms = static_cast<uint64_t>(compare_time.count()), .progress = options.progress});
  Diff diff{.invariants = result.invariants, .changes_are_found = result.changes_are_found, .refusal = result.refusal};
  if (!diff.refusal.empty()) return diff;
  NameLeftOut(old_named, new_named, match, result, same, diff);
  if (sliced) NameBookkeepingOfSlices(old_side, new_side, same, diff);
  NameChangedStatements(old_side, new_side, diff);
  std::vector<NamedItem> items = ItemsByWeight(result, old_named, new_named);
  AddExamples(old_side, new_side, old_named, new_named, match, searches.runs(), options, last_end, items);
  const std::set<std::string> equal = MoveInto(std::move(items), diff);
  if (!options.compiler.empty()) ConfirmCompiled(old_side, new_side, options, last_end, diff);
  if (!diff.not_compiled.empty())
    diff.not_looked_at.push_back("the runs were not repeated as generated code: " + diff.not_compiled);
  if (sliced) {
    // Too late, too: then it says that it is not decided.
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(whole_end - Clock::now());
    const auto rest_ms = static_cast<uint64_t>(std::max<int64_t>(1, rest.count()));
    CompareBetweenSlices(old_side, new_side, same, std::min(slices_ms, rest_ms), equal, diff);
  }
  std::vector<DiffItem> declared = CompareDeclarations(old_side.compilation.program, new_side.compilation.program);
  std::ranges::move(declared, std::back_inserter(diff.items));
  std::ranges::stable_sort(diff.items, {}, &DiffItem::kind);
  return diff;
}

}  // namespace plcxx::review::diff
