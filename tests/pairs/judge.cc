#include "tests/pairs/judge.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <variant>

#include "tests/diff/both_simulated.h"
#include "tests/temporary_directory.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::pairs {
namespace {

namespace fs = std::filesystem;
using review::diff::Diff;
using review::diff::DiffItem;
using review::diff::DiffSide;
using review::diff::ItemVerdict;

void Write(const ProgramText& program, const fs::path& directory) {
  fs::create_directories(directory);
  for (const auto& [name, text] : program.files) std::ofstream(directory / name, std::ios::binary) << text;
  if (!program.scenario.empty()) std::ofstream(directory / "scenario.yaml", std::ios::binary) << program.scenario;
}

compilation::CompilationRequest RequestOf(const ProgramText& program, const fs::path& directory) {
  compilation::CompilationRequest request;
  request.sources = program.sources;
  request.base_directory = directory.string();
  request.dialect = program.dialect;
  request.options.assign(program.options.begin(), program.options.end());
  return request;
}

scenarios::TestOutcome OutcomeOf(const std::string& scenario, const compilation::CompilationRequest& request,
                                 const std::string& path) {
  const scenarios::ScenarioOrErrors parsed = scenarios::ParseScenario(path, scenario);
  if (!std::holds_alternative<scenarios::Scenario>(parsed)) return scenarios::TestOutcome::kUnusable;
  scenarios::ScenarioProgram program(request);
  return scenarios::TestScenario(std::get<scenarios::Scenario>(parsed), scenarios::SuiteOptions(), program)
      .test.outcome;
}

class Judged {
 public:
  Judged(const Pair& pair, const JudgeOptions& options) : pair_(pair), options_(options) {
    Write(pair.old_program, old_.path());
    ProgramText changed = pair.new_program;
    changed.scenario.clear();
    Write(changed, new_.path());
  }

  Tally Run(uint64_t seed) {
    DiffSide old_side = review::diff::MakeDiffSide("old", RequestOf(pair_.old_program, old_.path())),
             new_side = review::diff::MakeDiffSide("new", RequestOf(pair_.new_program, new_.path()));
    const auto is_usable = [](const DiffSide& side) { return side.compilation.ok() && side.compilation.has_program; };
    if (!is_usable(old_side) || !is_usable(new_side)) {
      tally_.not_compiled = 1;
      return tally_;
    }
    const review::diff::DiffOptions options{
        .same = {}, .time_ms = options_.time_ms, .scenario_directory = old_.path().string(), .progress = {}};
    const auto begin = std::chrono::steady_clock::now();
    const Diff diff = CompareSides(old_side, new_side, options);
    const auto ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin).count();
    tally_.longest_ms = static_cast<uint64_t>(ms);
    // Of what is refused nothing is claimed: no pair that was judged.
    if (!diff.refusal.empty()) {
      tally_.refused = 1;
      return tally_;
    }
    tally_.pairs = 1;
    tally_.alike = pair_.alike ? 1 : 0;
    tally_.late = tally_.longest_ms > options_.time_ms * 11 / 10 ? 1 : 0;
    tally_.claimed = diff.equal;
    tally_.without_difference = diff.items.empty() ? 1 : 0;
    for (const DiffItem& item : diff.items) Look(item);
    tally_.pairs_undecided = tally_.undecided != 0 ? 1 : 0;
    tally_.alike_undecided = pair_.alike ? tally_.pairs_undecided : 0;
    // Where a period or the number of slices is another one, the versions have no common time.
    const bool has_common_time = std::ranges::none_of(diff.items, [](const DiffItem& item) {
      return item.kind == review::diff::ItemKind::kSchedule && item.declared.has_value();
    });
    if (has_common_time) {
      Random random(0xA24BAED4963EE407 * (seed + 1));
      tally_.attacked = 1;
      const std::optional<std::string> seen =
          SeenToDiffer(old_side, new_side, diff, options, {.runs = options_.runs, .steps = options_.steps}, random);
      if (seen) Wrong("called equal, but " + *seen);
    }
    return tally_;
  }

 private:
  void Wrong(const std::string& what) { tally_.unsound.push_back(pair_.what + ": " + what); }

  void Look(const DiffItem& item) {
    if (item.verdict == ItemVerdict::kUndecided) ++tally_.undecided;
    if (item.verdict != ItemVerdict::kDifferent) return;
    ++tally_.different;
    // A fault names the statement by its text (docs/review.md), and a name in it is another one.
    const bool is_renamed_statement = item.name == "calls of fault" && pair_.renames;
    if (pair_.alike && !is_renamed_statement) {
      Wrong("alike by construction, but " + item.name + " is called different" +
            (item.counterexample ? ": " + item.counterexample->steps + ": " + item.counterexample->old_value + ", " +
                                       item.counterexample->new_value
             : item.declared ? ": " + item.declared->old_text + ", " + item.declared->new_text
                             : std::string()));
    }
    if (!item.counterexample || item.counterexample->scenario.empty()) return;
    const std::string path = old_.File("counterexample.yaml");
    const auto before = OutcomeOf(item.counterexample->scenario, RequestOf(pair_.old_program, old_.path()), path);
    const auto after = OutcomeOf(item.counterexample->scenario, RequestOf(pair_.new_program, new_.path()), path);
    ++tally_.replayed;
    if (before != scenarios::TestOutcome::kPassed || after != scenarios::TestOutcome::kFailed)
      Wrong("the scenario of " + item.name + " does not show it:\n" + item.counterexample->scenario);
  }

  const Pair& pair_;
  const JudgeOptions& options_;
  testing_support::TemporaryDirectory old_, new_;
  Tally tally_;
};

}  // namespace

void Add(Tally& sum, const Tally& other) {
  sum.pairs += other.pairs;
  sum.alike += other.alike;
  sum.not_compiled += other.not_compiled;
  sum.refused += other.refused;
  sum.without_difference += other.without_difference;
  sum.claimed += other.claimed;
  sum.attacked += other.attacked;
  sum.different += other.different;
  sum.replayed += other.replayed;
  sum.undecided += other.undecided;
  sum.pairs_undecided += other.pairs_undecided;
  sum.alike_undecided += other.alike_undecided;
  sum.late += other.late;
  sum.longest_ms = std::max(sum.longest_ms, other.longest_ms);
  sum.unsound.insert(sum.unsound.end(), other.unsound.begin(), other.unsound.end());
}

Pair PairOf(const std::string& dialect, uint64_t seed) {
  Random random(0x9FB21C651E98DF25 * (seed + 1) + dialect.size());
  if (Below(random, 5) < 2) {
    if (dialect == "hnc") return RandomHncPair(random);
    if (dialect == "classicladder") return RandomLadderPair(random, true);
    return Rewritten(RandomProgramText(dialect, random), random);
  }
  if (dialect == "classicladder" && !random.OneIn(4)) return RandomLadderPair(random, false);
  return Mutated(RandomProgramText(dialect, random), random);
}

Tally Judge(const Pair& pair, uint64_t seed, const JudgeOptions& options, const std::string& save) {
  if (pair.what.empty()) return {};
  Tally tally = Judged(pair, options).Run(seed);
  for (std::string& what : tally.unsound) what = pair.old_program.dialect + " " + std::to_string(seed) + ": " + what;
  if (!tally.unsound.empty() && !save.empty()) {
    const fs::path folder = fs::path(save) / (pair.old_program.dialect + "_" + std::to_string(seed));
    Write(pair.old_program, folder / "old");
    Write(pair.new_program, folder / "new");
    std::ofstream out(folder / "what.txt");
    for (const auto& [key, value] : pair.new_program.options) out << "--set " << key << "=" << value << "\n";
    for (const std::string& what : tally.unsound) out << what << "\n";
  }
  return tally;
}

std::string TableHead() {
  return "dialect       pairs  alike  equal locations  attacked  different  replayed  not decided  in pairs (alike)  "
         "late  "
         "longest ms  refused  unsound\n";
}

std::string TableRow(const std::string& dialect, const Tally& tally) {
  char row[256];
  std::snprintf(row, sizeof row, "%-13s %5ju %6ju %16ju %9ju %10ju %9ju %12ju %9ju (%5ju) %5ju %11ju %8ju %8zu\n",
                dialect.c_str(), uintmax_t{tally.pairs}, uintmax_t{tally.alike}, uintmax_t{tally.claimed},
                uintmax_t{tally.attacked}, uintmax_t{tally.different}, uintmax_t{tally.replayed},
                uintmax_t{tally.undecided}, uintmax_t{tally.pairs_undecided}, uintmax_t{tally.alike_undecided},
                uintmax_t{tally.late}, uintmax_t{tally.longest_ms}, uintmax_t{tally.refused}, tally.unsound.size());
  return row;
}

}  // namespace plcxx::pairs
